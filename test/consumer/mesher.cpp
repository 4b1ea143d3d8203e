// SPDX-License-Identifier: MIT
//
// The three lines of the README.
#include <sinkmesh/sinkmesh.h>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  auto surface = sinkmesh::read_surface(argv[1]);
  sinkmesh::Mesh3 mesh = sinkmesh::refine(surface, {.max_ratio = 2.0});
  sinkmesh::write_mesh(argv[2], mesh);
}
