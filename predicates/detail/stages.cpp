// SPDX-License-Identifier: MIT
#include "predicates/detail/stages.h"

namespace sinkmesh::detail {

template Verdict exact_sign<Orient2d>(const Orient2d::Points&, double);
template Verdict exact_sign<Orient3d>(const Orient3d::Points&, double);
template Verdict exact_sign<Incircle>(const Incircle::Points&, double);
template Verdict exact_sign<Insphere>(const Insphere::Points&, double);
template Verdict exact_sign<DiametralCircle>(const DiametralCircle::Points&, double);
template Verdict exact_sign<DiametralSphere>(const DiametralSphere::Points&, double);
template Verdict exact_sign<FacetNormals>(const FacetNormals::Points&, double);
template Verdict exact_sign<Orthogonality<2>>(const Orthogonality<2>::Points&, double);
template Verdict exact_sign<Orthogonality<3>>(const Orthogonality<3>::Points&, double);

}  // namespace sinkmesh::detail
