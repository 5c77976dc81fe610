// Numbers to text: as printf writes them in the C locale.
#include "core/text/number_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>

namespace darwinop::text {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr std::array kValues{0.0, -0.0, 0.5, -1.25, 2.675, 123456.789, 1e-7, -3e20, kMax, -kMax, 5e-324};

std::string printed(const char* format, int digits, double value) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), format, digits, value);
  return text.data();
}

TEST(NumberText, IsThatOfPrintf) {
  for (const double value : kValues)
    for (const int digits : {0, 1, 3, 9}) {
      EXPECT_EQ(fixedText(value, digits), printed("%.*f", digits, value));
      EXPECT_EQ(generalText(value, digits), printed("%.*g", digits, value));
    }
}

TEST(NumberText, TheShortestReadsBackAsTheSameNumber) {
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(shortestText(1e-7), "1e-07");
  for (const double value : kValues) EXPECT_EQ(numberFromText(shortestText(value)), value);
}

TEST(NumberText, NotANumberHasNoSign) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {nan, -nan}) {
    EXPECT_EQ(fixedText(value, 2), "nan");
    EXPECT_EQ(generalText(value, 2), "nan");
    EXPECT_EQ(shortestText(value), "nan");
  }
}

TEST(NumberText, SecondsAreWholeAndCut) {
  EXPECT_EQ(inSeconds(std::chrono::milliseconds{5999}), "5 s");
  EXPECT_EQ(inSeconds(std::chrono::minutes{10}), "600 s");
}

}  // namespace
}  // namespace darwinop::text
