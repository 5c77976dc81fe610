#include "remote/jpeg/image_size.hpp"

#include <gtest/gtest.h>

namespace darwinop::remote {
namespace {

TEST(ImageSize, KnowsSixteen) {
  int known = 0;
  for (int width = 0; width <= 400; ++width)
    for (int height = 0; height <= 400; ++height)
      if (isImageSize({width, height})) ++known;
  EXPECT_EQ(known, 16);
  EXPECT_TRUE(isImageSize({40, 240}));
  EXPECT_FALSE(isImageSize({240, 320}));
}

TEST(ImageSize, IsTheMiddleOfTheWholeImage) {
  // Columns 160 - 160/n to 160 + 160/n - 1, rows 120 - 120/n to 120 + 120/n - 1, for n = 1, 2, 4, 8.
  for (const int n : {1, 2, 4, 8}) {
    const ImageSize size{320 / n, 240 / n};
    EXPECT_EQ(leftOf(size), 160 - 160 / n);
    EXPECT_EQ(topOf(size), 120 - 120 / n);
  }
}

TEST(ImageSize, OnlyTheWholeImageIsCodedCoarsely) {
  EXPECT_EQ(qualityOf({320, 240}), 65);
  EXPECT_EQ(qualityOf({320, 120}), 80);
  EXPECT_EQ(qualityOf({160, 240}), 80);
  EXPECT_EQ(qualityOf({40, 30}), 80);
}

}  // namespace
}  // namespace darwinop::remote
