// SPDX-License-Identifier: MIT
#include "tools/reproduce/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/reproduce/svg_canvas.h"
#include "tools/text/numbers.h"

namespace sinkmesh::reproduce {
namespace {

constexpr double kWidth = 580;
constexpr double kHeight = 470;
constexpr Box<2> plot_area() {
  Box<2> box;
  box.low = {92, 130};
  box.high = {kWidth - 24, kHeight - 62};
  return box;
}

// "1,234,000" or "0.75".
std::string tick_text(double value) {
  if (value != std::floor(value)) return fmt::format("{:g}", value);
  return text::grouped(static_cast<std::uint64_t>(value));
}

class Axes {
 public:
  explicit Axes(const Chart& chart) : scale_(chart.y_scale) {
    const auto include = [this](const Point2& p) {
      if (scale_ == AxisScale::logarithmic && p[1] <= 0) return;
      data_.include(p);
    };
    for (const Curve& curve : chart.curves) std::for_each(curve.points.begin(), curve.points.end(), include);
    std::for_each(chart.paper.begin(), chart.paper.end(), include);
    if (data_.low[0] > data_.high[0]) data_.include({0, 1});
    if (scale_ == AxisScale::linear) data_.include({data_.low[0], 0});
    y_ticks_ = axis_ticks(data_.low[1], data_.high[1], scale_);
    data_.include({data_.low[0], y_ticks_.front()});
    data_.include({data_.low[0], y_ticks_.back()});
    if (data_.high[0] == data_.low[0]) data_.high[0] += 1;
    if (data_.high[1] == data_.low[1]) data_.high[1] += 1;
  }

  bool shows(const Point2& p) const { return scale_ == AxisScale::linear || p[1] > 0; }
  Point2 operator()(const Point2& p) const {
    const Box<2> area = plot_area();
    const double x = (p[0] - data_.low[0]) / (data_.high[0] - data_.low[0]);
    const double y = (height(p[1]) - height(data_.low[1])) / (height(data_.high[1]) - height(data_.low[1]));
    return {area.low[0] + x * (area.high[0] - area.low[0]), area.high[1] - y * (area.high[1] - area.low[1])};
  }

  std::vector<double> x_ticks() const { return axis_ticks(data_.low[0], data_.high[0], AxisScale::linear); }
  const std::vector<double>& y_ticks() const { return y_ticks_; }
  const Box<2>& data() const { return data_; }

 private:
  double height(double y) const { return scale_ == AxisScale::linear ? y : std::log(y); }

  AxisScale scale_;
  Box<2> data_;
  std::vector<double> y_ticks_;
};

void draw_axes(SvgCanvas& canvas, const Chart& chart, const Axes& axes) {
  const Box<2> area = plot_area();
  std::vector<Segment> grid;
  for (const double y : axes.y_ticks()) {
    const double at = axes({axes.data().low[0], y})[1];
    grid.push_back({{area.low[0], at}, {area.high[0], at}});
    canvas.text({area.low[0] - 10, at + 6}, tick_text(y), "small muted", Anchor::end);
  }
  canvas.segments(grid, "grid");
  std::vector<Segment> marks = {{{area.low[0], area.high[1]}, {area.high[0], area.high[1]}}};
  for (const double x : axes.x_ticks()) {
    if (x < axes.data().low[0] || x > axes.data().high[0] || x != std::floor(x)) continue;
    const double at = axes({x, axes.data().low[1]})[0];
    marks.push_back({{at, area.high[1]}, {at, area.high[1] + 6}});
    canvas.text({at, area.high[1] + 25}, tick_text(x), "small muted", Anchor::middle);
  }
  canvas.segments(marks, "axis");
  canvas.text({(area.low[0] + area.high[0]) / 2, kHeight - 14}, escape(chart.x_label), "small", Anchor::middle);
  canvas.text({16, area.low[1] - 16}, escape(chart.y_label), "small");
}

void draw_curves(SvgCanvas& canvas, const Chart& chart, const Axes& axes) {
  for (const Curve& curve : chart.curves) {
    std::vector<Segment> segments;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      if (!axes.shows(curve.points[i - 1]) || !axes.shows(curve.points[i])) continue;
      segments.push_back({axes(curve.points[i - 1]), axes(curve.points[i])});
    }
    canvas.segments(segments, fmt::format("c{}{}", curve.colour, curve.dashed ? " circ" : ""));
  }
  for (const Point2& p : chart.paper) canvas.circle(axes(p), 6, "paper-value");
}

void draw_legends(SvgCanvas& canvas, const Chart& chart) {
  std::vector<LegendEntry> entries;
  for (std::size_t k = 0; k < chart.colour_names.size(); ++k) {
    entries.push_back({LegendEntry::Kind::line, fmt::format("c{}", k), chart.colour_names[k]});
  }
  draw_legend(canvas, {16, 52}, entries);
  entries.clear();
  if (!chart.solid_name.empty()) {
    entries.push_back({LegendEntry::Kind::line, "kind", chart.solid_name});
    entries.push_back({LegendEntry::Kind::line, "kind circ", chart.dashed_name});
  }
  if (!chart.paper.empty()) entries.push_back({LegendEntry::Kind::dot, "paper-value", "the paper (sinks)"});
  draw_legend(canvas, {16, 78}, entries);
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, AxisScale scale) {
  std::vector<double> ticks;
  if (scale == AxisScale::logarithmic) {
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::ceil(std::log10(high)));
    for (int decade = first; decade <= last; ++decade) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        // Over many decades, only their ends.
        if (digit == 1 || (last - first <= 3 && decade < last)) ticks.push_back(digit * std::pow(10, decade));
      }
    }
    // One tick below and one above the values is enough.
    while (ticks.size() > 2 && ticks[1] <= low) ticks.erase(ticks.begin());
    while (ticks.size() > 2 && ticks[ticks.size() - 2] >= high) ticks.pop_back();
    return ticks;
  }
  const double rough = std::max(high - low, 1e-300) / 5;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  double step = decade;
  for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
    step = digit * decade;
    if (step >= rough) break;
  }
  const double first = std::floor(low / step);
  const double last = std::ceil(high / step);
  for (double k = first; k <= last; ++k) ticks.push_back(k * step);
  return ticks;
}

std::string draw(const Chart& chart) {
  SvgCanvas canvas(chart.id, kWidth, kHeight, chart.title, chart.description);
  canvas.rule(".grid", "fill:none;stroke:var(--c-muted);stroke-width:.6;stroke-opacity:.45");
  canvas.rule(".axis", "fill:none;stroke:var(--c-muted);stroke-width:1.2");
  canvas.rule(".c0", "fill:none;stroke:var(--c-accent);stroke-width:3");
  canvas.rule(".c1", "fill:none;stroke:var(--c-fill-3);stroke-width:3");
  canvas.rule(".c2", "fill:none;stroke:var(--c-ink);stroke-width:2.2");
  canvas.rule(".kind", "fill:none;stroke:var(--c-ink);stroke-width:2.4");
  canvas.rule(".circ", "stroke-dasharray:9 7;stroke-width:2.4");
  canvas.rule(".paper-value", "fill:var(--c-paper);stroke:var(--c-ink);stroke-width:2.2");
  canvas.text({16, 26}, escape(chart.title), "");
  draw_legends(canvas, chart);
  const Axes axes(chart);
  draw_axes(canvas, chart, axes);
  draw_curves(canvas, chart, axes);
  return canvas.take();
}

}  // namespace sinkmesh::reproduce
