// SPDX-License-Identifier: MIT
#include "core/complex.h"

namespace sinkmesh {

template <int Dim>
Simplex Complex<Dim>::make_sphere(const std::array<Vertex, kCorners>& corners) {
  reserve(kCorners + 1);
  const Simplex solid = allocate();
  for (std::size_t i = 0; i < kCorners; ++i) records_[solid.index()].corner[i] = corners[i].slot();

  // Ghost i stands on facet i and sees its corners in the order that makes it positive towards points beyond:
  // as the solid sees them from outside in space, reversed in the plane, because infinity takes the last place.
  std::array<Simplex, kCorners> ghost;
  for (int i = 0; i < kCorners; ++i) {
    ghost[i] = allocate();
    Record& record = records_[ghost[i].index()];
    const std::array<Vertex, Dim> seen = facet(half_facet(solid, i));
    for (int k = 0; k < Dim; ++k) record.corner[k] = seen[Dim == 2 ? 1 - k : k].slot();
    record.corner[Dim] = Vertex::infinite().slot();
    set_mates(half_facet(solid, i), half_facet(ghost[i], Dim));
  }
  for (int i = 0; i < kCorners; ++i) {
    for (int j = 0; j < i; ++j) {
      set_mates(half_facet(ghost[i], index_of(ghost[i], corners[j])),
                half_facet(ghost[j], index_of(ghost[j], corners[i])));
    }
    set_incident(corners[i], solid);
  }
  set_incident(Vertex::infinite(), ghost[0]);
  return solid;
}

template <int Dim>
void Complex<Dim>::compact() {
  if (free_.empty()) return;
  detail::PodArray<std::uint32_t> new_index;
  new_index.resize(records_.size());
  std::uint32_t count = 0;
  for (std::uint32_t s = 0; s < records_.size(); ++s) {
    new_index[s] = count;
    if (records_[s].corner[0] != kDead) records_[count++] = records_[s];
  }
  records_.resize(count);
  free_.clear();
  for (Record& record : records_) {
    for (std::uint32_t& mate : record.mate) mate = new_index[mate / kCorners] * kCorners + mate % kCorners;
  }
  for (VertexRecord& vertex : vertices_) {
    if (vertex.incident != kNone) vertex.incident = new_index[vertex.incident];
  }
}

template class Complex<2>;
template class Complex<3>;

}  // namespace sinkmesh
