// SPDX-License-Identifier: MIT
//
// The definitions of Oklab, CIE L* and sRGB (IEC 61966-2-1).
#include "tools/reproduce/colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinkmesh::reproduce {
namespace {

double cube(double x) { return x * x * x; }

double encode(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}
double decode(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

Light to_light(const Perceived& colour) {
  const double angle = colour.hue * std::numbers::pi / 180;
  const double a = colour.chroma * std::cos(angle);
  const double b = colour.chroma * std::sin(angle);
  const double l = cube(colour.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(colour.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(colour.lightness - 0.0894841775 * a - 1.2914855480 * b);
  const auto clamped = [](double value) { return std::clamp(value, 0.0, 1.0); };
  return {clamped(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          clamped(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          clamped(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

double luminance_seen(const Light& colour) {
  const double y = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
  return y > 216.0 / 24389 ? 1.16 * std::cbrt(y) - 0.16 : y * 24389 / 2700;
}

Pixel to_pixel(const Light& colour, double opacity) {
  return {to_byte(encode(colour[0])), to_byte(encode(colour[1])), to_byte(encode(colour[2])), to_byte(opacity)};
}

Light to_light(const Pixel& pixel) {
  return {decode(pixel[0] / 255.0), decode(pixel[1] / 255.0), decode(pixel[2] / 255.0)};
}

}  // namespace sinkmesh::reproduce
