// SPDX-License-Identifier: MIT
//
// A growing array of trivially copyable records, aligned to cache lines, whose new elements are not
// initialised.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/detail/pages.h"

namespace sinkmesh::detail {

/// Unlike std::vector: growing a large array moves pages instead of copying them (see pages.h), so that the
/// peak of memory is the final size; resize() leaves new elements as they are; and data() is aligned to 64
/// bytes, so that a 32-byte record never straddles two lines.
template <class T>
class PodArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  PodArray() = default;
  PodArray(const PodArray& other) { assign(other); }
  PodArray(PodArray&& other) noexcept { swap(other); }
  PodArray& operator=(PodArray other) noexcept {
    swap(other);
    return *this;
  }
  ~PodArray() { release_pages(data_, capacity_ * sizeof(T)); }

  void swap(PodArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& back() { return data_[size_ - 1]; }

  void push_back(const T& value) {
    if (size_ == capacity_) {
      const T copy = value;
      grow(size_ + 1);
      data_[size_++] = copy;
    } else {
      data_[size_++] = value;
    }
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }

  /// New elements are not initialised.
  void resize(std::size_t size) {
    if (size > capacity_) grow(size);
    size_ = size;
  }
  void resize(std::size_t size, const T& value) {
    const std::size_t old = size_;
    resize(size);
    for (std::size_t i = old; i < size; ++i) data_[i] = value;
  }
  void reserve(std::size_t capacity) {
    if (capacity > capacity_) set_capacity(capacity);
  }

  /// Bytes held, used or not.
  std::size_t bytes() const { return capacity_ * sizeof(T); }

 private:
  void grow(std::size_t needed) {
    const std::size_t by_half = capacity_ + capacity_ / 2;
    set_capacity(needed > by_half ? (needed < 16 ? 16 : needed) : by_half);
  }
  void set_capacity(std::size_t capacity) {
    data_ =
        static_cast<T*>(resize_pages(data_, capacity_ * sizeof(T), capacity * sizeof(T), size_ * sizeof(T)));
    capacity_ = capacity;
  }
  void assign(const PodArray& other) {
    reserve(other.size_);
    if (other.size_ != 0) std::memcpy(data_, other.data_, other.size_ * sizeof(T));
    size_ = other.size_;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace sinkmesh::detail
