// SPDX-License-Identifier: MIT
//
// Typed test suites over the plane and space.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace sinkmesh::test {

using PlaneAndSpace = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

struct DimensionName {
  template <class T>
  static std::string GetName(int) {
    return T::value == 2 ? "Plane" : "Space";
  }
};

}  // namespace sinkmesh::test
