// Morphological opening against a naive implementation.
#include "managers/vision/bit_rows.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "managers/vision/naive.hpp"

namespace darwinop::vision {
namespace {

BitRows bitsOf(const naive::Mask& mask) {
  BitRows bits{mask.width, mask.height};
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y)) bits.row(y)[static_cast<std::size_t>(x) / 64] |= std::uint64_t{1} << (x % 64);
  return bits;
}

void compare(const naive::Mask& mask) {
  BitRows bits = bitsOf(mask), scratch{mask.width, mask.height};
  for (int y = 0; y < mask.height; ++y)  // content of an earlier picture
    for (int x = 0; x < mask.width; ++x)
      scratch.row(y)[static_cast<std::size_t>(x) / 64] |= std::uint64_t{1} << (x % 64);
  const Moments got = open(bits, scratch);
  const naive::Mask expected = naive::dilate(naive::erode(mask));
  Moments sum;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      ASSERT_EQ(bits.at(x, y), expected.at(x, y)) << mask.width << "x" << mask.height << " at " << x << ' ' << y;
      if (expected.at(x, y)) sum = {sum.count + 1, sum.x + static_cast<unsigned>(x), sum.y + static_cast<unsigned>(y)};
    }
  EXPECT_EQ(got, sum) << mask.width << "x" << mask.height;
}

TEST(BitRows, OpeningEqualsTheNaiveOneAtEverySize) {
  std::mt19937 rng{3};
  for (const int width : {1, 2, 3, 4, 5, 17, 63, 64, 65, 66, 127, 128, 129, 193})
    for (const int height : {1, 2, 3, 4, 5, 20})
      for (const unsigned gaps : {0u, 1000u, 40u, 12u, 3u}) {  // one in this many pixels is not set; 0: all are set
        naive::Mask mask{width, height};
        for (char& pixel : mask.set) pixel = gaps == 0 || rng() % gaps != 0;
        compare(mask);
      }
}

TEST(BitRows, OpeningEqualsTheNaiveOneAtCameraSizes) {
  std::mt19937 rng{4};
  for (const int width : {160, 320})
    for (const unsigned gaps : {0u, 200u, 20u}) {
      naive::Mask mask{width, 3 * width / 4};
      for (char& pixel : mask.set) pixel = gaps == 0 || rng() % gaps != 0;
      compare(mask);
    }
}

TEST(BitRows, ABlockOfNineSurvivesAtEveryOffsetExceptAtTheBorder) {
  for (int x = 0; x + 3 <= 130; ++x) {
    naive::Mask mask{130, 7};
    for (int i = 0; i < 9; ++i) mask.set[mask.place(x + i % 3, 2 + i / 3)] = 1;
    BitRows bits = bitsOf(mask), scratch{130, 7};
    const Moments sum = open(bits, scratch);
    const bool at_border = x == 0 || x == 127;
    EXPECT_EQ(sum.count, at_border ? 6u : 9u) << "at " << x << ": the border column is also cleared after the dilation";
    EXPECT_EQ(sum.y, 3 * sum.count);
    EXPECT_EQ(bits.at(x + 1, 3), true);
  }
}

TEST(BitRows, PixelsOutsideAreNotSet) {
  BitRows bits{65, 2};
  bits.row(1)[1] = 1;
  EXPECT_TRUE(bits.at(64, 1));
  for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {65, 1}, {64, 2}, {1 << 30, 1 << 30}, {-(1 << 30), 1}})
    EXPECT_FALSE(bits.at(x, y)) << x << ' ' << y;
}

TEST(BitRows, AFullRowDoesNotReadTheNextOne) {
  BitRows bits{64, 2};
  bits.row(1)[0] = ~std::uint64_t{0};
  EXPECT_FALSE(bits.at(64, 0));
  EXPECT_TRUE(bits.at(63, 1));
}

TEST(BitRows, InvalidSizesAreRefused) {
  for (const auto& [width, height] : {std::pair{0, 5}, {5, 0}, {-3, 5}, {5, 1 << 20}}) {
    try {
      (void)BitRows(width, height);
      ADD_FAILURE() << width << "x" << height;
    } catch (const std::invalid_argument& why) {
      EXPECT_NE(std::string{why.what()}.find(std::to_string(BitRows::kMaxSide)), std::string::npos) << why.what();
    }
  }
}

}  // namespace
}  // namespace darwinop::vision
