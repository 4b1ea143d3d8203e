// SPDX-License-Identifier: MIT
//
// What the library throws, and what it asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace sinkmesh {

/// The caller's input cannot be used: a coordinate that is not finite, an option out of range, a surface that
/// is not closed. Thrown at the border of the library, before anything is changed; the message names the index
/// and the value, and what to do about it.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Fewer than Dim+1 affinely independent points.
class DegenerateInput : public InputError {
 public:
  DegenerateInput(const std::string& what, int affine_dimension)
      : InputError(what), affine_dimension_(affine_dimension) {}

  /// 0: all points are equal; 1: all on a line; 2: all in a plane; -1: there is no point.
  int affine_dimension() const { return affine_dimension_; }

 private:
  int affine_dimension_;
};

/// A 32-bit index would overflow: the complex is too large for this build.
class CapacityError : public std::length_error {
 public:
  using std::length_error::length_error;
};

}  // namespace sinkmesh

/// A broken invariant is our bug. On in dev, sanitizer and stress builds (SINKMESH_CHECKED), off in release.
#ifdef SINKMESH_CHECKED
#include <cstdio>
#include <cstdlib>
#define SINKMESH_ASSERT(condition)                                                                       \
  ((condition) ? void(0)                                                                                 \
               : (std::fprintf(stderr, "%s:%d: broken invariant: %s\n", __FILE__, __LINE__, #condition), \
                  std::abort()))
#else
#define SINKMESH_ASSERT(condition) ((void)sizeof(!(condition)))
#endif
