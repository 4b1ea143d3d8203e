// SPDX-License-Identifier: MIT
#include "predicates/detail/expansion.h"

#include <algorithm>

namespace sinkmesh::detail {

// Grow-Expansion with elimination of zeros [S97, Theorem 10]: the parts stay nonoverlapping and increasing.
void Expansion::add(double a) {
  std::size_t kept = 0;
  double sum = a;
  for (const double part : parts_) {
    const Pair s = two_sum(sum, part);
    sum = s.high;
    if (s.low != 0) parts_[kept++] = s.low;
  }
  parts_.resize(kept);
  if (sum != 0) parts_.push_back(sum);
}

// Compress [S97, Theorem 23]: the same value in as few parts as possible, the largest a good approximation.
void Expansion::compress() {
  if (parts_.empty()) return;
  double high = parts_.back();
  std::size_t bottom = parts_.size() - 1;
  for (std::size_t i = parts_.size() - 1; i-- > 0;) {
    const Pair s = fast_two_sum(high, parts_[i]);
    if (s.low != 0) {
      parts_[bottom--] = s.high;
      high = s.low;
    } else {
      high = s.high;
    }
  }
  parts_[bottom] = high;
  std::size_t top = 0;
  for (std::size_t i = bottom + 1; i < parts_.size(); ++i) {
    const Pair s = fast_two_sum(parts_[i], high);
    if (s.low != 0) parts_[top++] = s.low;
    high = s.high;
  }
  parts_[top] = high;
  parts_.resize(high != 0 ? top + 1 : top);
}

Expansion operator+(const Expansion& a, const Expansion& b) {
  Expansion sum = a;
  for (const double part : b.parts_) sum.add(part);
  sum.compress();
  return sum;
}

Expansion operator*(const Expansion& a, const Expansion& b) {
  Expansion product;
  for (const double x : a.parts_) {
    for (const double y : b.parts_) {
      const Pair p = two_product(x, y);
      product.add(p.low);
      product.add(p.high);
    }
    product.compress();
  }
  return product;
}

}  // namespace sinkmesh::detail
