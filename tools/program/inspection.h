// SPDX-License-Identifier: MIT
//
// What `inspect` says about one surface or mesh.
#pragma once

#include "refine/mesh.h"
#include "refine/surface.h"
#include "tools/io/read.h"
#include "tools/program/report.h"
#include "tools/program/summary.h"

namespace sinkmesh::program {

struct Inspection {
  Summary summary;
  Json report = begin_report("inspect");
  bool has_defects = false;
};

template <int Dim>
void inspect_surface(const Surface<Dim>& surface, const SourceLines& lines, double max_ratio,
                     Inspection& inspection);

template <int Dim>
void inspect_mesh(const Mesh<Dim>& mesh, double max_ratio, Inspection& inspection);

}  // namespace sinkmesh::program
