// SPDX-License-Identifier: MIT
//
// One layer alone.
#include "predicates/predicates.h"

int main() {
  const sinkmesh::Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, far{2, 2, 2};
  const bool signs_are_right = sinkmesh::orient3d(o, x, y, z) > 0 && sinkmesh::insphere(o, x, y, z, far) < 0;
  return signs_are_right ? 0 : 1;
}
