// Planes beside their definition, worked out one sample at a time.
#include "hal/pixels/yuyv_to_planes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "hal/pixels/pictures.hpp"

namespace darwinop::pixels {
namespace {

struct PlaneBytes {
  std::vector<std::uint8_t> y, u, v;
  bool operator==(const PlaneBytes&) const = default;
};

PlaneBytes planesBy(ToPlanes* function, const Picture& picture, Chroma chroma) {
  const std::size_t samples = chromaBytes(picture.width, picture.height, chroma);
  PlaneBytes bytes{std::vector<std::uint8_t>(static_cast<std::size_t>(picture.width) * picture.height),
                   std::vector<std::uint8_t>(samples), std::vector<std::uint8_t>(samples)};
  function(picture.image(), chroma, {bytes.y, bytes.u, bytes.v});
  return bytes;
}

int halfUp(int a, int b) {
  return a / 2 + b / 2 + (a % 2 + b % 2 + 1) / 2;
}

PlaneBytes expectedPlanes(const Picture& picture, Chroma chroma) {
  PlaneBytes bytes;
  const auto put = [](std::vector<std::uint8_t>& to, int value) { to.push_back(static_cast<std::uint8_t>(value)); };
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) put(bytes.y, picture.turned(x, y).y);
  const int rows = chroma == Chroma::k420 ? 2 : 1;
  for (int y = 0; y < picture.height; y += rows)
    for (int x = 0; x < picture.width; x += 2) {
      const int right = std::min(x + 1, picture.width - 1), below = std::min(y + rows, picture.height) - 1;
      const Yuv a = picture.turned(x, y), b = picture.turned(right, y);
      const Yuv c = picture.turned(x, below), d = picture.turned(right, below);
      put(bytes.u, halfUp(halfUp(a.u, b.u), halfUp(c.u, d.u)));
      put(bytes.v, halfUp(halfUp(a.v, b.v), halfUp(c.v, d.v)));
    }
  return bytes;
}

TEST(YuyvToPlanes, FourByTwoByHand) {
  const Picture picture{4, 2, 8, {1, 10, 2, 20, 3, 30, 4, 40, 5, 51, 6, 60, 7, 70, 8, 81}};
  for (const auto& kernel : usable(planesKernels())) {
    const std::vector<std::uint8_t> y{8, 7, 6, 5, 4, 3, 2, 1};
    EXPECT_EQ(planesBy(kernel.function, picture, Chroma::k422), (PlaneBytes{y, {70, 51, 30, 10}, {81, 60, 40, 20}}));
    EXPECT_EQ(planesBy(kernel.function, picture, Chroma::k420), (PlaneBytes{y, {50, 31}, {61, 40}})) << "half up";
  }
}

TEST(YuyvToPlanes, OddWidthPairsOthersThanTheCamera) {
  const Picture picture{3, 1, 8, {1, 10, 2, 20, 3, 30, 99, 40}};
  for (const auto& kernel : usable(planesKernels()))
    EXPECT_EQ(planesBy(kernel.function, picture, Chroma::k422), (PlaneBytes{{3, 2, 1}, {20, 10}, {30, 20}}))
        << kernel.name;
}

TEST(YuyvToPlanes, SmallAndOddSizesAndGapsBetweenRows) {
  for (int width = 1; width <= 35; ++width)
    for (int height = 1; height <= 5; ++height)
      for (const std::size_t gap : {0, 1, 13}) {
        const Picture picture = pictureOf(width, height, gap, 23);
        for (const Chroma chroma : {Chroma::k422, Chroma::k420})
          for (const auto& kernel : usable(planesKernels()))
            ASSERT_EQ(planesBy(kernel.function, picture, chroma), expectedPlanes(picture, chroma))
                << kernel.name << ", " << width << "x" << height << ", gap " << gap;
      }
}

RC_GTEST_PROP(YuyvToPlanes, AnyPictureByAnyKernel, ()) {
  const int width = *rc::gen::inRange(1, 200), height = *rc::gen::inRange(1, 8);
  const auto gap = *rc::gen::inRange<std::size_t>(0, 70);
  const Picture picture = pictureOf(width, height, gap, *rc::gen::arbitrary<std::uint32_t>());
  const Chroma chroma = *rc::gen::element(Chroma::k422, Chroma::k420);
  const PlaneBytes expected = expectedPlanes(picture, chroma);
  for (const auto& kernel : usable(planesKernels())) RC_ASSERT(planesBy(kernel.function, picture, chroma) == expected);
  RC_ASSERT(planesBy(yuyvToPlanesRotated, picture, chroma) == expected);
}

}  // namespace
}  // namespace darwinop::pixels
