// SPDX-License-Identifier: MIT
//
// Vector graphics: shapes in the units of the picture, looks by class name.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "predicates/point.h"
#include "tools/io/detail/text_writer.h"

namespace sinkmesh::reproduce {

/// From the world, whose y axis points up, to a rectangle of the picture, whose y axis points down: one scale
/// for both axes, the world in the middle.
class Frame {
 public:
  Frame(const Box<2>& world, const Box<2>& picture);

  Point2 operator()(const Point2& p) const { return {origin_[0] + scale_ * p[0], origin_[1] - scale_ * p[1]}; }
  /// Units of the picture per unit of the world.
  double scale() const { return scale_; }

 private:
  double scale_;
  Point2 origin_;  // of the world, in the picture
};

using Segment = std::pair<Point2, Point2>;

/// A circle has equal radii.
struct Ellipse {
  Point2 center;
  double rx;
  double ry;
};

enum class Anchor { start, middle, end };

/// Builds one <svg> element, for a page or as a file of its own. Everything in it is scoped by its id, because
/// style rules and ids of inline SVG are global to the page.
///
/// Colours are the custom properties --ink, --paper, --accent, --muted, --fill-1, --fill-2, --fill-3 of the
/// page; where the page has none, its own, for light and for dark mode. Classes with a meaning for every
///   figure: fills   fill-1 fill-2 fill-3 tint (of low quality)
///   lines   thin bold faint dashed flow
///   marks   dot (ink) mark (accent)
///   text    text small it (italic)
///   l0, l1, ... of a ramp, see use_ramp()
/// Coordinates are rounded to a hundredth of a unit.
class SvgCanvas {
 public:
  /// @param id     of the element, unique on the page.
  /// @param title, description  plain text, for readers who do not see the picture.
  SvgCanvas(std::string_view id, double width, double height, std::string_view title,
            std::string_view description);

  /// Defines the fills l0 (darkest) to l<count-1> (lightest).
  void use_ramp(int count);
  /// Another style rule, inside this picture.
  void rule(std::string_view selector, std::string_view declarations);

  void polygon(std::span<const Point2> corners, std::string_view classes);
  /// All as one shape; where they overlap it is still filled once.
  void polygons(std::span<const std::vector<Point2>> polygons, std::string_view classes);
  void segments(std::span<const Segment> segments, std::string_view classes);
  /// The union of the ellipses, as one shape. Its outline, if the class has a stroke, should be painted below
  /// the fill ("paint-order:stroke"): then only the outline of the union is seen.
  void ellipses(std::span<const Ellipse> ellipses, std::string_view classes);
  void circle(const Point2& center, double radius, std::string_view classes);
  void arrow(const Point2& from, const Point2& to, double head, std::string_view classes);
  void rectangle(const Box<2>& box, std::string_view classes);
  /// `words` may hold <tspan> elements; escape() the rest.
  void text(const Point2& at, std::string_view words, std::string_view classes, Anchor anchor = Anchor::start);

  /// A region for begin_clip(): a set of polygons.
  /// @return its number.
  int define_clip(std::span<const std::vector<Point2>> polygons);
  /// What follows is moved up by `lift`, and seen inside the region only, which moves with it.
  void begin_clip(int clip, double lift = 0);
  void end_clip();

  /// The whole element; leaves the canvas unusable.
  std::string take();

 private:
  SvgCanvas& number(double value);
  SvgCanvas& place(char command, const Point2& p);
  void path(std::span<const std::vector<Point2>> polygons);
  void visible_arc(const Ellipse& ellipse);
  void begin(std::string_view element, std::string_view classes);

  std::string id_;
  double width_;
  double height_;
  int num_clips_ = 0;
  io_detail::TextWriter head_;
  io_detail::TextWriter style_;
  io_detail::TextWriter body_;
};

std::string escape(std::string_view text);

/// What a colour or a line means.
struct LegendEntry {
  enum class Kind { area, line, dot };
  Kind kind;
  std::string classes;
  std::string words;
};
/// One row of entries, from `at` to the right.
void draw_legend(SvgCanvas& canvas, const Point2& at, std::span<const LegendEntry> entries);

/// A bar of `levels` colours of the ramp, named at its ends.
void draw_ramp(SvgCanvas& canvas, const Box<2>& box, int levels, std::string_view low, std::string_view high);

}  // namespace sinkmesh::reproduce
