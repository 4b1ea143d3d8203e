// SPDX-License-Identifier: MIT
//
// What is written is what libpng reads; fewer colours are close ones.
#include "tools/reproduce/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>
#include <random>
#include <set>

#include "predicates/error.h"
#include "tools/io/detail/base64.h"
#include "tools/reproduce/palette.h"

namespace sinkmesh::reproduce {
namespace {

Image decode_png(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size())) << header.message;
  header.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  EXPECT_TRUE(png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr)) << header.message;
  return image;
}

// Every pixel has one of `colours` random colours, transparent ones among them.
Image random_image(int width, int height, std::size_t colours, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Pixel> palette(colours);
  for (Pixel& pixel : palette) {
    for (std::uint8_t& channel : pixel) channel = static_cast<std::uint8_t>(random());
    if (random() % 4 == 0) pixel[3] = random() % 2 == 0 ? 0 : 255;
  }
  Image image(width, height);
  for (Pixel& pixel : image.pixels) pixel = palette[random() % colours];
  return image;
}

TEST(Png, DecodesToTheSamePixels) {
  for (const std::size_t colours : {1u, 2u, 17u, 256u, 257u, 5000u}) {
    SCOPED_TRACE(colours);
    const Image image = random_image(83, 61, colours, 7);
    const Image decoded = decode_png(encode_png(image));
    EXPECT_EQ(decoded.width, 83);
    EXPECT_EQ(decoded.height, 61);
    EXPECT_TRUE(decoded.pixels == image.pixels);
  }
}

TEST(Png, IsSmallWithFewColours) {
  EXPECT_LT(2 * encode_png(random_image(100, 100, 200, 1)).size(),
            encode_png(random_image(100, 100, 9000, 1)).size());
}

TEST(Png, RefusesAnEmptyImage) {
  EXPECT_THROW(encode_png(Image()), InputError);
  EXPECT_THROW(encode_png(Image(5, 0)), InputError);
}

TEST(DataUri, IsBase64) { EXPECT_EQ(data_uri("image/png", "foobar"), "data:image/png;base64,Zm9vYmFy"); }

// The examples of RFC 4648, section 10.
TEST(Base64, EncodesWithPadding) {
  using io_detail::encode_base64;
  EXPECT_EQ(encode_base64(""), "");
  EXPECT_EQ(encode_base64("f"), "Zg==");
  EXPECT_EQ(encode_base64("fo"), "Zm8=");
  EXPECT_EQ(encode_base64("foo"), "Zm9v");
  EXPECT_EQ(encode_base64("foob"), "Zm9vYg==");
  EXPECT_EQ(encode_base64("fooba"), "Zm9vYmE=");
}

TEST(Base64, DecodesWhatItEncodes) {
  std::mt19937 random(3);
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    const std::string text = io_detail::encode_base64(bytes);
    std::string_view rest = text;
    EXPECT_EQ(io_detail::decode_base64(rest, bytes.size()), bytes);
    bytes += static_cast<char>(random());
  }
}

TEST(ReduceColours, LeavesFewColoursAsTheyAre) {
  const Image image = random_image(50, 50, 256, 5);
  Image reduced = image;
  reduce_colours(reduced);
  EXPECT_TRUE(reduced.pixels == image.pixels);
}

TEST(ReduceColours, LeavesAtMostAsManyAsAskedFor) {
  for (const std::size_t most : {3u, 16u, 256u}) {
    Image image = random_image(90, 90, 8000, 6);
    reduce_colours(image, most);
    EXPECT_LE(std::set<Pixel>(image.pixels.begin(), image.pixels.end()).size(), most);
  }
}

TEST(ReduceColours, KeepsTransparentAndOpaquePixels) {
  const Image image = random_image(90, 90, 8000, 8);
  Image reduced = image;
  reduce_colours(reduced, 10);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const int before = image.pixels[i][3];
    const int after = reduced.pixels[i][3];
    EXPECT_EQ(before == 0, after == 0);
    EXPECT_EQ(before == 255, after == 255);
  }
}

TEST(ReduceColours, StaysCloseOnGradients) {
  Image image(256, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 256; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(x),
                        static_cast<std::uint8_t>(x / 2 + y), 255};
    }
  }
  Image reduced = image;
  reduce_colours(reduced);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_LE(std::abs(image.pixels[i][k] - reduced.pixels[i][k]), 12);
  }
}

}  // namespace
}  // namespace sinkmesh::reproduce
