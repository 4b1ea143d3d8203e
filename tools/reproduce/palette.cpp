// SPDX-License-Identifier: MIT
//
// The box with the largest sum of squared deviations along one axis is split at the mean on that axis, until
// there are enough boxes. Axes are lightness and two differences of colour, not red, green and blue: along
// these, grey and coloured faces of the same lightness would stay together, and lend each other a tint.
#include "tools/reproduce/palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sinkmesh::reproduce {
namespace {

constexpr std::size_t kAlpha = 3;

using Coordinates = std::array<int, 4>;

// Small shifts of hue are seen more easily than small shifts of lightness.
Coordinates coordinates(const Pixel& pixel) {
  const int red = pixel[0], green = pixel[1], blue = pixel[2];
  return {red + 2 * green + blue, 4 * (red - green), 4 * (blue - green), 4 * pixel[kAlpha]};
}

struct Entry {
  Pixel colour;
  std::size_t count;
  Coordinates place;
};

// A range of entries.
struct Box {
  std::size_t begin;
  std::size_t end;
  std::size_t axis = 0;  // of the largest spread
  double mean = 0;       // on this axis
  double spread = 0;     // 0: not to be split
};

Box measured(const std::vector<Entry>& entries, std::size_t begin, std::size_t end) {
  Box box{begin, end};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    double weight = 0, sum = 0, squares = 0;
    for (std::size_t i = begin; i < end; ++i) {
      // The root, since otherwise a large, nearly uniform area takes colours from small ones that differ
      // visibly.
      const double w = std::sqrt(static_cast<double>(entries[i].count));
      weight += w;
      sum += w * entries[i].place[axis];
      squares += w * entries[i].place[axis] * entries[i].place[axis];
    }
    const double mean = sum / weight;
    const double spread = squares - sum * mean;
    if (end - begin > 1 && spread > box.spread) {
      box.spread = spread;
      box.axis = axis;
      box.mean = mean;
    }
  }
  return box;
}

// Where the mean, because of rounding, separates nothing, the box stays whole and is not asked again.
std::pair<Box, Box> split(std::vector<Entry>& entries, const Box& box) {
  const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(box.begin);
  const auto end = entries.begin() + static_cast<std::ptrdiff_t>(box.end);
  const auto middle =
      std::stable_partition(begin, end, [&](const Entry& e) { return e.place[box.axis] <= box.mean; });
  const auto cut = static_cast<std::size_t>(middle - entries.begin());
  if (cut == box.begin || cut == box.end) return {Box{box.begin, box.end}, Box{box.end, box.end}};
  return {measured(entries, box.begin, cut), measured(entries, cut, box.end)};
}

Pixel mean(const std::vector<Entry>& entries, const Box& box) {
  std::array<double, 4> sum{};
  double pixels = 0;
  for (std::size_t i = box.begin; i < box.end; ++i) {
    const auto count = static_cast<double>(entries[i].count);
    pixels += count;
    for (std::size_t channel = 0; channel < 4; ++channel) sum[channel] += count * entries[i].colour[channel];
  }
  Pixel result{};
  for (std::size_t channel = 0; channel < 4; ++channel) {
    result[channel] = static_cast<std::uint8_t>(std::lround(sum[channel] / pixels));
  }
  return result;
}

// The colours that occur, in their order, and how often.
std::vector<Entry> histogram(std::vector<Pixel> pixels) {
  std::sort(pixels.begin(), pixels.end());
  std::vector<Entry> entries;
  for (const Pixel& pixel : pixels) {
    if (entries.empty() || entries.back().colour != pixel) entries.push_back({pixel, 0, coordinates(pixel)});
    ++entries.back().count;
  }
  return entries;
}

}  // namespace

void reduce_colours(Image& image, std::size_t max_colours) {
  std::vector<Entry> entries = histogram(image.pixels);
  if (entries.size() <= max_colours) return;

  // Fully transparent, in between, opaque: never in one box.
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const auto kind = [](const Entry& e) { return e.colour[kAlpha] == 0 ? 0 : e.colour[kAlpha] < 255 ? 1 : 2; };
    return kind(a) < kind(b);
  });
  const auto boundary = [&](int least_alpha) {
    return static_cast<std::size_t>(
        std::find_if(entries.begin(), entries.end(),
                     [&](const Entry& e) { return e.colour[kAlpha] >= least_alpha; }) -
        entries.begin());
  };
  const std::array<std::size_t, 4> ends{0, boundary(1), boundary(255), entries.size()};
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < 3; ++k) {
    if (ends[k] < ends[k + 1]) boxes.push_back(measured(entries, ends[k], ends[k + 1]));
  }

  while (boxes.size() < max_colours) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                         [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (widest->spread == 0) break;
    const auto [first, second] = split(entries, *widest);
    *widest = first;
    if (second.begin < second.end) boxes.push_back(second);
  }

  std::vector<std::pair<Pixel, Pixel>> replacement;
  replacement.reserve(entries.size());
  for (const Box& box : boxes) {
    const Pixel colour = mean(entries, box);
    for (std::size_t i = box.begin; i < box.end; ++i) replacement.emplace_back(entries[i].colour, colour);
  }
  std::sort(replacement.begin(), replacement.end());
  for (Pixel& pixel : image.pixels) {
    pixel = std::lower_bound(replacement.begin(), replacement.end(), std::pair(pixel, Pixel{}))->second;
  }
}

}  // namespace sinkmesh::reproduce
