// SPDX-License-Identifier: MIT
//
// Line charts over the rounds of a refinement.
#pragma once

#include <string>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh::reproduce {

enum class AxisScale { linear, logarithmic };

/// One curve. Curves of the same colour and different dash belong together.
struct Curve {
  int colour;  ///< 0, 1 or 2
  bool dashed;
  std::vector<Point2> points;
};

struct Chart {
  std::string id;  ///< unique on the page
  std::string title;
  std::string description;  ///< for readers who do not see it
  std::string x_label;
  std::string y_label;
  AxisScale y_scale = AxisScale::linear;
  std::vector<std::string> colour_names;
  std::string solid_name;  ///< what a solid curve means; empty if all are
  std::string dashed_name;
  std::vector<Curve> curves;
  std::vector<Point2> paper;  ///< values that the paper prints, drawn as circles
};

/// An <svg>. On a logarithmic axis what is not positive is left out.
std::string draw(const Chart& chart);

/// Round numbers from low to high for an axis: at most about six of them.
std::vector<double> axis_ticks(double low, double high, AxisScale scale);

}  // namespace sinkmesh::reproduce
