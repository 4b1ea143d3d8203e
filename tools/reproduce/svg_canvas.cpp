// SPDX-License-Identifier: MIT
#include "tools/reproduce/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sinkmesh::reproduce {
namespace {

constexpr double kLargestRadius = 2e4;

struct Colour {
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};
// Fallbacks of the page's custom properties.
constexpr std::array<Colour, 7> kColours = {{{"ink", "#1d2733", "#e6eaee"},
                                             {"paper", "#ffffff", "#14181d"},
                                             {"accent", "#c2410c", "#ff8f52"},
                                             {"muted", "#64707d", "#9aa6b2"},
                                             {"fill-1", "#dfe8f1", "#25313e"},
                                             {"fill-2", "#a9c1da", "#3e5873"},
                                             {"fill-3", "#4d7aa8", "#7fa9d4"}}};

struct Rule {
  std::string_view selector;
  std::string_view declarations;
};
// --c-ink is --ink of the page, or the fallback.
constexpr std::array<Rule, 16> kRules = {{
    {".paper", "fill:var(--c-paper)"},
    {".fill-1", "fill:var(--c-fill-1)"},
    {".fill-2", "fill:var(--c-fill-2)"},
    {".fill-3", "fill:var(--c-fill-3)"},
    {".tint", "fill:var(--c-accent);fill-opacity:.3"},
    {".thin", "fill:none;stroke:var(--c-ink);stroke-width:1"},
    {".bold", "fill:none;stroke:var(--c-ink);stroke-width:2.6"},
    {".faint", "fill:none;stroke:var(--c-muted);stroke-width:.8"},
    {".dashed", "fill:none;stroke:var(--c-muted);stroke-width:1.4;stroke-dasharray:6 5"},
    {".flow", "fill:none;stroke:var(--c-accent);stroke-width:2.4"},
    {".dot", "fill:var(--c-ink);stroke:var(--c-paper);stroke-width:1"},
    {".mark", "fill:var(--c-accent);stroke:var(--c-paper);stroke-width:1"},
    {"text",
     "font-family:system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;font-size:20px;"
     "fill:var(--c-ink)"},
    {".small", "font-size:16px"},
    {".muted", "fill:var(--c-muted)"},
    {".it", "font-style:italic;font-family:'STIX Two Text',Cambria,'DejaVu Serif',Georgia,serif"},
}};

using Rgb = std::array<double, 3>;

std::string hex(const Rgb& colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const double channel : colour) {
    const auto value = static_cast<std::size_t>(std::lround(channel));
    text += kDigits[value / 16];
    text += kDigits[value % 16];
  }
  return text;
}

// Through three colours.
std::string ramp_colour(const std::array<Rgb, 3>& stops, double t) {
  const std::size_t k = t < 0.5 ? 0 : 1;
  const double u = 2 * t - static_cast<double>(k);
  Rgb colour;
  for (std::size_t c = 0; c < 3; ++c) colour[c] = (1 - u) * stops[k][c] + u * stops[k + 1][c];
  return hex(colour);
}
constexpr std::array<Rgb, 3> kLightRamp = {{{44, 86, 138}, {130, 178, 205}, {244, 247, 236}}};
constexpr std::array<Rgb, 3> kDarkRamp = {{{29, 56, 92}, {52, 105, 142}, {124, 172, 192}}};

double rounded(double value) {
  const double result = std::round(100 * value) / 100;
  return result == 0 ? 0 : result;  // no "-0"
}

}  // namespace

Frame::Frame(const Box<2>& world, const Box<2>& picture)
    : scale_(std::min((picture.high[0] - picture.low[0]) / (world.high[0] - world.low[0]),
                      (picture.high[1] - picture.low[1]) / (world.high[1] - world.low[1]))),
      origin_{(picture.low[0] + picture.high[0] - scale_ * (world.low[0] + world.high[0])) / 2,
              (picture.low[1] + picture.high[1] + scale_ * (world.low[1] + world.high[1])) / 2} {}

SvgCanvas::SvgCanvas(std::string_view id, double width, double height, std::string_view title,
                     std::string_view description)
    : id_(id), width_(width), height_(height) {
  head_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" id=\"" << id << "\" viewBox=\"0 0 " << width << ' '
        << height << "\" role=\"img\" aria-labelledby=\"" << id << "-title " << id << "-desc\"><title id=\""
        << id << "-title\">" << escape(title) << "</title><desc id=\"" << id << "-desc\">"
        << escape(description) << "</desc>\n<style>\n";
  std::string dark;
  std::string light;
  for (const Colour& c : kColours) {
    const std::string property = "--c-" + std::string(c.name) + ":var(--" + std::string(c.name) + ",";
    light += property + std::string(c.light) + ");";
    dark += property + std::string(c.dark) + ");";
  }
  style_ << '#' << id << '{' << light << "stroke-linecap:round;stroke-linejoin:round}\n"
         << "@media(prefers-color-scheme:dark){#" << id << '{' << dark << "}}\n";
  for (const Rule& r : kRules) rule(r.selector, r.declarations);
  rectangle({{0, 0}, {width, height}}, "paper");
}

void SvgCanvas::rule(std::string_view selector, std::string_view declarations) {
  style_ << '#' << id_ << ' ' << selector << '{' << declarations << "}\n";
}

void SvgCanvas::use_ramp(int count) {
  const auto write = [&](const std::array<Rgb, 3>& stops) {
    for (int k = 0; k < count; ++k) {
      const std::string colour = ramp_colour(stops, count > 1 ? static_cast<double>(k) / (count - 1) : 0);
      rule(fmt::format(".l{}", k), "fill:" + colour);
    }
  };
  write(kLightRamp);
  style_ << "@media(prefers-color-scheme:dark){\n";
  write(kDarkRamp);
  style_ << "}\n";
}

SvgCanvas& SvgCanvas::number(double value) {
  body_ << rounded(value);
  return *this;
}

SvgCanvas& SvgCanvas::place(char command, const Point2& p) {
  body_ << command << rounded(p[0]) << ' ' << rounded(p[1]);
  return *this;
}

void SvgCanvas::begin(std::string_view element, std::string_view classes) {
  body_ << '<' << element << " class=\"" << classes << '"';
}

void SvgCanvas::path(std::span<const std::vector<Point2>> polygons) {
  body_ << " d=\"";
  for (const std::vector<Point2>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) place(i == 0 ? 'M' : 'L', polygon[i]);
    body_ << 'z';
  }
  body_ << "\"/>\n";
}

void SvgCanvas::polygon(std::span<const Point2> corners, std::string_view classes) {
  const std::vector<Point2> one(corners.begin(), corners.end());
  polygons({&one, 1}, classes);
}

void SvgCanvas::polygons(std::span<const std::vector<Point2>> polygons, std::string_view classes) {
  if (polygons.empty()) return;
  begin("path", classes);
  path(polygons);
}

void SvgCanvas::segments(std::span<const Segment> segments, std::string_view classes) {
  if (segments.empty()) return;
  begin("path", classes);
  body_ << " d=\"";
  for (const auto& [p, q] : segments) place('M', p).place('L', q);
  body_ << "\"/>\n";
}

// Renderers compute with 32 bits. So of an ellipse that is huge only the part near the picture is drawn, as a
// polygon whose sides are less than a tenth of a unit off; and in the direction in which whole ones run.
void SvgCanvas::visible_arc(const Ellipse& e) {
  constexpr int kSteps = 128;
  const double reach = 2 * (width_ + height_);
  const auto at = [&](double angle, double shrink) {
    return Point2{e.center[0] + shrink * e.rx * std::cos(angle), e.center[1] + shrink * e.ry * std::sin(angle)};
  };
  const double towards = std::atan2((height_ / 2 - e.center[1]) / e.ry, (width_ / 2 - e.center[0]) / e.rx);
  const double radius = std::min(e.rx, e.ry);
  const double half = std::min(1.0, reach / radius);
  for (int k = 0; k <= kSteps; ++k) place(k == 0 ? 'M' : 'L', at(towards + half * (1 - 2.0 * k / kSteps), 1));
  const double shrink = std::max(0.5, 1 - reach / radius);
  place('L', at(towards - half, shrink)).place('L', at(towards + half, shrink));
  body_ << 'z';
}

void SvgCanvas::ellipses(std::span<const Ellipse> ellipses, std::string_view classes) {
  if (ellipses.empty()) return;
  begin("path", classes);
  body_ << " d=\"";
  for (const Ellipse& e : ellipses) {
    if (std::max(e.rx, e.ry) > kLargestRadius) {
      visible_arc(e);
      continue;
    }
    // Two half turns; all in the same direction, so that overlaps are filled.
    place('M', {e.center[0] - e.rx, e.center[1]});
    for (const double step : {2 * e.rx, -2 * e.rx}) {
      body_ << 'a' << rounded(e.rx) << ' ' << rounded(e.ry) << " 0 1 0 " << rounded(step) << " 0";
    }
    body_ << 'z';
  }
  body_ << "\"/>\n";
}

void SvgCanvas::circle(const Point2& center, double radius, std::string_view classes) {
  begin("circle", classes);
  body_ << " cx=\"" << rounded(center[0]) << "\" cy=\"" << rounded(center[1]) << "\" r=\"" << rounded(radius)
        << "\"/>\n";
}

void SvgCanvas::rectangle(const Box<2>& box, std::string_view classes) {
  const std::array<Point2, 4> corners = {
      {box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}}};
  polygon(corners, classes);
}

void SvgCanvas::arrow(const Point2& from, const Point2& to, double head, std::string_view classes) {
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  const Point2 u = {(to[0] - from[0]) / length * head, (to[1] - from[1]) / length * head};
  begin("path", classes);
  body_ << " d=\"";
  place('M', from).place('L', to);
  place('M', {to[0] - u[0] - 0.5 * u[1], to[1] - u[1] + 0.5 * u[0]}).place('L', to);
  place('L', {to[0] - u[0] + 0.5 * u[1], to[1] - u[1] - 0.5 * u[0]});
  body_ << "\"/>\n";
}

void SvgCanvas::text(const Point2& at, std::string_view words, std::string_view classes, Anchor anchor) {
  begin("text", classes);
  body_ << " x=\"" << rounded(at[0]) << "\" y=\"" << rounded(at[1]) << '"';
  if (anchor != Anchor::start) body_ << " text-anchor=\"" << (anchor == Anchor::end ? "end" : "middle") << '"';
  body_ << '>' << words << "</text>\n";
}

int SvgCanvas::define_clip(std::span<const std::vector<Point2>> polygons) {
  body_ << "<clipPath id=\"" << id_ << "-clip-" << ++num_clips_ << "\"><path";
  path(polygons);
  body_ << "</clipPath>\n";
  return num_clips_;
}

void SvgCanvas::begin_clip(int clip, double lift) {
  body_ << "<g clip-path=\"url(#" << id_ << "-clip-" << clip << ")\"";
  if (lift != 0) body_ << " transform=\"translate(0 " << rounded(-lift) << ")\"";
  body_ << ">\n";
}

void SvgCanvas::end_clip() { body_ << "</g>\n"; }

std::string SvgCanvas::take() {
  return head_.take() + style_.take() + "</style>\n" + body_.take() + "</svg>\n";
}

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace sinkmesh::reproduce
