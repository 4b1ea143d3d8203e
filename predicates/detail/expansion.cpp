// SPDX-License-Identifier: MIT
#include "predicates/detail/expansion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sinkmesh::detail {

Expansion::Expansion(TwoTerms x) {
  append(x.tail);
  append(x.head);
}

int Expansion::sign() const {
  if (terms_.empty()) return 0;
  return terms_.back() > 0 ? 1 : -1;
}

/// Fast-Expansion-Sum with zero elimination: keeps the terms strongly nonoverlapping [S97, Theorem 13].
Expansion Expansion::sum(const Expansion& a, const Expansion& b, double sign_of_b) {
  const std::size_t size = a.terms_.size() + b.terms_.size();
  Expansion result;
  if (size == 0) return result;
  result.terms_.reserve(size);
  std::size_t i = 0;
  std::size_t j = 0;
  const auto next_smallest = [&] {
    const bool from_a =
        j == b.terms_.size() || (i < a.terms_.size() && std::abs(a.terms_[i]) < std::abs(b.terms_[j]));
    return from_a ? a.terms_[i++] : sign_of_b * b.terms_[j++];
  };
  double carry = next_smallest();
  for (std::size_t n = 1; n < size; ++n) {
    const TwoTerms s = two_sum(carry, next_smallest());
    result.append(s.tail);
    carry = s.head;
  }
  result.append(carry);
  return result;
}

/// Scale-Expansion with zero elimination [S97, Theorem 19].
Expansion Expansion::scaled(double factor) const {
  Expansion result;
  if (terms_.empty() || factor == 0) return result;
  result.terms_.reserve(2 * terms_.size());
  const TwoTerms first = two_product(terms_[0], factor);
  result.append(first.tail);
  double carry = first.head;
  for (std::size_t i = 1; i < terms_.size(); ++i) {
    const TwoTerms product = two_product(terms_[i], factor);
    const TwoTerms low = two_sum(carry, product.tail);
    result.append(low.tail);
    const TwoTerms high = fast_two_sum(product.head, low.head);
    result.append(high.tail);
    carry = high.head;
  }
  result.append(carry);
  return result;
}

/// Fewest terms, nonadjacent [S97, Theorem 23]: one pass down gathers bits into the upper terms, one pass up
/// removes the overlaps it left.
void Expansion::compress() {
  if (terms_.size() < 2) return;
  std::vector<double>& t = terms_;
  std::size_t bottom = t.size() - 1;
  double carry = t.back();
  for (std::size_t i = t.size() - 1; i-- > 0;) {
    const TwoTerms s = fast_two_sum(carry, t[i]);
    if (s.tail != 0) {
      t[bottom--] = s.head;
      carry = s.tail;
    } else {
      carry = s.head;
    }
  }
  t[bottom] = carry;
  std::size_t top = 0;
  for (std::size_t i = bottom + 1; i < t.size(); ++i) {
    const TwoTerms s = fast_two_sum(t[i], carry);
    carry = s.head;
    if (s.tail != 0) t[top++] = s.tail;
  }
  t[top] = carry;
  t.resize(top + 1);
}

/// One scaled copy of the longer factor per term of the shorter. Compressing keeps the lengths near the number
/// of significant bits / 53, whatever the degree.
Expansion operator*(const Expansion& a, const Expansion& b) {
  const Expansion& longer = a.terms_.size() < b.terms_.size() ? b : a;
  const Expansion& shorter = a.terms_.size() < b.terms_.size() ? a : b;
  Expansion result;
  for (const double term : shorter.terms_) result = result + longer.scaled(term);
  result.compress();
  return result;
}

}  // namespace sinkmesh::detail
