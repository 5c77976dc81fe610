// Once it is made, the finder allocates nothing.
#include <gtest/gtest.h>

#include <random>

#include "managers/vision/colour_finder.hpp"
#include "managers/vision/pictures.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::vision {
namespace {

TEST(ColourFinderAllocation, NoPictureAndNoSettingAllocates) {
  std::mt19937 dice{1};
  std::vector<Picture> pictures;
  pictures.reserve(20);
  for (int i = 0; i < 20; ++i) pictures.push_back(randomPicture(160, 120, dice));
  ColourFinder finder{160, 120, {}, {0, 100}};
  int found = 0;
  const long before = allocationsOfThisThread();
  for (const Picture& picture : pictures) {
    finder.setThresholds({0, 20, 40, 10});
    finder.setLimits({0, 100});
    found += finder.find(picture.bytes()) ? 1 : 0;
    finder.find({});
  }
  EXPECT_EQ(allocationsOfThisThread(), before);
  EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace darwinop::vision
