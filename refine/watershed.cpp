// SPDX-License-Identifier: MIT
#include "refine/watershed.h"

#include "refine/steepest_order.h"

namespace sinkmesh {

// Backwards along the flow: a simplex is ready when the labels of all its successors are known. The flow has no
// cycle, so everything gets ready.
template <int Dim>
Watersheds<Dim> find_watersheds(Flow<Dim>& flow) {
  const Complex<Dim>& complex = flow.complex();
  Watersheds<Dim> result;
  result.label.assign(complex.num_slots(), Watersheds<Dim>::kOmega);
  std::vector<std::uint8_t> waiting_for(complex.num_slots(), 0);
  std::vector<Simplex> ready;
  for (const Simplex s : complex.simplices()) {
    for (int i = 0; i <= Dim; ++i) {
      waiting_for[s.index()] = static_cast<std::uint8_t>(
          waiting_for[s.index()] + (flow.crosses(Complex<Dim>::half_facet(s, i)) ? 1 : 0));
    }
    if (waiting_for[s.index()] != 0) continue;
    ready.push_back(s);
    if (complex.is_ghost(s)) continue;
    result.label[s.index()] = static_cast<std::int32_t>(result.sinks.size());
    result.sinks.push_back(s);
  }
  SteepestOrder<Dim> order;
  for (std::size_t next = 0; next < ready.size(); ++next) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet into = complex.mate(Complex<Dim>::half_facet(ready[next], i));
      const Simplex s = Complex<Dim>::simplex_of(into);
      if (!flow.crosses(into) || --waiting_for[s.index()] != 0) continue;
      std::vector<Simplex> successors = flow.successors(s);
      order.sort(complex, successors);
      std::int32_t& label = result.label[s.index()];
      while (label == Watersheds<Dim>::kOmega && !successors.empty()) {
        label = result[successors.back()];
        successors.pop_back();
      }
      ready.push_back(s);
    }
  }
  SINKMESH_ASSERT(ready.size() == complex.num_simplices());
  return result;
}

template <int Dim>
std::vector<std::uint32_t> count_sinks(Flow<Dim>& flow) {
  std::vector<std::uint32_t> count(flow.complex().num_slots(), 0);
  for (const Simplex sink : flow.sinks()) {
    for (const Simplex s : flow.ancestors({sink})) ++count[s.index()];
  }
  return count;
}

template <int Dim>
std::vector<HalfFacet> watershed_boundaries(const Complex<Dim>& complex, const Watersheds<Dim>& watersheds) {
  std::vector<HalfFacet> result;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    for (int i = 0; i <= Dim; ++i) {
      const Simplex t = complex.neighbor(s, i);
      if (watersheds[s] != watersheds[t] && (s < t || complex.is_ghost(t))) {
        result.push_back(Complex<Dim>::half_facet(s, i));
      }
    }
  }
  return result;
}

template Watersheds<2> find_watersheds(Flow<2>&);
template Watersheds<3> find_watersheds(Flow<3>&);
template std::vector<std::uint32_t> count_sinks(Flow<2>&);
template std::vector<std::uint32_t> count_sinks(Flow<3>&);
template std::vector<HalfFacet> watershed_boundaries(const Complex<2>&, const Watersheds<2>&);
template std::vector<HalfFacet> watershed_boundaries(const Complex<3>&, const Watersheds<3>&);

}  // namespace sinkmesh
