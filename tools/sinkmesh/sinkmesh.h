// SPDX-License-Identifier: MIT
//
// All of sinkmesh:
//
//   #include <sinkmesh/sinkmesh.h>
//   auto surface = sinkmesh::read_surface("rotor.off");
//   sinkmesh::Mesh3 mesh = sinkmesh::refine(surface, {.max_ratio = 2.0});
//   sinkmesh::write_mesh("rotor.vtu", mesh);
#pragma once

#include "core/dual.h"                  // IWYU pragma: export
#include "core/triangulation.h"         // IWYU pragma: export
#include "predicates/predicates.h"      // IWYU pragma: export
#include "predicates/self_test.h"       // IWYU pragma: export
#include "refine/distance_functions.h"  // IWYU pragma: export
#include "refine/flow.h"                // IWYU pragma: export
#include "refine/flower.h"              // IWYU pragma: export
#include "refine/independence.h"        // IWYU pragma: export
#include "refine/mesh_check.h"          // IWYU pragma: export
#include "refine/refine.h"              // IWYU pragma: export
#include "refine/refiner.h"             // IWYU pragma: export
#include "refine/self_intersections.h"  // IWYU pragma: export
#include "refine/surface_check.h"       // IWYU pragma: export
#include "refine/watershed.h"           // IWYU pragma: export
#include "tools/io/read.h"              // IWYU pragma: export
#include "tools/io/write.h"             // IWYU pragma: export
