// Colour finder: limits, borders, centroids, and random pictures against a naive implementation.
#include "managers/vision/colour_finder.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "managers/vision/naive.hpp"
#include "managers/vision/pictures.hpp"

namespace darwinop::vision {
namespace {

constexpr Thresholds kReds{0, 15, 50, 10};
constexpr PercentLimits kAnyShare{0, 100};

TEST(ColourFinder, TheCentreOfABlockIsFound) {
  ColourFinder finder{64, 48, kReds};
  EXPECT_EQ(finder.find(Picture{64, 48}.box(10, 20, 5, 7).bytes()), (Pixel{12, 23}));
}

TEST(ColourFinder, TheMeanIsTruncated) {
  ColourFinder finder{64, 48, kReds, kAnyShare};
  EXPECT_EQ(finder.find(Picture{64, 48}.box(10, 20, 4, 6).bytes()), (Pixel{11, 22})) << "11.5 and 22.5";
}

TEST(ColourFinder, TwoBlocksHaveOneCommonMean) {
  ColourFinder finder{64, 48, kReds, kAnyShare};
  EXPECT_EQ(finder.find(Picture{64, 48}.box(10, 10, 3, 3).box(50, 30, 3, 3).bytes()), (Pixel{31, 21}));
  EXPECT_FALSE(finder.isDetected(31, 21));
}

TEST(ColourFinder, StructuresThinnerThanThreePixelsAreRemoved) {
  ColourFinder finder{64, 48, kReds, kAnyShare};
  EXPECT_EQ(finder.find(Picture{64, 48}.box(5, 5, 2, 30).box(20, 20, 30, 2).bytes()), std::nullopt);
}

TEST(ColourFinder, TheMinimumIsExclusiveAndTheMaximumInclusive) {
  ColourFinder finder{50, 40, kReds};  // 2000 pixels
  const Picture picture = Picture{50, 40}.box(10, 10, 10, 10);
  const auto found = [&](double min, double max) {
    finder.setLimits({min, max});
    return finder.find(picture.bytes()).has_value();
  };
  EXPECT_TRUE(found(0, 100));
  EXPECT_FALSE(found(5, 100)) << "exactly 5 %";
  EXPECT_TRUE(found(4.99, 100));
  EXPECT_TRUE(found(0, 5)) << "exactly 5 %";
  EXPECT_FALSE(found(0, 4.99));
  EXPECT_FALSE(found(0, 0));
  EXPECT_FALSE(found(100, 0));
  EXPECT_TRUE(finder.isDetected(12, 12)) << "limits do not change the mask";
}

TEST(ColourFinder, NoPixelIsNothingAtAnyLimit) {
  ColourFinder finder{50, 40, kReds, {-1, 100}};
  EXPECT_EQ(finder.find(Picture{50, 40}.bytes()), std::nullopt);
}

TEST(ColourFinder, BorderPixelsAreNeverDetected) {
  ColourFinder finder{70, 40, kReds, kAnyShare};
  EXPECT_TRUE(finder.find(Picture{70, 40, kRed}.bytes()));
  for (int y = -1; y <= 40; ++y)
    for (int x = -1; x <= 70; ++x)
      EXPECT_EQ(finder.isDetected(x, y), x > 0 && y > 0 && x < 69 && y < 39) << x << ' ' << y;
}

TEST(ColourFinder, APictureThatIsAllBorderIsEmpty) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {2, 50}, {50, 2}, {1, 50}}) {
    ColourFinder finder{width, height, kReds, kAnyShare};
    EXPECT_EQ(finder.find(Picture{width, height, kRed}.bytes()), std::nullopt) << width << "x" << height;
    EXPECT_FALSE(finder.isDetected(0, 0));
  }
  ColourFinder finder{3, 3, kReds, kAnyShare};
  EXPECT_EQ(finder.find(Picture{3, 3, kRed}.bytes()), (Pixel{1, 1}));
}

TEST(ColourFinder, BeforeTheFirstPictureNothingIsDetected) {
  const ColourFinder finder{20, 20, kReds};
  EXPECT_FALSE(finder.isDetected(5, 5));
}

TEST(ColourFinder, ABufferOfAnotherSizeIsNotReadAndClearsTheMask) {
  ColourFinder finder{20, 20, kReds, kAnyShare};
  const Picture picture{20, 20, kRed};
  EXPECT_TRUE(finder.find(picture.bytes()));
  EXPECT_EQ(finder.find(std::span{picture.bytes()}.first(4 * 20 * 20 - 1)), std::nullopt);
  EXPECT_FALSE(finder.isDetected(5, 5));
  EXPECT_TRUE(finder.find(picture.bytes()));
  EXPECT_EQ(finder.find({}), std::nullopt);
  EXPECT_EQ(finder.find(Picture{21, 20, kRed}.bytes()), std::nullopt);
}

TEST(ColourFinder, NewThresholdsApplyFromTheNextPicture) {
  ColourFinder finder{20, 20, {120, 15, 50, 10}, kAnyShare};
  const Picture picture{20, 20, kRed};
  EXPECT_FALSE(finder.find(picture.bytes()));
  finder.setThresholds(kReds);
  EXPECT_FALSE(finder.isDetected(5, 5));
  EXPECT_TRUE(finder.find(picture.bytes()));
  finder.setThresholds({0, 15, 100, 10});  // nothing exceeds 100 %
  EXPECT_TRUE(finder.isDetected(5, 5));
  EXPECT_FALSE(finder.find(picture.bytes()));
  EXPECT_FALSE(finder.isDetected(5, 5));
}

TEST(ColourFinder, InvalidSizesThrow) {
  EXPECT_THROW((ColourFinder{0, 10, {}}), std::invalid_argument);
  EXPECT_THROW((ColourFinder{10, -1, {}}), std::invalid_argument);
}

TEST(ColourFinder, TwoThousandRandomPicturesGiveTheNaiveResult) {
  std::mt19937 rng{20131016};
  const auto up_to = [&](int most) { return std::uniform_int_distribution<int>{0, most}(rng); };
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const int width = 1 + up_to(i % 10 == 0 ? 199 : 79), height = 1 + up_to(29);
    const Picture picture = randomPicture(width, height, rng);
    // Half of the thresholds are near red, so that something is found; the others are random.
    const Thresholds wanted = i % 2 == 0 ? Thresholds{(350 + up_to(20)) % 361, 5 + up_to(30), up_to(60), up_to(40)}
                                         : Thresholds{up_to(360), up_to(180), up_to(101) - 1, up_to(101) - 1};
    const PercentLimits limits{up_to(3) * 0.7, 20 + 20.0 * up_to(4)};
    const naive::Result expected = naive::find(
        picture.data(), width, height, {wanted.hue, wanted.hue_tolerance, wanted.min_saturation, wanted.min_value},
        limits.min, limits.max);
    found += expected.found ? 1 : 0;
    for (const Instructions instructions : kAllInstructions) {
      if (!canUse(instructions)) continue;
      ColourFinder finder{width, height, wanted, limits, instructions};
      const auto got = finder.find(picture.bytes());
      ASSERT_EQ(got.has_value(), expected.found) << "picture " << i;
      if (got) {
        ASSERT_EQ(*got, (Pixel{expected.x, expected.y})) << "picture " << i;
      }
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_EQ(finder.isDetected(x, y), expected.mask.at(x, y)) << "picture " << i;
    }
  }
  EXPECT_GT(found, 300) << "too few positive results";
}

}  // namespace
}  // namespace darwinop::vision
