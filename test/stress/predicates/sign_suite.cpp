// SPDX-License-Identifier: MIT
#include "test/stress/predicates/sign_suite.h"

#include <memory>
#include <string>
#include <utility>

#include "test/stress/predicates/sign_check.h"

namespace sinkmesh::stress {
namespace {

using detail::Stage;

constexpr std::array<const char*, detail::kStages> kStageNames{
    "static", "local", "granularity", "box", "permanent", "integer64", "integer128", "expansion"};

/// Where the polynomial vanishes.
template <int Dim>
std::span<const Base> favourites(Orientation<Dim>) {
  static constexpr std::array kBases{Base::kFlat, Base::kFlatScales, Base::kSliver};
  return kBases;
}
template <int Dim>
std::span<const Base> favourites(InSphere<Dim>) {
  static constexpr std::array kBases{Base::kSpheres, Base::kPythagorean, Base::kGrid};
  return kBases;
}
template <int Dim>
std::span<const Base> favourites(Diametral<Dim>) {
  static constexpr std::array kBases{Base::kSpheres, Base::kPythagorean, Base::kGreatCircle, Base::kGrid};
  return kBases;
}
template <int Dim>
std::span<const Base> favourites(FacetNormals<Dim>) {
  static constexpr std::array kBases{Base::kGrid, Base::kBoxCorners};
  return kBases;
}
template <int Dim>
std::span<const Base> favourites(Orthogonality<Dim>) {
  static constexpr std::array kBases{Base::kSpheres};
  return kBases;
}

template <class P>
class SignSuite : public Suite {
 public:
  static constexpr int kDim = SignCheck<P>::kDim;

  explicit SignSuite(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return name_; }

  void generate(Random& random, Case& c) override {
    std::vector<Point<kDim>> points;
    c.set("regime", make_points<kDim>(P::kDegree, P::kPoints, favourites(P{}), random, points));
    c.set("choice", random());
    c.set_points<kDim>(points);
  }

  bool accepts(const Case& c) const override {
    if (c.rows.size() != P::kPoints) return false;
    for (const auto& row : c.rows) {
      if (row.size() != P::kDim) return false;
    }
    const auto points = c.points<kDim>();
    if (c.setting("regime") == kBeyond) return is_finite(points);
    return c.setting("regime") == kGated ? is_gated(points) : in_range(points, P::kDegree);
  }

  std::string check(const Case& c, Counters& counters) override {
    SignCheck<P> check(c.points<kDim>(), c.number_setting("choice"), counters);
    if (c.setting("regime") == kBeyond) {
      check.run_beyond();
    } else {
      check.run(c.setting("regime") == kGated);
    }
    return "";
  }

  std::vector<NamedCounter> counters() const override {
    std::vector<NamedCounter> result(kFirstOrderCounter + 1);
    for (std::size_t i = 0; i < detail::kStages; ++i) {
      const auto stage = static_cast<Stage>(i);
      result[raw_counter(stage)] = {std::string("raw-") + kStageNames[i], raw_floor(stage)};
      result[staged_counter(stage)] = {std::string("staged-") + kStageNames[i], staged_floor(stage)};
    }
    result[kFirstOrderCounter] = {"first-order", 0.05};
    return result;
  }

 private:
  static constexpr double kFloor = 0.001;
  static constexpr double kRareFloor = 0.00005;
  static constexpr bool kHasBoxes = requires(const Points<P>& p) { P::is_zero(p); };
  // A scalar product in the plane hardly ever needs many bits.
  static constexpr bool kIsScalarProduct = P::kDegree == 2 && !std::is_same_v<P, Orientation<kDim>>;

  static double raw_floor(Stage stage) {
    if (stage == Stage::kStatic || stage == Stage::kGranularity) return 0;
    if (stage == Stage::kExpansion) return kIsScalarProduct ? 0 : kFloor;
    if (stage == Stage::kBox) return kHasBoxes ? kFloor : 0;
    return stage == Stage::kInteger128 && kIsScalarProduct ? kRareFloor : kFloor;
  }
  static double staged_floor(Stage stage) {
    if (stage == Stage::kExpansion) return 0;  // the wide integers always answer
    if (stage == Stage::kBox) return kHasBoxes && kIsInSphere<P> ? kFloor : 0;  // of others the filters see it
    return stage == Stage::kInteger128 && kIsScalarProduct ? kRareFloor : kFloor;
  }

  std::string name_;
};

}  // namespace

Suites make_sign_suites() {
  Suites suites;
  const auto add = [&]<class P>(P, const char* name) {
    suites.push_back(std::make_unique<SignSuite<P>>(name));
  };
  add(Orientation<2>{}, "orient2d");
  add(Orientation<3>{}, "orient3d");
  add(InSphere<2>{}, "incircle");
  add(InSphere<3>{}, "insphere");
  add(Diametral<2>{}, "diametral2d");
  add(Diametral<3>{}, "diametral3d");
  add(FacetNormals<2>{}, "normals2d");
  add(FacetNormals<3>{}, "normals3d");
  add(Orthogonality<2>{}, "orthogonality2d");
  add(Orthogonality<3>{}, "orthogonality3d");
  return suites;
}

}  // namespace sinkmesh::stress
