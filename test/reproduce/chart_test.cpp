// SPDX-License-Identifier: MIT
#include "tools/reproduce/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "test/support/xml_check.h"

namespace sinkmesh::reproduce {
namespace {

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

Chart two_curves() {
  Chart chart;
  chart.id = "chart";
  chart.title = "A & B";
  chart.description = "Two curves.";
  chart.x_label = "round";
  chart.y_label = "triangles";
  chart.colour_names = {"all", "some"};
  chart.curves = {{0, false, {{0, 10}, {1, 20}, {2, 40}}}, {1, true, {{0, 5}, {1, 0}, {2, 7}}}};
  chart.paper = {{2, 30}};
  return chart;
}

TEST(AxisTicks, AreRoundNumbersAroundTheValues) {
  EXPECT_EQ(axis_ticks(0, 97, AxisScale::linear), (std::vector<double>{0, 20, 40, 60, 80, 100}));
  EXPECT_EQ(axis_ticks(0, 118633, AxisScale::linear), (std::vector<double>{0, 50000, 100000, 150000}));
  EXPECT_EQ(axis_ticks(0.58, 17.2, AxisScale::logarithmic), (std::vector<double>{0.5, 1, 2, 5, 10, 20}));
  EXPECT_EQ(axis_ticks(1, 65000, AxisScale::logarithmic),
            (std::vector<double>{1, 10, 100, 1000, 10000, 100000}));
}

TEST(AxisTicks, EncloseTheValues) {
  for (const double low : {0.0, 0.03, 1.0, 7.3}) {
    for (const double high : {8.0, 99.0, 12345.0, 1e6}) {
      for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
        if (scale == AxisScale::logarithmic && low == 0) continue;
        const std::vector<double> ticks = axis_ticks(low, high, scale);
        EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
        EXPECT_LE(ticks.front(), low);
        EXPECT_GE(ticks.back(), high * (1 - 1e-12));
        EXPECT_LE(ticks.size(), 13U);
        EXPECT_GE(ticks.size(), 2U);
      }
    }
  }
}

TEST(Chart, IsWellFormedAndDrawsEverySegmentAndEveryValueOfThePaper) {
  const std::string svg = draw(two_curves());
  EXPECT_EQ(test::xml_error(svg), "");
  EXPECT_EQ(occurrences(svg, "class=\"paper-value\""), 2U);  // the value, and the legend
  EXPECT_NE(svg.find("A &amp; B"), std::string::npos);
  const std::size_t at = svg.find("class=\"c0\" d=\"", svg.find("class=\"axis\""));
  ASSERT_NE(at, std::string::npos);
  const std::string curve = svg.substr(at, svg.find("/>", at) - at);
  EXPECT_EQ(occurrences(curve, "M"), 2U);
  EXPECT_EQ(draw(two_curves()), svg);
}

TEST(Chart, LeavesOutOfALogarithmicAxisWhatIsNotPositive) {
  Chart chart = two_curves();
  chart.y_scale = AxisScale::logarithmic;
  const std::string svg = draw(chart);
  EXPECT_EQ(test::xml_error(svg), "");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  // Both segments of the dashed curve meet the zero.
  EXPECT_EQ(svg.find("class=\"c1 circ\" d=", svg.find("class=\"axis\"")), std::string::npos);
}

}  // namespace
}  // namespace sinkmesh::reproduce
