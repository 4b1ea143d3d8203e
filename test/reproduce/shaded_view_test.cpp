// SPDX-License-Identifier: MIT
//
// Cuts and pictures, on cubes of which all is known.
#include "tools/reproduce/shaded_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/vector.h"
#include "predicates/error.h"
#include "tools/reproduce/model_views.h"

namespace sinkmesh::reproduce {
namespace {

// The cube [0, n]^3, each of its unit cubes cut into six tetrahedra around a diagonal.
Mesh3 cube_mesh(std::uint32_t n) {
  Mesh3 mesh;
  const auto id = [n](std::array<std::uint32_t, 3> p) { return (p[2] * (n + 1) + p[1]) * (n + 1) + p[0]; };
  for (std::uint32_t z = 0; z <= n; ++z) {
    for (std::uint32_t y = 0; y <= n; ++y) {
      for (std::uint32_t x = 0; x <= n; ++x) mesh.points.push_back({double(x), double(y), double(z)});
    }
  }
  for (std::uint32_t cube = 0; cube < n * n * n; ++cube) {
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      std::array<std::uint32_t, 3> p{cube % n, cube / n % n, cube / n / n};
      Mesh3::Simplex simplex{id(p)};
      for (std::size_t k = 0; k < 3; ++k) {
        ++p[axes[k]];
        simplex[k + 1] = id(p);
      }
      const bool odd = (axes[1] == (axes[0] + 2) % 3);
      if (odd) std::swap(simplex[2], simplex[3]);
      mesh.simplices.push_back(simplex);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return mesh;
}

Surface3 cube_surface(std::uint32_t n) {
  const Mesh3 mesh = cube_mesh(n);
  Surface3 surface{mesh.points, {}};
  for (const VisibleFace& face : visible_faces(mesh, std::vector<bool>(mesh.simplices.size(), true))) {
    surface.facets.push_back(face.corners);
  }
  return surface;
}

double covered_pixels(const Image& image) {
  double sum = 0;
  for (const Pixel& pixel : image.pixels) sum += pixel[3] / 255.0;
  return sum;
}

TEST(Cut, KeepsExactlyTheTetrahedraBehindThePlane) {
  const Mesh3 mesh = cube_mesh(4);
  for (const Cut& cut : {Cut{{1, 0, 0}, {2, 0, 0}}, Cut{{1, -2, 0.5}, {1, 1, 1}}, Cut{{0, 0, 1}, {0, 0, -1}},
                         Cut{{0, 0, 1}, {0, 0, 9}}}) {
    const std::vector<bool> kept = kept_simplices(mesh, cut);
    ASSERT_EQ(kept.size(), mesh.simplices.size());
    for (std::size_t s = 0; s < kept.size(); ++s) {
      double sum = 0;
      for (const std::uint32_t v : mesh.simplices[s]) sum += dot(cut.normal, mesh.points[v] - cut.through);
      // Centroids are multiples of 1/4 and never nearly on these planes.
      EXPECT_EQ(kept[s], sum <= 0);
    }
  }
  const std::vector<bool> half = kept_simplices(mesh, {{1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(std::count(half.begin(), half.end(), true), 6 * 32);
}

// Faces of what is kept are closed and oriented outward: by the divergence theorem they enclose its volume.
TEST(Cut, VisibleFacesEncloseWhatIsKept) {
  const Mesh3 mesh = cube_mesh(4);
  const std::vector<bool> kept = kept_simplices(mesh, {{1, -2, 0.5}, {1, 1, 1}});
  double volume = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const VisibleFace& face : visible_faces(mesh, kept)) {
    EXPECT_TRUE(kept[face.simplex]);
    const auto& [a, b, c] = face.corners;
    volume += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6;
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      ++edges[{p, q}];
      --edges[{q, p}];
    }
  }
  EXPECT_NEAR(volume, static_cast<double>(std::count(kept.begin(), kept.end(), true)) / 6, 1e-9);
  for (const auto& [edge, surplus] : edges) EXPECT_EQ(surplus, 0) << edge.first << ' ' << edge.second;
}

TEST(Cut, TellsTheCutFromTheSurface) {
  const Mesh3 mesh = cube_mesh(4);
  std::size_t on_cut = 0;
  for (const VisibleFace& face : visible_faces(mesh, kept_simplices(mesh, {{1, 0, 0}, {2, 0, 0}}))) {
    bool in_plane = true;
    for (const std::uint32_t v : face.corners) in_plane &= mesh.points[v][0] == 2;
    EXPECT_EQ(face.on_cut, in_plane);
    on_cut += face.on_cut ? 1 : 0;
  }
  EXPECT_EQ(on_cut, 2u * 16);
}

TEST(SurfaceView, OfACubeAlongItsDiagonalCoversAHexagon) {
  constexpr int kSize = 400;
  const Image image = surface_view(cube_surface(2), {{1, 1, 1}, {0, 0, 1}, 0}, kSize, kSize);
  // The hexagon is as high as two space diagonals' projections: side s, height 2 s, area 3/2 sqrt(3) s^2.
  const double side = (kSize - 16) / 2.0;
  const double area = 1.5 * std::sqrt(3.0) * side * side;
  EXPECT_NEAR(covered_pixels(image), area, 0.002 * area);
}

TEST(SurfaceView, OfACubeFromTheFrontCoversASquareOfOneColour) {
  const Image image = surface_view(cube_surface(1), {{0, 0, 1}, {0, 1, 0}, 25}, 216, 216);
  EXPECT_NEAR(covered_pixels(image), 200.0 * 200, 1);
  EXPECT_EQ(image.at(0, 0), (Pixel{0, 0, 0, 0}));
  EXPECT_EQ(image.at(60, 140)[3], 255);
}

TEST(CutView, ShowsRatiosOnTheCutAndNeutralColoursOnTheSurface) {
  const Mesh3 mesh = cube_mesh(4);
  const Cut cut{{1, 0, 0}, {2, 0, 0}};
  // r/l of these tetrahedra is sqrt(3)/2: good by one scale, of low quality by the other.
  const auto center = [&](const RatioScale& scale, const Point3& towards_eye) {
    const Image image = cut_view(mesh, cut, {towards_eye, {0, 0, 1}, 0}, scale, 200, 200);
    return image.at(113, 106);
  };
  const Pixel good = center({2, 20}, {1, 0, 0});
  EXPECT_GT(good[2], good[0] + 20);
  const Pixel bad = center({0.7, 1}, {1, 0, 0});
  EXPECT_GT(bad[0], bad[2] + 60);
  const Pixel behind = center({0.7, 1}, {-1, 0, 0});
  EXPECT_NEAR(behind[0], behind[2], 8);
}

TEST(CutView, IsDeterministic) {
  const Mesh3 mesh = cube_mesh(5);
  const Cut cut{{1, 2, 1}, {2, 2, 3}};
  const View view{{1, 2, 1}, {0, 0, 1}, 30};
  EXPECT_EQ(encode_png(cut_view(mesh, cut, view, {}, 150, 120)),
            encode_png(cut_view(mesh, cut, view, {}, 150, 120)));
}

TEST(CutView, RefusesACutThatKeepsNothing) {
  EXPECT_THROW(cut_view(cube_mesh(1), {{1, 0, 0}, {-5, 0, 0}}, {}, {}, 50, 50), InputError);
}

TEST(ModelViews, KnowTheModelsOfThePaper) {
  for (const char* model : {"cuboctahedron", "paraboloid", "star", "head"}) {
    EXPECT_GT(dot(cut_of(model).normal, cut_view_of(model).towards_eye), 0) << "the eye sees the cut";
    EXPECT_GT(picture_height(model, 900), 300);
    EXPECT_NO_THROW(view_of(model));
  }
  EXPECT_THROW(view_of("teapot"), InputError);
}

}  // namespace
}  // namespace sinkmesh::reproduce
