// SPDX-License-Identifier: MIT
#include <string>

#include "tools/reproduce/svg_canvas.h"

#include <fmt/format.h>

namespace sinkmesh::reproduce {
namespace {

constexpr double kTextSize = 20;  // of the style sheet of SvgCanvas

}  // namespace

void draw_legend(SvgCanvas& canvas, const Point2& at, std::span<const LegendEntry> entries) {
  constexpr double kSwatch = 26;
  double x = at[0];
  for (const LegendEntry& entry : entries) {
    const double y = at[1] - 0.32 * kTextSize;
    switch (entry.kind) {
      case LegendEntry::Kind::area:
        canvas.rectangle({{x, y - 9}, {x + kSwatch, y + 9}}, entry.classes);
        break;
      case LegendEntry::Kind::line: {
        const Segment segment = {{x, y}, {x + kSwatch, y}};
        canvas.segments({&segment, 1}, entry.classes);
        break;
      }
      case LegendEntry::Kind::dot:
        canvas.circle({x + kSwatch / 2, y}, 5.5, entry.classes);
        break;
    }
    canvas.text({x + kSwatch + 9, at[1]}, escape(entry.words), "text");
    // A wide estimate of the width of the words; bytes, but letters beyond ASCII are rare.
    x += kSwatch + 9 + 0.53 * kTextSize * static_cast<double>(entry.words.size()) + 24;
  }
}

void draw_ramp(SvgCanvas& canvas, const Box<2>& box, int levels, std::string_view low, std::string_view high) {
  const double width = (box.high[0] - box.low[0]) / levels;
  for (int k = 0; k < levels; ++k) {
    const double x = box.low[0] + k * width;
    canvas.rectangle({{x, box.low[1]}, {x + width, box.high[1]}}, fmt::format("l{}", k));
  }
  const double baseline = (box.low[1] + box.high[1]) / 2 + 0.35 * kTextSize;
  canvas.text({box.low[0] - 8, baseline}, escape(low), "text", Anchor::end);
  canvas.text({box.high[0] + 8, baseline}, escape(high), "text");
}

}  // namespace sinkmesh::reproduce
