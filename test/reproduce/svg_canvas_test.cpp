// SPDX-License-Identifier: MIT
#include "tools/reproduce/svg_canvas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "test/support/xml_check.h"

namespace sinkmesh::reproduce {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SvgCanvas, FrameFitsTheWorldAndTurnsItsAxisDown) {
  const Frame frame({{0, 0}, {2, 1}}, {{10, 10}, {110, 110}});
  EXPECT_EQ(frame.scale(), 50);
  EXPECT_EQ(frame({0, 0}), (Point2{10, 85}));
  EXPECT_EQ(frame({2, 1}), (Point2{110, 35}));
}

TEST(SvgCanvas, EscapesWordsAndRoundsCoordinates) {
  SvgCanvas canvas("x", 100, 100, "a < b & \"c\"", "r/l > 1");
  canvas.circle({1.0 / 3, -1e-9}, 2, "dot");
  const std::string svg = canvas.take();
  EXPECT_EQ(test::xml_error(svg), "");
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(svg, HasSubstr("cx=\"0.33\" cy=\"0\" r=\"2\""));
}

TEST(SvgCanvas, ClipsHaveNamesOfTheirOwn) {
  SvgCanvas canvas("x", 100, 100, "", "");
  const std::vector<std::vector<Point2>> region = {{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(canvas.define_clip(region), 1);
  EXPECT_EQ(canvas.define_clip(region), 2);
  canvas.begin_clip(2, 5);
  canvas.end_clip();
  const std::string svg = canvas.take();
  EXPECT_EQ(test::xml_error(svg), "");
  EXPECT_THAT(svg, HasSubstr("<g clip-path=\"url(#x-clip-2)\" transform=\"translate(0 -5)\">"));
}

// A disc whose rim goes through the middle of the picture, from below.
TEST(SvgCanvas, HugeDiscsAreDrawnNearThePictureOnly) {
  constexpr double kRadius = 1e9;
  SvgCanvas canvas("x", 100, 100, "", "");
  const Ellipse disc = {{50, 50 + kRadius}, kRadius, kRadius};
  canvas.ellipses({&disc, 1}, "fill-1");
  const std::string svg = canvas.take();
  const std::size_t begin = svg.find("class=\"fill-1\" d=\"M");
  ASSERT_NE(begin, std::string::npos);
  std::string path = svg.substr(begin + 18);
  path = path.substr(0, path.find('z'));
  EXPECT_THAT(path, Not(HasSubstr("a")));
  for (char& c : path) {
    if (c == 'M' || c == 'L') c = ' ';
  }
  std::istringstream numbers(path);
  double low = HUGE_VAL;
  double twice_area = 0;
  std::vector<Point2> corners;
  for (Point2 p{}; numbers >> p[0] >> p[1];) corners.push_back(p);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& p = corners[i];
    const Point2& q = corners[(i + 1) % corners.size()];
    twice_area += p[0] * q[1] - p[1] * q[0];
    low = std::min(low, p[1]);
    EXPECT_LT(std::abs(p[0]) + std::abs(p[1]), 2000);
  }
  EXPECT_NEAR(low, 50, 0.1);
  // As whole discs, which run M left, down, right: counterclockwise as seen, a negative area with y down.
  EXPECT_LT(twice_area, -4e4);
}

}  // namespace
}  // namespace sinkmesh::reproduce
