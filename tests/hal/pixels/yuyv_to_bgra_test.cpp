// Every colour by every kernel, and where each pixel goes.
#include "hal/pixels/yuyv_to_bgra.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "hal/pixels/pictures.hpp"

namespace darwinop::pixels {
namespace {

std::vector<std::uint8_t> bgraBy(ToBgra* function, const Picture& picture) {
  std::vector<std::uint8_t> bgra(std::size_t{4} * picture.width * picture.height);
  function(picture.image(), bgra);
  return bgra;
}

/// One of each value of Y, with the same U and V; a row of 256 pixels for each V.
Picture allColoursWith(int u) {
  Picture picture{256, 256, 512, {}};
  for (int v = 0; v < 256; ++v)
    for (int y = 0; y < 256; y += 2)
      for (const int byte : {y, u, y + 1, v}) picture.bytes.push_back(static_cast<std::uint8_t>(byte));
  return picture;
}

std::vector<std::uint8_t> expectedWith(int u) {
  std::vector<std::uint8_t> bgra(std::size_t{4} * 256 * 256);
  std::uint8_t* to = bgra.data();
  for (int v = 255; v >= 0; --v)
    for (int y = 255; y >= 0; --y, to += 4) {
      const Bgra c = colourOf({y, u, v});
      std::memcpy(to, &c, 4);
    }
  return bgra;
}

TEST(YuyvToBgra, EveryColourIsTheFormulasByEveryKernel) {
  for (int u = 0; u < 256; ++u) {
    const Picture picture = allColoursWith(u);
    const auto expected = expectedWith(u);
    for (const auto& kernel : usable(bgraKernels()))
      ASSERT_EQ(bgraBy(kernel.function, picture), expected) << kernel.name << ", U " << u;
  }
}

struct Example {
  Yuv from;
  Bgra to;
};

// Upstream's controllers on a robot get these.
constexpr Example kExamples[] = {
    {{128, 128, 128}, {128, 128, 128, 255}}, {{128, 0, 128}, {0, 172, 128, 255}},
    {{128, 255, 128}, {255, 84, 128, 255}},  {{128, 128, 0}, {128, 219, 0, 255}},
    {{128, 128, 255}, {128, 37, 255, 255}},  {{76, 85, 255}, {0, 0, 254, 255}},
    {{150, 44, 21}, {1, 255, 0, 255}},       {{29, 255, 107}, {254, 0, 0, 255}},
};

TEST(YuyvToBgra, WorkedExamples) {
  for (const Example& example : kExamples)
    for (const auto& kernel : usable(bgraKernels())) {
      Picture picture = pictureOf(32, 1, 0, 1);  // as wide as the widest step
      for (std::size_t at = 0; at < picture.bytes.size(); at += 4) {
        picture.bytes[at] = picture.bytes[at + 2] = static_cast<std::uint8_t>(example.from.y);
        picture.bytes[at + 1] = static_cast<std::uint8_t>(example.from.u);
        picture.bytes[at + 3] = static_cast<std::uint8_t>(example.from.v);
      }
      const auto bgra = bgraBy(kernel.function, picture);
      for (std::size_t at = 0; at < bgra.size(); at += 4)
        EXPECT_EQ(0, std::memcmp(&bgra[at], &example.to, 4)) << kernel.name << ", pixel " << at / 4;
    }
}

/// A grey picture whose pixel at column x, row y is 16 y + x.
TEST(YuyvToBgra, EachPixelGoesToTheOppositeSide) {
  Picture picture = pictureOf(16, 6, 0, 1);
  for (std::size_t at = 0; at < picture.bytes.size(); ++at)
    picture.bytes[at] = at % 2 == 0 ? static_cast<std::uint8_t>(at / 2) : 128;
  for (const auto& kernel : usable(bgraKernels())) {
    const auto bgra = bgraBy(kernel.function, picture);
    const auto grey = [&](int x, int y) { return bgra[4 * (16 * y + x)]; };
    EXPECT_EQ(grey(15, 5), 0) << kernel.name << ": the camera's first pixel is the last";
    EXPECT_EQ(grey(14, 5), 1) << kernel.name;
    EXPECT_EQ(grey(13, 5), 2) << kernel.name;
    EXPECT_EQ(grey(15, 4), 16) << kernel.name << ": the first of its second row";
    EXPECT_EQ(grey(0, 5), 15) << kernel.name << ": the last of its first row";
    EXPECT_EQ(grey(0, 0), 95) << kernel.name << ": its last is the first";
  }
}

TEST(YuyvToBgra, SmallAndOddSizesAndGapsBetweenRows) {
  for (int width = 1; width <= 35; ++width)
    for (int height = 1; height <= 5; ++height)
      for (const std::size_t gap : {0, 1, 4, 13}) {
        const Picture picture = pictureOf(width, height, gap, 17);
        const auto expected = expectedBgra(picture);
        for (const auto& kernel : usable(bgraKernels()))

          ASSERT_EQ(bgraBy(kernel.function, picture), expected)
              << kernel.name << ", " << width << "x" << height << ", gap " << gap;
      }
}

RC_GTEST_PROP(YuyvToBgra, AnyPictureByAnyKernel, ()) {
  const int width = *rc::gen::inRange(1, 200), height = *rc::gen::inRange(1, 8);
  const auto gap = *rc::gen::inRange<std::size_t>(0, 70);
  const Picture picture = pictureOf(width, height, gap, *rc::gen::arbitrary<std::uint32_t>());
  const auto expected = expectedBgra(picture);
  for (const auto& kernel : usable(bgraKernels())) RC_ASSERT(bgraBy(kernel.function, picture) == expected);
  RC_ASSERT(bgraBy(yuyvToBgraRotated, picture) == expected);
}

TEST(YuyvToBgra, PlainKernelComesFirstAndIsAlwaysUsable) {
  const auto kernels = bgraKernels();
  ASSERT_FALSE(kernels.empty());
  EXPECT_EQ(kernels.front().name, "scalar");
  EXPECT_TRUE(kernels.front().usable);
  for (const auto& kernel : kernels)
    if (!kernel.usable) GTEST_LOG_(INFO) << "not tried, this CPU has no " << kernel.name;
}

#ifdef __SSE2__
TEST(YuyvToBgra, TheRobotsAtomWorksWithSse2) {
  if (!__builtin_cpu_is("bonnell")) GTEST_SKIP() << "not an Atom like the robot's";
  EXPECT_EQ(usable(bgraKernels()).back().name, "sse2");
}
#endif

TEST(YuyvImage, TooFewBytesOrTooNarrowRowsAreNoWholePicture) {
  const std::vector<std::uint8_t> bytes(64);
  EXPECT_TRUE(isWhole({bytes, 8, 4, 16}));
  EXPECT_TRUE(isWhole({bytes, 7, 4, 16})) << "half a pair takes as much as a whole one";
  EXPECT_FALSE(isWhole({bytes, 9, 3, 16}));
  EXPECT_FALSE(isWhole({bytes, 8, 5, 16}));
  EXPECT_TRUE(isWhole({bytes, 4, 3, 28})) << "nothing has to follow the last row's pixels";
  EXPECT_FALSE(isWhole({std::span{bytes}.first(63), 4, 3, 28}));
  EXPECT_FALSE(isWhole({bytes, 4, 3, 29}));
  EXPECT_FALSE(isWhole({bytes, 0, 4, 16}));
  EXPECT_FALSE(isWhole({bytes, 8, 0, 16}));
}

}  // namespace
}  // namespace darwinop::pixels
