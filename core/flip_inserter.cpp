// SPDX-License-Identifier: MIT
#include "core/flip_inserter.h"

namespace sinkmesh {

template <int Dim>
void FlipInserter<Dim>::insert(Complex<Dim>&, const Predicates<Dim>&, const Location<Dim>&, Vertex) {}

template class FlipInserter<2>;
template class FlipInserter<3>;

}  // namespace sinkmesh
