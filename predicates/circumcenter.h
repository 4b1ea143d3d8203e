// SPDX-License-Identifier: MIT
//
// The exactly computed circumcenter, rounded once [PS, 7].
#pragma once

#include "predicates/point.h"

namespace sinkmesh {

/// Circumcenter of a simplex of nonzero volume whose points passed the input gate: every coordinate is the
/// exact one rounded once, to nearest even, to a double on the gate's grid 2^-121. Independent of the order of
/// the corners. A center outside [-2, 2]^Dim is never a Steiner point: the result is then that of `false`.
/// @return whether the center lies in [-2, 2]^Dim; only then is `center` set.
bool circumcenter(const Corners<2>& s, Point2& center);
bool circumcenter(const Corners<3>& s, Point3& center);

}  // namespace sinkmesh
