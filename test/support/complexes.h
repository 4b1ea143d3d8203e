// SPDX-License-Identifier: MIT
//
// Sets of simplices in both dimensions, in one typed test.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "test/support/simplex_sets.h"

namespace sinkmesh::test {

/// TYPED_TEST_SUITE(Suite, Dimensions, DimensionNames); in a test, TypeParam::value is Dim.
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
struct DimensionNames {
  template <class Dimension>
  static std::string GetName(int) {
    return std::to_string(Dimension::value) + "d";
  }
};

}  // namespace sinkmesh::test
