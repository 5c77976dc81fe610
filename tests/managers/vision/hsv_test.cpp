// RGB to HSV: the recorded table, and every colour there is.
#include "managers/vision/hsv.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "managers/vision/naive.hpp"

namespace darwinop::vision {
namespace {

std::uint8_t byte(int value) {
  return static_cast<std::uint8_t>(value);
}

// A grid of 216 colours, and special ones.
TEST(Hsv, AgreesWithEveryRowOfTheTable) {
  std::ifstream table{DARWINOP_GOLDEN_HSV};
  std::string line;
  ASSERT_TRUE(std::getline(table, line));
  EXPECT_EQ(line, "r,g,b,h,s,v");
  int rows = 0;
  while (std::getline(table, line)) {
    int r = 0, g = 0, b = 0, h = 0, s = 0, v = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%d,%d,%d,%d", &r, &g, &b, &h, &s, &v), 6) << line;
    EXPECT_EQ(toHsv(byte(r), byte(g), byte(b)), (Hsv{h, s, v})) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 237);
}

TEST(Hsv, IsThatOfTheRulesForEveryColour) {
  for (int colour = 0; colour < 1 << 24; ++colour) {
    const int r = colour >> 16, g = colour >> 8 & 255, b = colour & 255;
    const naive::Colour expected = naive::convert(r, g, b);
    const Hsv got = toHsv(byte(r), byte(g), byte(b));
    if (got.hue != expected.hue || got.saturation != expected.saturation || got.value != expected.value)
      FAIL() << r << ' ' << g << ' ' << b;
  }
}

TEST(Hsv, EveryGreyHasNoHueAndNoValueNotEvenWhite) {
  for (int grey = 0; grey < 256; ++grey) EXPECT_EQ(toHsv(byte(grey), byte(grey), byte(grey)), (Hsv{0xFFFF, 0, 0}));
}

TEST(Hsv, DegreesBelowZeroAreCutTowardsZero) {
  for (int blue = 1; blue <= 4; ++blue) EXPECT_EQ(toHsv(255, 0, byte(blue)).hue, 0) << blue;
  EXPECT_EQ(toHsv(255, 0, 5).hue, 359);
}

}  // namespace
}  // namespace darwinop::vision
