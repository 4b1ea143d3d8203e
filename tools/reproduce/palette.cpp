// SPDX-License-Identifier: MIT
//
// The box with the largest spread of one channel, times its pixels, is split at the median of that channel, until there
// are enough boxes.
#include "tools/reproduce/palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sinkmesh::reproduce {
namespace {

constexpr std::size_t kAlpha = 3;

struct Entry {
  Pixel colour;
  std::size_t count;
};

// A range of entries.
struct Box {
  std::size_t begin;
  std::size_t end;
  std::size_t channel = 0;  // of the largest spread
  double weight = 0;        // 0: not to be split
};

Box measured(const std::vector<Entry>& entries, std::size_t begin, std::size_t end) {
  Box box{begin, end};
  double pixels = 0;
  for (std::size_t i = begin; i < end; ++i) pixels += static_cast<double>(entries[i].count);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const auto [low, high] = std::minmax_element(
        entries.begin() + static_cast<std::ptrdiff_t>(begin),
        entries.begin() + static_cast<std::ptrdiff_t>(end),
        [&](const Entry& a, const Entry& b) { return a.colour[channel] < b.colour[channel]; });
    // The root, since otherwise a large, nearly uniform area takes colours from small ones that differ visibly.
    const double weight = (high->colour[channel] - low->colour[channel]) * std::sqrt(pixels);
    if (weight > box.weight) box.weight = weight, box.channel = channel;
  }
  return box;
}

// Both parts hold at least one entry.
std::size_t median(const std::vector<Entry>& entries, const Box& box) {
  std::size_t pixels = 0;
  for (std::size_t i = box.begin; i < box.end; ++i) pixels += entries[i].count;
  std::size_t before = 0;
  std::size_t i = box.begin;
  while (i + 2 < box.end && before + entries[i].count <= pixels / 2) before += entries[i++].count;
  return i + 1;
}

std::pair<Box, Box> split(std::vector<Entry>& entries, const Box& box) {
  std::sort(entries.begin() + static_cast<std::ptrdiff_t>(box.begin),
            entries.begin() + static_cast<std::ptrdiff_t>(box.end), [&](const Entry& a, const Entry& b) {
              return std::pair(a.colour[box.channel], a.colour) < std::pair(b.colour[box.channel], b.colour);
            });
  const std::size_t middle = median(entries, box);
  return {measured(entries, box.begin, middle), measured(entries, middle, box.end)};
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
    if (entries.empty() || entries.back().colour != pixel) entries.push_back({pixel, 0});
    ++entries.back().count;
  }
  return entries;
}

}  // namespace

void reduce_colours(Image& image, std::size_t max_colours) {
  std::vector<Entry> entries = histogram(image.pixels);
  if (entries.size() <= max_colours || max_colours < 3) return;

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
                                         [](const Box& a, const Box& b) { return a.weight < b.weight; });
    if (widest->weight == 0) break;
    const auto [first, second] = split(entries, *widest);
    *widest = first;
    boxes.push_back(second);
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
