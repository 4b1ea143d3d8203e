// SPDX-License-Identifier: MIT
#include "tools/program/flow_fields.h"

#include "refine/watershed.h"

namespace sinkmesh::program {

template <int Dim>
FlowCounts add_flow_fields(const Triangulation<Dim>& triangulation, Mesh<Dim>& mesh) {
  Flow<Dim> flow(triangulation);
  const Watersheds<Dim> watersheds = find_watersheds(flow);
  const std::vector<std::uint32_t> count = count_sinks(flow);
  FlowCounts counts{watersheds.sinks.size(), 0};
  typename Mesh<Dim>::Field watershed{"watershed", {}};
  typename Mesh<Dim>::Field sink{"sink", {}};
  typename Mesh<Dim>::Field sinks{"sinks", {}};
  for (const Simplex s : triangulation.complex().simplices()) {
    if (triangulation.complex().is_ghost(s)) continue;
    watershed.values.push_back(watersheds[s]);
    sink.values.push_back(flow.is_sink(s) ? watersheds[s] : -1);
    sinks.values.push_back(count[s.index()]);
    counts.to_omega_only += count[s.index()] == 0 ? 1 : 0;
  }
  for (auto* field : {&watershed, &sink, &sinks}) mesh.simplex_fields.push_back(std::move(*field));
  return counts;
}

template FlowCounts add_flow_fields(const Triangulation<2>&, Mesh<2>&);
template FlowCounts add_flow_fields(const Triangulation<3>&, Mesh<3>&);

}  // namespace sinkmesh::program
