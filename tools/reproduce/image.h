// SPDX-License-Identifier: MIT
//
// Pictures of pixels, and how they get into a page.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sinkmesh::reproduce {

/// Red, green, blue, opacity. Colours are sRGB and not multiplied by the opacity.
using Pixel = std::array<std::uint8_t, 4>;

/// Rows from the top, pixels from the left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;

  /// Transparent.
  Image() = default;
  Image(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  Pixel& at(int x, int y) { return pixels[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// The bytes of a PNG file with exactly these pixels: with a palette if there are at most 256 colours, which
/// makes the file a few times smaller; see reduce_colours().
/// @throws InputError if the image is empty; std::runtime_error if libpng fails.
std::string encode_png(const Image& image);

/// "data:image/png;base64,...", for the src of an <img>.
std::string data_uri(std::string_view media_type, std::string_view bytes);

}  // namespace sinkmesh::reproduce
