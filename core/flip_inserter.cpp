// SPDX-License-Identifier: MIT
#include "core/flip_inserter.h"

#include <algorithm>

#include "core/conflict.h"

namespace sinkmesh {
namespace {

constexpr int kStampBits = 24;  // the rest of the scratch word is the star linker's

}  // namespace

template <int Dim>
void FlipInserter<Dim>::insert(Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               const Location<Dim>& at, Vertex v) {
  complex_ = &complex;
  predicates_ = &predicates;
  v_ = v;
  stamp_ = complex.fresh_stamp(kStampBits);
  stack_.clear();
  subdivide(at);
  while (!stack_.empty()) {
    const Simplex t = stack_.back();
    stack_.pop_back();
    // The slot may have been given to another simplex of the star since: its link facet is as good.
    if (complex.is_alive(t) && complex.index_of(t, v) >= 0) flip_link_facet(t);
  }
}

// Replaces each simplex that has the face of v's support by those with v for one of its corners: 1-4, 2-6 or
// n-2n, in the plane 1-3 or 2-4. Beyond the hull the face is the whole ghost.
template <int Dim>
void FlipInserter<Dim>::subdivide(const Location<Dim>& at) {
  std::vector<Vertex> face;
  for (int i = 0; i <= Dim; ++i) {
    if (at.support() == 0 || at.sign[static_cast<std::size_t>(i)] != 0) {
      face.push_back(complex_->corner(at.simplex, i));
    }
  }
  const auto is_in_face = [&](Vertex w) { return std::find(face.begin(), face.end(), w) != face.end(); };

  // The simplices around the face, each from a neighbour across a facet that holds it.
  old_.assign(1, at.simplex);
  for (std::size_t next = 0; next < old_.size(); ++next) {
    const Simplex s = old_[next];
    for (int i = 0; i <= Dim; ++i) {
      if (is_in_face(complex_->corner(s, i))) continue;
      const Simplex t = complex_->neighbor(s, i);
      if (std::find(old_.begin(), old_.end(), t) == old_.end()) old_.push_back(t);
    }
  }
  fresh_.clear();
  for (const Simplex s : old_) {
    for (const Vertex w : face) add_with_replaced(s, w);
  }
  ++counts_.subdivisions;
  replace();
}

template <int Dim>
void FlipInserter<Dim>::add_with_replaced(Simplex s, Vertex replaced) {
  std::array<Vertex, Dim + 1> corners;
  for (int i = 0; i <= Dim; ++i) corners[static_cast<std::size_t>(i)] = complex_->corner(s, i);
  *std::find(corners.begin(), corners.end(), replaced) = v_;
  fresh_.push_back(corners);
}

// Makes the change, marks the new neighbours of v, and puts the new link facets on the stack.
template <int Dim>
void FlipInserter<Dim>::replace() {
  for (const Simplex s : retriangulator_.replace(*complex_, old_, fresh_)) {
    for (int i = 0; i <= Dim; ++i) {
      complex_->vertices()[complex_->corner(s, i).slot()].scratch = stamp_ << (32 - kStampBits);
    }
    stack_.push_back(s);
  }
}

template <int Dim>
void FlipInserter<Dim>::flip_link_facet(Simplex t) {
  const Simplex sigma = complex_->neighbor(t, complex_->index_of(t, v_));
  const Point<Dim>& p = complex_->point(v_);
  if (!complex_->is_ghost(sigma)) {
    if (predicates_->in_sphere(complex_->corners(sigma), p) > 0) flip_solid(sigma);
    return;
  }
  const int side = predicates_->orient(corners_towards(*complex_, sigma, p));
  if (side > 0) {
    flip_ghost(sigma);
  } else if (side == 0) {
    // In the plane of a hull facet the solid neighbour decides; the flip is 4-4 with the ghost on its other
    // side.
    const Simplex solid = complex_->neighbor(sigma, Dim);
    if (predicates_->in_sphere(complex_->corners(solid), p) > 0) flip_solid(solid);
  }
}

template <int Dim>
bool FlipInserter<Dim>::is_behind_link_facet(Simplex s, int corner) const {
  return complex_->index_of(complex_->neighbor(s, corner), v_) >= 0;
}

template <int Dim>
void FlipInserter<Dim>::flip_solid(Simplex sigma) {
  CornerSet negative{};
  CornerSet positive{};
  const Corners<Dim> corners = complex_->corners(sigma);
  for (std::size_t i = 0; i <= Dim; ++i) {
    Corners<Dim> seen = corners;
    seen[i] = &complex_->point(v_);
    const int sign = predicates_->orient(seen);
    negative[i] = sign < 0;
    positive[i] = sign > 0;
  }
  flip(sigma, negative, positive);
}

// v lies strictly beyond the hull facet of sigma. What counts as negative is decided by topology: the corners
// whose opposite facets are link facets. A single one that is adjacent to v already must wait: joining now
// would pinch the visible part of the hull. Waiting does not block: every partial shelling of a disc extends
// [PS, 3].
template <int Dim>
void FlipInserter<Dim>::flip_ghost(Simplex sigma) {
  CornerSet negative{};
  CornerSet positive{};
  int count = 0;
  bool is_adjacent = false;
  for (int i = 0; i <= Dim; ++i) {
    const auto k = static_cast<std::size_t>(i);
    negative[k] = i != Dim && is_behind_link_facet(sigma, i);
    positive[k] = !negative[k];
    if (!negative[k]) continue;
    ++count;
    const Vertex w = complex_->corner(sigma, i);
    is_adjacent = complex_->vertices()[w.slot()].scratch >> (32 - kStampBits) == stamp_;
  }
  if (count == 1 && is_adjacent) return;
  flip(sigma, negative, positive);
}

// Makes the flip if all simplices that must go are there; else a later one will, from another link facet.
template <int Dim>
void FlipInserter<Dim>::flip(Simplex sigma, const CornerSet& negative, const CornerSet& positive) {
  const auto num_negative = std::count(negative.begin(), negative.end(), true);
  const auto num_positive = std::count(positive.begin(), positive.end(), true);
  const auto num_zero = Dim + 1 - num_negative - num_positive;
  if (num_negative == 0 || num_positive < 2 || num_zero > Dim - 2) return;

  // With a zero corner y: the simplices on the other side of the facet opposite y.
  std::array<Simplex, 2> sides = {sigma, Simplex()};
  for (int i = 0; i <= Dim; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!negative[k] && !positive[k]) sides[1] = complex_->neighbor(sigma, i);
  }
  old_.clear();
  fresh_.clear();
  for (const Simplex side : sides) {
    if (side.is_null()) continue;
    old_.push_back(side);
    for (int i = 0; i <= Dim; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vertex w = complex_->corner(sigma, i);
      if (negative[k]) {
        const int corner = complex_->index_of(side, w);
        if (!is_behind_link_facet(side, corner)) return;
        old_.push_back(complex_->neighbor(side, corner));
      } else if (positive[k]) {
        add_with_replaced(side, w);
      }
    }
  }
  if (num_zero != 0) {
    ++counts_.four_to_four;
  } else if (num_negative == 2) {
    ++counts_.three_to_two;
  } else {
    ++(Dim == 2 ? counts_.two_to_two : counts_.two_to_three);
  }
  replace();
}

template class FlipInserter<2>;
template class FlipInserter<3>;

}  // namespace sinkmesh
