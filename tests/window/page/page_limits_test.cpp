// Numbers that the page has as well: those of window/page/src/limits.js are the program's.
#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

#include "core/servo_limits.hpp"
#include "core/units.hpp"
#include "safety/start_pose.hpp"
#include "support/text_of.hpp"

namespace darwinop::window {
namespace {

/// What follows "NAME = ", up to the semicolon.
std::string onPage(const std::string& name) {
  const std::string text = textOf(DARWINOP_PAGE_SOURCES "/limits.js");
  std::smatch found;
  return std::regex_search(text, found, std::regex{"\\b" + name + " = ([^;]*);"}) ? found[1].str() : "";
}

double numberOnPage(const std::string& name) {
  const std::string text = onPage(name);
  return text.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(text);
}

TEST(PageLimits, AreThoseOfTheProgram) {
  EXPECT_EQ(numberOnPage("kGravity"), kGravity);
  EXPECT_EQ(numberOnPage("kServoHot"), kServoHotC);
  EXPECT_NEAR(numberOnPage("kStartTolerance"), safety::kStartPoseTolerance, 5e-5);  // four decimals
  EXPECT_EQ(onPage("kOrientationTolerance"), "kGravity / 4");
  EXPECT_EQ(safety::kOrientationTolerance, kGravity / 4);
}

}  // namespace
}  // namespace darwinop::window
