// SPDX-License-Identifier: MIT
//
// The colours of ratios keep their promises: an order that is seen without hues, stated ends.
#include "tools/reproduce/colour_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace sinkmesh::reproduce {
namespace {

TEST(RatioScale, StartsAtTheRegularTetrahedronAndHasTheBoundInTheMiddle) {
  const RatioScale scale{2, 20};
  EXPECT_NEAR(scale.position(std::sqrt(3.0 / 8)), 0, 1e-12);
  EXPECT_DOUBLE_EQ(scale.position(2), 0.5);
  EXPECT_DOUBLE_EQ(scale.position(20), 1);
  EXPECT_NEAR(scale.position(std::sqrt(40.0)), 0.75, 1e-12);
}

TEST(RatioScale, ClampsWhatLiesBeyond) {
  const RatioScale scale{2, 20};
  EXPECT_EQ(scale.position(0.5), 0);
  EXPECT_EQ(scale.position(1e9), 1);
  EXPECT_EQ(scale.position(HUGE_VAL), 1);
}

TEST(RatioScale, IsIncreasing) {
  const RatioScale scale{1, 7};
  double last = scale.position(0.613);
  for (double ratio = 0.62; ratio < 7; ratio += 0.01) {
    EXPECT_GT(scale.position(ratio), last);
    last = scale.position(ratio);
  }
}

TEST(RatioColour, FallsInLuminance) {
  double last = luminance_seen(ratio_colour(0));
  for (int i = 1; i <= 1000; ++i) {
    const double luminance = luminance_seen(ratio_colour(i / 1000.0));
    EXPECT_LT(luminance, last) << i;
    // No step is larger than three times the mean one, but for the one at the bound.
    if (i != 501) {
      EXPECT_LT(last - luminance, 3.0 / 1000) << i;
    }
    last = luminance;
  }
}

TEST(RatioColour, IsPaleAtTheGoodEndAndDarkAtTheBadOne) {
  EXPECT_GT(luminance_seen(ratio_colour(0)), 0.9);
  EXPECT_LT(luminance_seen(ratio_colour(1)), 0.25);
  EXPECT_GT(luminance_seen(ratio_colour(1)), 0.1) << "or else it is lost on a dark page";
}

TEST(RatioColour, IsBlueBelowTheBoundAndOrangeAbove) {
  for (int i = 0; i <= 50; ++i) {
    const Light good = ratio_colour(i / 100.0);
    EXPECT_GT(good[2], good[0]);
    const Light bad = ratio_colour(0.501 + i / 101.0);
    EXPECT_GT(bad[0], 2 * bad[2]);
  }
}

TEST(Colour, GreyHasNoHue) {
  const Light grey = to_light(Perceived{0.5, 0, 123});
  EXPECT_NEAR(grey[0], 0.125, 1e-5);
  EXPECT_NEAR(grey[1], 0.125, 1e-5);
  EXPECT_NEAR(grey[2], 0.125, 1e-5);
  EXPECT_EQ(to_pixel({1, 0, 1}, 0.5), (Pixel{255, 0, 255, 128}));
}

TEST(Colour, PixelsKeepTheirBytesThroughLight) {
  for (int i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    const Pixel pixel{byte, static_cast<std::uint8_t>(255 - i), byte, 255};
    EXPECT_EQ(to_pixel(to_light(pixel)), pixel);
  }
}

TEST(ColourBar, NamesTheEndsAndTheBound) {
  const std::string svg = colour_bar_svg({2, 20});
  for (const char* text : {">0.612<", ">1<", ">2<", ">5<", ">≥ 20<", "r/ℓ", "currentColor"}) {
    EXPECT_THAT(svg, testing::HasSubstr(text));
  }
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr(" id="))) << "two bars in one page would clash";
}

}  // namespace
}  // namespace sinkmesh::reproduce
