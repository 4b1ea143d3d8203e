// SPDX-License-Identifier: MIT
#include "core/validation.h"

#include <cstdio>
#include <sstream>
#include <unordered_set>

#include "core/conflict.h"

namespace sinkmesh {
namespace {

template <int Dim>
class Validator {
 public:
  Validator(const Complex<Dim>& complex, const Predicates<Dim>& predicates)
      : complex_(complex), predicates_(predicates) {}

  ValidationReport run() {
    const auto slots = static_cast<std::uint32_t>(complex_.num_slots());
    sound_.assign(slots, false);
    for (std::uint32_t s = 0; s < slots; ++s) {
      if (complex_.is_alive(Simplex(s))) sound_[s] = check_corners(Simplex(s));
    }
    for (std::uint32_t s = 0; s < slots; ++s) {
      if (sound_[s]) check_mates(Simplex(s));
    }
    check_free_list();
    check_vertices();
    for (std::uint32_t s = 0; s < slots; ++s) {
      if (sound_[s]) check_volume(Simplex(s));
    }
    // The geometry of a facet needs both simplices, and the ghost rule a third one.
    if (report_.ok()) {
      for (const Simplex s : complex_.simplices()) check_facets(s);
    }
    return std::move(report_);
  }

 private:
  using Record = typename Complex<Dim>::Record;
  static constexpr std::uint32_t kCorners = Complex<Dim>::kCorners;

  template <class... Parts>
  void violated(const char* invariant, const Parts&... parts) {
    std::ostringstream message;
    (message << ... << parts);
    report_.violations.push_back({invariant, message.str()});
  }

  const Record& record(Simplex s) const { return complex_.records()[s.index()]; }

  std::string describe(Simplex s) const {
    std::ostringstream text;
    text << s << " (";
    for (int i = 0; i <= Dim; ++i) text << (i == 0 ? "" : " ") << complex_.corner(s, i);
    text << ")";
    if (!complex_.is_ghost(s)) {
      for (int i = 0; i <= Dim; ++i)
        text << "\n    " << complex_.corner(s, i) << " = " << hex(complex_.corner(s, i));
    }
    return text.str();
  }

  std::string hex(Vertex v) const {
    std::string text;
    for (const double x : complex_.point(v)) {
      char buffer[40];
      std::snprintf(buffer, sizeof buffer, "%s%a", text.empty() ? "" : " ", x);
      text += buffer;
    }
    return text;
  }

  // A mark does not touch the corners: the simplex is sound, and its neighbours are not to blame.
  bool check_corners(Simplex s) {
    bool ok = true;
    if (record(s).corner[0] & Complex<Dim>::kMark) violated("I5", s, " is still marked");
    const std::size_t limit = complex_.vertices().size();
    for (int i = 0; i <= Dim; ++i) {
      // Of the other corners no bit is a mark, though handles leave it out everywhere.
      const Vertex v =
          i == 0 ? complex_.corner(s, 0) : Vertex::at_slot(record(s).corner[static_cast<std::size_t>(i)]);
      if (v.slot() >= limit) {
        violated("I3", s, " has a corner that is no vertex: slot ", v.slot());
        return false;
      }
      if (v.is_infinite() && i != Dim) {
        violated("I3", s, " has infinity at corner ", i);
        ok = false;
      }
      for (int j = 0; j < i; ++j) {
        if (complex_.corner(s, j) == v) {
          violated("I3", s, " has ", v, " twice");
          ok = false;
        }
      }
    }
    return ok;
  }

  void check_mates(Simplex s) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      const HalfFacet m = complex_.mate(h);
      const Simplex t = Complex<Dim>::simplex_of(m);
      if (t.index() >= sound_.size() || !sound_[t.index()]) {
        violated("I1", "the mate of ", h, " belongs to no sound simplex: ", m);
      } else if (t == s || complex_.mate(m) != h) {
        violated("I1", "mate(mate(", h, ")) is ", complex_.mate(m), ", mate is ", m);
      } else if (!is_reversed(complex_.facet(h), complex_.facet(m))) {
        violated("I2", h, " of ", describe(s), " and its mate ", m, " of ", describe(t), " do not match");
      }
    }
  }

  static bool is_reversed(const std::array<Vertex, Dim>& f, const std::array<Vertex, Dim>& g) {
    // A cyclic shift keeps the orientation of a triangle, but not of an edge.
    for (std::size_t shift = Dim == 2 ? 1 : 0; shift < Dim; ++shift) {
      bool equal = true;
      for (std::size_t k = 0; k < Dim; ++k) equal = equal && f[k] == g[(shift + Dim - k) % Dim];
      if (equal) return true;
    }
    return false;
  }

  void check_free_list() {
    std::unordered_set<std::uint32_t> listed;
    for (const std::uint32_t s : complex_.free_slots()) {
      if (s >= complex_.num_slots() || complex_.is_alive(Simplex(s)) || !listed.insert(s).second) {
        violated("I1", "the free list holds ", Simplex(s), ", which is alive or listed twice");
      }
    }
    std::size_t alive = 0;
    for (std::uint32_t s = 0; s < complex_.num_slots(); ++s) alive += complex_.is_alive(Simplex(s)) ? 1 : 0;
    if (alive != complex_.num_simplices()) {
      violated("I1", alive, " simplices are alive, ", complex_.num_simplices(), " are counted");
    }
  }

  void check_vertices() {
    std::vector<bool> used(complex_.vertices().size(), false);
    for (std::uint32_t s = 0; s < sound_.size(); ++s) {
      if (!sound_[s]) continue;
      for (int i = 0; i <= Dim; ++i) used[complex_.corner(Simplex(s), i).slot()] = true;
    }
    for (std::uint32_t slot = 0; slot < used.size(); ++slot) {
      const Vertex v = Vertex::at_slot(slot);
      const Simplex s = complex_.incident_simplex(v);
      if (s.is_null() ? used[slot]
                      : s.index() >= sound_.size() || !sound_[s.index()] || complex_.index_of(s, v) < 0) {
        violated("I4", "incident_simplex(", v, ") is ", s);
      }
    }
  }

  void check_volume(Simplex s) {
    if (!complex_.is_ghost(s) && predicates_.orient(complex_.corners(s)) <= 0) {
      violated("D1", describe(s), " has no positive volume");
    }
  }

  void check_facets(Simplex s) {
    for (int i = 0; i <= Dim; ++i) {
      const Vertex apex = complex_.apex(complex_.mate(Complex<Dim>::half_facet(s, i)));
      if (!apex.is_infinite() && in_conflict(complex_, predicates_, s, complex_.point(apex))) {
        violated("D2", describe(s), " is in conflict with ", apex, " = ", hex(apex));
      }
    }
  }

  const Complex<Dim>& complex_;
  const Predicates<Dim>& predicates_;
  ValidationReport report_;
  std::vector<bool> sound_;
};

}  // namespace

std::size_t ValidationReport::count(const std::string& invariant) const {
  std::size_t n = 0;
  for (const Violation& violation : violations) n += violation.invariant == invariant ? 1 : 0;
  return n;
}

std::ostream& operator<<(std::ostream& out, const ValidationReport& report) {
  if (report.ok()) return out << "valid";
  for (const auto& [invariant, message] : report.violations) out << invariant << ": " << message << '\n';
  return out;
}

template <int Dim>
ValidationReport validate(const Complex<Dim>& complex, const Predicates<Dim>& predicates) {
  return Validator<Dim>(complex, predicates).run();
}

template <int Dim>
bool is_delaunay(const Complex<Dim>& complex, const Predicates<Dim>& predicates) {
  for (const Simplex s : complex.simplices()) {
    for (int i = 0; i <= Dim; ++i) {
      const Vertex apex = complex.apex(complex.mate(Complex<Dim>::half_facet(s, i)));
      if (!apex.is_infinite() && in_conflict(complex, predicates, s, complex.point(apex))) return false;
    }
  }
  return true;
}

template ValidationReport validate(const Complex<2>&, const Predicates<2>&);
template ValidationReport validate(const Complex<3>&, const Predicates<3>&);
template bool is_delaunay(const Complex<2>&, const Predicates<2>&);
template bool is_delaunay(const Complex<3>&, const Predicates<3>&);

}  // namespace sinkmesh
