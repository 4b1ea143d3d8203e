// SPDX-License-Identifier: MIT
//
// Independent checks of a complex, by invariant.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "core/complex.h"
#include "predicates/staged.h"

namespace sinkmesh {

/// What validate() found. Messages carry the numbers of the invariants in complex.h and triangulation.h.
struct ValidationReport {
  struct Violation {
    std::string invariant;  ///< "I1", "D2", ...
    std::string message;    ///< the handles involved, and coordinates as hexadecimal floats where they matter
  };
  std::vector<Violation> violations;

  bool ok() const { return violations.empty(); }
  /// How often an invariant is violated.
  std::size_t count(const std::string& invariant) const;
};
std::ostream& operator<<(std::ostream& out, const ValidationReport& report);

/// Lists every violation. Reads raw arrays with bounded loops, so that it works on a broken complex; geometry
/// is looked at only where the topology around it is sound. Linear.
template <int Dim>
ValidationReport validate(const Complex<Dim>& complex, const Predicates<Dim>& predicates);

/// Whether no simplex is in conflict with the apex of a neighbour. Requires a valid complex. Linear.
template <int Dim>
bool is_delaunay(const Complex<Dim>& complex, const Predicates<Dim>& predicates);

}  // namespace sinkmesh
