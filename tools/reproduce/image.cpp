// SPDX-License-Identifier: MIT
//
// libpng's simplified interface: one call, no longjmp over our objects.
#include "tools/reproduce/image.h"

#include <png.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "predicates/error.h"
#include "tools/io/detail/base64.h"

namespace sinkmesh::reproduce {
namespace {

constexpr std::size_t kMaxPalette = 256;

struct Indexed {
  std::vector<Pixel> palette;  // sorted
  std::vector<std::uint8_t> pixels;
};

// Nothing if there are too many colours.
std::optional<Indexed> index_colours(const std::vector<Pixel>& pixels) {
  Indexed result;
  result.pixels.reserve(pixels.size());
  for (const Pixel& pixel : pixels) {
    const auto place = std::lower_bound(result.palette.begin(), result.palette.end(), pixel);
    if (place != result.palette.end() && *place == pixel) continue;
    if (result.palette.size() == kMaxPalette) return std::nullopt;
    result.palette.insert(place, pixel);
  }
  for (const Pixel& pixel : pixels) {
    const auto place = std::lower_bound(result.palette.begin(), result.palette.end(), pixel);
    result.pixels.push_back(static_cast<std::uint8_t>(place - result.palette.begin()));
  }
  return result;
}

std::string write(png_image& header, const void* pixels, const void* palette) {
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  // A row stride of 0 means that rows follow each other without a gap.
  if (!png_image_write_to_memory(&header, bytes.data(), &size, /*convert_to_8_bit=*/0, pixels,
                                 /*row_stride=*/0, palette)) {
    throw std::runtime_error(std::string("PNG: ") + header.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string encode_png(const Image& image) {
  if (image.width <= 0 || image.height <= 0) throw InputError("a PNG file needs at least one pixel");
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  if (const auto indexed = index_colours(image.pixels)) {
    header.format = PNG_FORMAT_RGBA_COLORMAP;
    header.colormap_entries = static_cast<png_uint_32>(indexed->palette.size());
    return write(header, indexed->pixels.data(), indexed->palette.data());
  }
  header.format = PNG_FORMAT_RGBA;
  return write(header, image.pixels.data(), nullptr);
}

std::string data_uri(std::string_view media_type, std::string_view bytes) {
  return "data:" + std::string(media_type) + ";base64," + io_detail::encode_base64(bytes);
}

}  // namespace sinkmesh::reproduce
