// Colour filter: all variants are equal to the reference rules.
#include "managers/vision/colour_filter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <random>
#include <span>

#include "managers/vision/classify.hpp"
#include "managers/vision/naive.hpp"

namespace darwinop::vision {
namespace {

naive::Rule ruleOf(const Thresholds& t) {
  return {t.hue, t.hue_tolerance, t.min_saturation, t.min_value};
}

std::vector<Instructions> usable() {
  std::vector<Instructions> all;
  for (const Instructions one : kAllInstructions)
    if (canUse(one)) all.push_back(one);
  return all;
}

/// Every colour, BGRA, in rows of one red value each.
constexpr int kRow = 1 << 16;
const std::vector<std::uint8_t>& rowOf(int red) {
  static std::vector<std::uint8_t> row = [] {
    std::vector<std::uint8_t> bytes(4 * kRow, 255);
    for (std::size_t i = 0; i < kRow; ++i) {
      bytes[4 * i] = static_cast<std::uint8_t>(i);
      bytes[4 * i + 1] = static_cast<std::uint8_t>(i >> 8);
    }
    return bytes;
  }();
  for (std::size_t i = 0; i < kRow; ++i) row[4 * i + 2] = static_cast<std::uint8_t>(red);
  return row;
}

/// HSV of every pixel of such a row, computed once for all thresholds.
std::vector<naive::Colour> coloursOf(int red) {
  std::vector<naive::Colour> colours;
  colours.reserve(kRow);
  for (int i = 0; i < kRow; ++i) colours.push_back(naive::convert(red, i >> 8, i & 255));
  return colours;
}

std::string text(const Thresholds& t) {
  return std::to_string(t.hue) + " +- " + std::to_string(t.hue_tolerance) + ", saturation above " +
         std::to_string(t.min_saturation) + ", value above " + std::to_string(t.min_value);
}

/// Compares all classifiers with the rules on the colours of one red value. Thresholds that match nothing are handled
/// by the finder.
void compareRow(int red, std::span<const Thresholds> sets) {
  const std::vector<std::uint8_t>& row = rowOf(red);
  const std::vector<naive::Colour> colours = coloursOf(red);
  std::vector<std::uint64_t> expected(kRow / 64), got(kRow / 64);
  for (const Thresholds& wanted : sets) {
    const naive::Rule rule = ruleOf(wanted);
    std::ranges::fill(expected, 0);
    const ColourTest test = compile(wanted);
    for (std::size_t i = 0; i < kRow; ++i)
      if (naive::passes(colours[i], rule)) expected[i / 64] |= std::uint64_t{1} << (i % 64);
    for (const Instructions instructions : usable()) {
      if (test.nothing) {
        ASSERT_TRUE(std::ranges::all_of(expected, [](std::uint64_t word) { return word == 0; })) << text(wanted);
        break;
      }
      classifierFor(instructions)(test, row.data(), kRow, got.data());
      ASSERT_EQ(got, expected) << text(wanted) << ", red " << red << ", instructions " << int(instructions);
    }
  }
}

TEST(ColourFilter, EveryVariantEqualsTheRulesForEveryColour) {
  // Default, an example, an arc through 0, greys, and all but a few degrees, once those of grey.
  constexpr auto kSets = std::to_array<Thresholds>({{},
                                                    {28, 20, 50, 45},
                                                    {0, 170, 0, 0},
                                                    {15, 3, -1, -1},
                                                    {180, 179, 99, 99},
                                                    {195, 179, -1, -1},
                                                    {211, 1, -1, 37}});
  for (int red = 0; red < 256; ++red) compareRow(red, kSets);
}

// Each degree and each minimum separately; their combination is tested above. Two red values per degree.
TEST(ColourFilter, EveryDegreeAndEveryMinimumIsExact) {
  for (int i = 0; i <= 360; ++i) {
    const Thresholds degree{i, 1, -1, -1}, rest{i, 179, -1, -1}, minimum{180, 180, i % 102 - 1, (i * 7) % 102 - 1};
    const std::array sets{degree, rest, minimum};
    compareRow(i * 37 % 256, sets);
  }
}

RC_GTEST_PROP(ColourFilter, AnyThresholdsAgreeWithTheRules, ()) {
  Thresholds wanted;
  wanted.hue = *rc::gen::inRange(0, 361);
  wanted.hue_tolerance = *rc::gen::inRange(0, 181);
  wanted.min_saturation = *rc::gen::inRange(-2, 102);
  wanted.min_value = *rc::gen::inRange(-2, 102);
  const int red = *rc::gen::inRange(0, 256);
  const std::array sets{wanted};
  compareRow(red, sets);
  for (int i = 0; i < 256; ++i) {
    const int g = i * 101 % 256, b = i;
    RC_ASSERT(matches(toHsv(static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)),
                      wanted) == naive::passes(naive::convert(red, g, b), ruleOf(wanted)));
  }
}

TEST(ColourFilter, AnArcContainsTheseHues) {
  const auto count = [](int hue, int tolerance) {
    int hues = 0;
    for (int h = 0; h < 360; ++h) hues += HueArc{Thresholds{hue, tolerance}}.contains(h) ? 1 : 0;
    return hues;
  };
  EXPECT_EQ(count(100, 0), 0) << "both bounds are excluded";
  EXPECT_EQ(count(100, 1), 1);
  EXPECT_EQ(count(356, 15), 29);
  EXPECT_EQ(count(100, 179), 357);
  EXPECT_EQ(count(0, 180), 0) << "both bounds are 180";
  EXPECT_EQ(count(100, 180), 0);
  EXPECT_EQ(count(180, 180), 359) << "360 is kept: all but 0";
  EXPECT_EQ(count(345, 15), 29) << "up to 360, exclusive, so without 0";
  EXPECT_FALSE((HueArc{Thresholds{345, 15}}.contains(0)));
  EXPECT_TRUE((HueArc{Thresholds{346, 15}}.contains(0)));
}

TEST(ColourFilter, BothMinimaAreExcluded) {
  EXPECT_FALSE(matches({0, 50, 80}, {0, 15, 50, 10}));
  EXPECT_TRUE(matches({0, 51, 80}, {0, 15, 50, 10}));
  EXPECT_FALSE(matches({0, 80, 10}, {0, 15, 50, 10}));
  EXPECT_TRUE(matches({0, 80, 11}, {0, 15, 50, 10}));
  EXPECT_FALSE(matches({0, 100, 100}, {0, 15, 100, 10})) << "nothing exceeds 100 %";
}

TEST(ColourFilter, GreyIsHue15IfBothMinimaAreBelowZero) {
  const Hsv grey = toHsv(90, 90, 90);
  EXPECT_TRUE(matches(grey, {15, 1, -1, -1}));
  EXPECT_FALSE(matches(grey, {200, 20, -1, -1}));
  EXPECT_FALSE(matches(grey, {15, 1, 0, -1}));
  EXPECT_FALSE(matches(grey, {15, 1, -1, 0}));
}

TEST(ColourFilter, NumbersFarOutOfRangeDoNotOverflow) {
  constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  EXPECT_TRUE(compile({kMost, kMost, kMost, kMost}).nothing);
  const ColourTest all = compile({180, 180, kLeast, kLeast});
  EXPECT_TRUE(passes(all, 7, 8, 9));
  EXPECT_TRUE(passes(all, 7, 7, 7));
  EXPECT_FALSE(compile({kLeast, kMost, 0, 0}).nothing);
}

// Rows of any length: last pixels and padding.
TEST(ColourFilter, RowsOfAnyLengthHaveZeroPadding) {
  std::mt19937 rng{1};
  const ColourTest test = compile({15, 100, -1, -1});
  for (int width = 1; width <= 200; ++width) {
    std::vector<std::uint8_t> bgra(
        4 * static_cast<std::size_t>(width));  // exact size, so that the sanitizer detects reads beyond it
    for (std::uint8_t& byte : bgra) byte = static_cast<std::uint8_t>(rng() % 4);
    const std::size_t words = (static_cast<std::size_t>(width) + 63) / 64;
    std::vector<std::uint64_t> expected(words);
    for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i)
      if (passes(test, bgra[4 * i + 2], bgra[4 * i + 1], bgra[4 * i])) expected[i / 64] |= std::uint64_t{1} << (i % 64);
    for (const Instructions instructions : usable()) {
      std::vector<std::uint64_t> got(words + 1, 0xAAAA);
      classifierFor(instructions)(test, bgra.data(), width, got.data());
      EXPECT_EQ(got.back(), 0xAAAAu) << "written beyond the row";
      got.pop_back();
      EXPECT_EQ(got, expected) << width << " pixels, instructions " << int(instructions);
    }
  }
}

}  // namespace
}  // namespace darwinop::vision
