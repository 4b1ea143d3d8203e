// SPDX-License-Identifier: MIT
//
// Integers of up to 4096 bits without allocation: the low-level functions of GMP on memory inside the object.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace sinkmesh::test {

/// A value like int, but that an overflow throws. Copies only the limbs in use.
class InlineInteger {
 public:
  static constexpr int kLimbs = 4096 / GMP_NUMB_BITS;

  InlineInteger() = default;  // 0
  explicit InlineInteger(std::int64_t x) : size_(x != 0), negative_(x < 0) {
    limb_[0] = x < 0 ? mp_limb_t{0} - static_cast<mp_limb_t>(x) : static_cast<mp_limb_t>(x);
  }
  InlineInteger(const InlineInteger& x) { *this = x; }
  InlineInteger& operator=(const InlineInteger& x) {
    std::copy_n(x.limb_, x.size_, limb_);
    size_ = x.size_;
    negative_ = x.negative_;
    return *this;
  }
  ~InlineInteger() = default;

  int sign() const { return size_ == 0 ? 0 : (negative_ ? -1 : 1); }

  friend InlineInteger operator-(InlineInteger x) {
    x.negative_ = !x.negative_;
    return x;
  }
  friend InlineInteger operator+(const InlineInteger& x, const InlineInteger& y) {
    return sum(x, y, y.negative_);
  }
  friend InlineInteger operator-(const InlineInteger& x, const InlineInteger& y) {
    return sum(x, y, !y.negative_);
  }

  friend InlineInteger operator*(const InlineInteger& x, const InlineInteger& y) {
    InlineInteger r;
    if (x.size_ == 0 || y.size_ == 0) return r;
    if (x.size_ + y.size_ > kLimbs) throw std::length_error("the integer does not fit");
    const auto& [longer, shorter] = x.size_ < y.size_ ? std::pair(&y, &x) : std::pair(&x, &y);
    const mp_limb_t top = mpn_mul(r.limb_, longer->limb_, longer->size_, shorter->limb_, shorter->size_);
    r.size_ = x.size_ + y.size_ - (top == 0 ? 1 : 0);
    r.negative_ = x.negative_ != y.negative_;
    return r;
  }

  InlineInteger shifted_left(std::size_t bits) const {
    InlineInteger r;
    if (size_ == 0) return r;
    const int limbs = static_cast<int>(bits / GMP_NUMB_BITS);
    const auto rest = static_cast<unsigned>(bits % GMP_NUMB_BITS);
    if (size_ + limbs + 1 > kLimbs) throw std::length_error("the integer does not fit");
    std::fill_n(r.limb_, limbs, mp_limb_t{0});
    std::copy_n(limb_, size_, r.limb_ + limbs);
    const mp_limb_t carry = rest == 0 ? 0 : mpn_lshift(r.limb_ + limbs, r.limb_ + limbs, size_, rest);
    r.size_ = size_ + limbs;
    r.negative_ = negative_;
    if (carry != 0) r.limb_[r.size_++] = carry;
    return r;
  }

 private:
  /// x + y, with another sign for y.
  static InlineInteger sum(const InlineInteger& x, const InlineInteger& y, bool y_negative) {
    InlineInteger r;
    const bool swap = x.size_ < y.size_;
    const InlineInteger& longer = swap ? y : x;
    const InlineInteger& shorter = swap ? x : y;
    r.negative_ = swap ? y_negative : x.negative_;
    r.size_ = longer.size_;
    if (shorter.size_ == 0) {
      std::copy_n(longer.limb_, longer.size_, r.limb_);
      return r;
    }
    if (x.negative_ == y_negative) {
      const mp_limb_t carry = mpn_add(r.limb_, longer.limb_, longer.size_, shorter.limb_, shorter.size_);
      if (carry != 0) {
        if (r.size_ == kLimbs) throw std::length_error("the integer does not fit");
        r.limb_[r.size_++] = carry;
      }
      return r;
    }
    if (longer.size_ == shorter.size_ && mpn_cmp(longer.limb_, shorter.limb_, longer.size_) < 0) {
      mpn_sub_n(r.limb_, shorter.limb_, longer.limb_, longer.size_);
      r.negative_ = !r.negative_;
    } else {
      mpn_sub(r.limb_, longer.limb_, longer.size_, shorter.limb_, shorter.size_);
    }
    while (r.size_ > 0 && r.limb_[r.size_ - 1] == 0) --r.size_;
    return r;
  }

  int size_ = 0;  // limbs in use, without leading zeros
  bool negative_ = false;
  mp_limb_t limb_[kLimbs];
};

}  // namespace sinkmesh::test
