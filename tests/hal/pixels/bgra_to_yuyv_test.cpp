// There and back: what a virtual camera is given is what the robot's capture shows.
#include "hal/pixels/bgra_to_yuyv.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "hal/pixels/pictures.hpp"

namespace darwinop::pixels {
namespace {

using Colours = std::vector<std::uint8_t>;  // BGRA

/// Through the camera and back.
Colours seen(const Colours& bgra, int width, int height, std::size_t gap = 0) {
  const std::size_t stride = yuyvRowBytes(width) + gap;
  std::vector<std::uint8_t> yuyv(yuyvBytes(width, height, stride));
  bgraToYuyvRotated(bgra, width, height, yuyv, stride);
  Colours back(bgra.size());
  yuyvToBgraRotated({yuyv, width, height, stride}, back);
  return back;
}

int worstDifference(const Colours& a, const Colours& b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST(BgraToYuyv, SolidColoursComeBackWithinTwoCounts) {
  for (int b = 0; b < 256; b += 3)  // 255 is among them
    for (int g = 0; g < 256; g += 3) {
      Colours row;  // pairs of one colour
      for (int r = 0; r < 256; r += 3)
        for (int twice = 0; twice < 2; ++twice)
          for (const int byte : {b, g, r, 255}) row.push_back(static_cast<std::uint8_t>(byte));
      ASSERT_LE(worstDifference(seen(row, 172, 1), row), 2) << "blue " << b << ", green " << g;
    }
}

TEST(BgraToYuyv, GreyComesBackAsItWas) {
  Colours row;
  for (int grey = 0; grey < 256; ++grey)
    for (const int byte : {grey, grey, grey, 255}) row.push_back(static_cast<std::uint8_t>(byte));
  EXPECT_EQ(seen(row, 256, 1), row);
}

TEST(BgraToYuyv, ThePictureComesBackUpright) {
  for (const auto& [width, height] : {std::pair{6, 3}, {5, 3}, {1, 1}, {1, 4}, {7, 1}})
    for (const std::size_t gap : {0, 5}) {
      Colours bgra;
      for (int i = 0; i < width * height; ++i)
        for (const int byte : {10 * i, 10 * i, 10 * i, 255}) bgra.push_back(static_cast<std::uint8_t>(byte));
      EXPECT_EQ(seen(bgra, width, height, gap), bgra) << width << "x" << height;
    }
}

TEST(BgraToYuyv, ChromaOfAPairIsThatOfItsMeanColour) {
  std::array<std::uint8_t, 4> mixed{}, mean{};
  bgraToYuyvRotated(Colours{255, 0, 0, 255, 0, 0, 255, 255}, 2, 1, mixed, 4);
  bgraToYuyvRotated(Colours{128, 0, 128, 255, 127, 0, 127, 255}, 2, 1, mean, 4);
  EXPECT_EQ(mixed[1], mean[1]);
  EXPECT_EQ(mixed[3], mean[3]);
  EXPECT_EQ(mixed[0], 76) << "red, at the right, is the camera's first";
  EXPECT_EQ(mixed[2], 29) << "blue";
}

TEST(BgraToYuyv, WritesPairsAndNothingBetweenRows) {
  std::vector<std::uint8_t> yuyv(yuyvBytes(3, 2, 11) + 4, 0xA5);
  bgraToYuyvRotated(Colours(24, 0), 3, 2, yuyv, 11);
  const std::vector<std::uint8_t> row{0, 128, 0, 128, 0, 128, 0, 128};
  std::vector<std::uint8_t> expected = row;
  expected.insert(expected.end(), 3, 0xA5);
  expected.insert(expected.end(), row.begin(), row.end());
  expected.insert(expected.end(), 4, 0xA5);
  EXPECT_EQ(yuyv, expected);
}

}  // namespace
}  // namespace darwinop::pixels
