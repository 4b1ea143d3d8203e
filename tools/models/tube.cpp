// SPDX-License-Identifier: MIT
#include "tools/models/tube.h"

#include "predicates/predicates.h"

namespace sinkmesh::models {
namespace {

// Uniform in [-1, 1); the same sequence everywhere, since the standard fixes the generator.
class Jitter {
 public:
  double operator()() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }

 private:
  std::mt19937_64 random_{20010211};
};

int segments_in_row(int segments, bool is_shifted, bool has_corners) {
  return is_shifted && has_corners && segments > 1 ? segments - 1 : segments;
}

// Parameters of the vertices of a piece in a row, both ends included.
std::vector<double> parameters(int segments, bool is_shifted, bool has_corners) {
  const int count = segments_in_row(segments, is_shifted, has_corners);
  std::vector<double> t = {0};
  for (int i = 1; i < count; ++i) t.push_back((i + (is_shifted && has_corners ? 0.5 : 0.0)) / segments);
  t.push_back(1);
  if (is_shifted && !has_corners) {
    for (double& x : t) x += 0.5 / segments;
  }
  return t;
}

// The vertices of one piece in one row, both ends included, and where they are when the piece is unrolled.
struct RowPiece {
  std::vector<std::uint32_t> ids;
  std::vector<Point2> unrolled;
};

// The Delaunay triangulation of the strip between two rows, unrolled.
void fill_strip(const RowPiece& low, const RowPiece& high, std::vector<Surface3::Facet>& facets) {
  std::size_t a = 0;
  std::size_t b = 0;
  while (a + 1 < low.ids.size() || b + 1 < high.ids.size()) {
    bool advance_low = b + 1 == high.ids.size();
    if (!advance_low && a + 1 < low.ids.size()) {
      advance_low = incircle(low.unrolled[a], low.unrolled[a + 1], high.unrolled[b], high.unrolled[b + 1]) < 0;
    }
    if (advance_low) {
      facets.push_back({low.ids[a], low.ids[a + 1], high.ids[b]});
      ++a;
    } else {
      facets.push_back({low.ids[a], high.ids[b + 1], high.ids[b]});
      ++b;
    }
  }
}

class TubeBuilder {
 public:
  TubeBuilder(const std::vector<SectionPiece>& section, bool has_corners, double height, int rows)
      : section_(section), has_corners_(has_corners), height_(height), rows_(rows) {}

  Tube build() {
    std::vector<RowPiece> below = add_row(0);
    tube_.bottom = loop(below);
    for (int j = 1; j <= rows_; ++j) {
      std::vector<RowPiece> row = add_row(j);
      for (std::size_t i = 0; i < row.size(); ++i) fill_strip(below[i], row[i], tube_.facets);
      below = std::move(row);
    }
    tube_.top = loop(below);
    return std::move(tube_);
  }

 private:
  std::vector<RowPiece> add_row(int j) {
    std::vector<RowPiece> row;
    for (const SectionPiece& piece : section_) row.push_back(add_piece(piece, j));
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::uint32_t end = row[(i + 1) % row.size()].ids.front();
      row[i].ids.push_back(end);
      row[i].unrolled.back()[1] = tube_.points[end][2];
    }
    return row;
  }

  RowPiece add_piece(const SectionPiece& piece, int j) {
    const bool is_end = j == 0 || j == rows_;
    const double step = height_ / rows_;
    RowPiece result;
    std::vector<double> t = parameters(piece.segments, j % 2 == 1, has_corners_);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const bool is_corner = has_corners_ && (i == 0 || i + 1 == t.size());
      const bool is_last = i + 1 == t.size();  // the first vertex of the next piece, or of this one again
      if (is_last && !has_corners_) {
        t[i] = t[0] + 1;
      } else if (!is_corner) {
        t[i] += (piece.shift_along + kTubeJitter * jitter_()) / piece.segments;
      }
      double z = j == rows_ ? height_ : j * step;
      if (!is_last && !is_end) z += step * (kTubeJitter * jitter_() + (is_corner ? 0 : piece.shift_up));
      result.unrolled.push_back({t[i] * piece.length, z});
      if (is_last) break;
      const Point2 p = piece.at(t[i], is_corner ? 0 : piece.roughness * jitter_());
      result.ids.push_back(static_cast<std::uint32_t>(tube_.points.size()));
      tube_.points.push_back({p[0], p[1], z});
    }
    return result;
  }

  static std::vector<std::uint32_t> loop(const std::vector<RowPiece>& row) {
    std::vector<std::uint32_t> ids;
    for (const RowPiece& piece : row) ids.insert(ids.end(), piece.ids.begin(), piece.ids.end() - 1);
    return ids;
  }

  const std::vector<SectionPiece>& section_;
  bool has_corners_;
  double height_;
  int rows_;
  Jitter jitter_;
  Tube tube_;
};

}  // namespace

Tube make_tube(const std::vector<SectionPiece>& section, bool has_corners, double height, int rows) {
  return TubeBuilder(section, has_corners, height, rows).build();
}

std::size_t tube_facets(const std::vector<SectionPiece>& section, bool has_corners, int rows) {
  int facets = 0;
  for (const SectionPiece& piece : section) {
    for (int j = 0; j <= rows; ++j) {
      facets += (j == 0 || j == rows ? 1 : 2) * segments_in_row(piece.segments, j % 2 == 1, has_corners);
    }
  }
  return static_cast<std::size_t>(facets);
}

}  // namespace sinkmesh::models
