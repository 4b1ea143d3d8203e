// SPDX-License-Identifier: MIT
#include "tools/reproduce/colour_map.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sinkmesh::reproduce {
namespace {

const double kRegular = std::sqrt(3.0 / 8);

double mix(double a, double b, double t) { return a + (b - a) * t; }

Perceived mix(const Perceived& a, const Perceived& b, double t) {
  return {mix(a.lightness, b.lightness, t), mix(a.chroma, b.chroma, t), mix(a.hue, b.hue, t)};
}

// Lightness is one straight line over both halves, but for a small step at the bound.
constexpr Perceived kBest{0.95, 0.02, 230};
constexpr Perceived kStillGood{0.69, 0.13, 245};
constexpr Perceived kJustBad{0.69, 0.16, 60};
constexpr Perceived kWorst{0.33, 0.11, 25};

std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3);
  return {buffer.data(), end.ptr};
}

std::string hex(const Light& colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const Pixel pixel = to_pixel(colour);
  std::string result = "#";
  for (std::size_t k = 0; k < 3; ++k) {
    result += kDigits[pixel[k] >> 4u];
    result += kDigits[pixel[k] & 15u];
  }
  return result;
}

struct Tick {
  double ratio;
  std::string label;
};

std::vector<Tick> ticks(const RatioScale& scale) {
  std::vector<Tick> result{{kRegular, text(kRegular)}};
  const double distance = 0.06;  // of the bar, so that labels do not touch
  for (const double ratio : {1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const double position = scale.position(ratio);
    const bool free = position > distance && std::abs(position - 0.5) > distance && position < 1 - distance;
    if (free) result.push_back({ratio, text(ratio)});
  }
  result.push_back({scale.bound, text(scale.bound)});
  result.push_back({scale.worst, "≥ " + text(scale.worst)});
  return result;
}

}  // namespace

double RatioScale::position(double ratio) const {
  const auto fraction = [ratio](double low, double high) {
    return std::log(ratio / low) / std::log(high / low);
  };
  if (ratio <= bound) return std::max(0.0, fraction(kRegular, bound) / 2);
  return std::min(1.0, 0.5 + fraction(bound, worst) / 2);
}

Light ratio_colour(double position) {
  const double t = std::clamp(position, 0.0, 1.0);
  return to_light(t <= 0.5 ? mix(kBest, kStillGood, 2 * t) : mix(kJustBad, kWorst, 2 * t - 1));
}

std::string colour_bar_svg(const RatioScale& scale) {
  // Strips instead of a gradient: a gradient needs an id, and ids of several bars in one page would clash.
  constexpr int kStrips = 90;
  constexpr int kWidth = 360;
  constexpr int kLeft = 30;
  constexpr int kTop = 22;
  constexpr int kHeight = 12;
  constexpr int kStrip = kWidth / kStrips;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"colour-bar\" role=\"img\" width=\"" +
                    std::to_string(kWidth + 2 * kLeft) + "\" height=\"54\" viewBox=\"0 0 " +
                    std::to_string(kWidth + 2 * kLeft) +
                    " 54\" font-size=\"12\" font-family=\"inherit\" fill=\"currentColor\" "
                    "text-anchor=\"middle\">\n<title>Colours of the ratio r/ℓ</title>\n";
  const auto label = [&svg](double x, double y, const std::string& content) {
    svg += "<text x=\"" + text(x) + "\" y=\"" + text(y) + "\">" + content + "</text>\n";
  };
  svg += "<g shape-rendering=\"crispEdges\">\n";
  for (int i = 0; i < kStrips; ++i) {
    svg += "<rect x=\"" + std::to_string(kLeft + i * kStrip) + "\" y=\"" + std::to_string(kTop) +
           "\" width=\"" + std::to_string(kStrip) + "\" height=\"" + std::to_string(kHeight) + "\" fill=\"" +
           hex(ratio_colour((i + 0.5) / kStrips)) + "\"/>\n";
  }
  for (const Tick& tick : ticks(scale)) {
    const double x = kLeft + kWidth * scale.position(tick.ratio);
    svg += "<rect x=\"" + text(x - 0.5) + "\" y=\"" + std::to_string(kTop + kHeight) +
           "\" width=\"1\" height=\"4\"/>\n";
  }
  svg += "</g>\n";
  for (const Tick& tick : ticks(scale)) {
    label(kLeft + kWidth * scale.position(tick.ratio), kTop + kHeight + 17, tick.label);
  }
  label(kLeft + kWidth * 0.25, kTop - 7, "good");
  label(kLeft + kWidth * 0.5, kTop - 7, "r/ℓ");
  label(kLeft + kWidth * 0.75, kTop - 7, "low quality");
  return svg + "</svg>\n";
}

}  // namespace sinkmesh::reproduce
