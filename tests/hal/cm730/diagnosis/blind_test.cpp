// Blind test of the doctor: a seed draws a fault and its place, the doctor names one.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "hal/cm730/diagnosis/drawn_robot.hpp"
#include "hal/cm730/diagnosis/rows.hpp"

namespace darwinop::cm730 {
namespace {

/// DARWINOP_SEED draws others.
std::uint64_t firstSeed() {
  constexpr std::uint64_t kUsual = 20261126;
  const char* const text = std::getenv("DARWINOP_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : kUsual;
}
constexpr int kDraws = 240, kHealthy = 200;
constexpr double kMustBeRight = 0.95;

std::string textOf(const DoctorResult& result) {
  std::string text;
  for (const NamedFault& fault : result.named) text += toText(fault);
  for (const Finding& row : result.report.findings)
    if (row.level != Level::kOk) text += toText(row);
  return text;
}

/// The fault, its place and a remedy without unfilled names.
bool isRight(const RobotDraw& drawn, const DoctorResult& result) {
  if (result.named.empty() || result.named.front().fault != drawn.fault) return false;
  const NamedFault& first = result.named.front();
  if (first.joints != drawn.joints || (drawn.other && first.other != drawn.other)) return false;
  const std::string text = first.what + first.remedy;
  for (const char* word : {"PORT", "SERVO", "OTHER", "FROM"})
    if (text.find(word) != std::string::npos) return false;
  return !first.remedy.empty();
}

std::string expectation(const RobotDraw& drawn) {
  std::string text{row(*drawn.fault).name};
  forEachJoint(drawn.joints, [&](std::size_t i) { text += " " + std::to_string(servoId(i)); });
  if (drawn.other) text += " with " + std::to_string(row(*drawn.other).id);
  return text;
}

TEST(DoctorBlindTest, DrawsWhatTheTableSays) {
  std::set<BusFault> drawn;
  for (const DrawnFault& fault : kDrawnFaults) drawn.insert(fault.named);
  for (const BusFaultRow& fault : kBusFaultTable)
    EXPECT_EQ(!fault.shown.empty(), drawn.contains(fault.fault)) << fault.name;
}

TEST(DoctorBlindTest, NamesTheDrawnFaultItsPlaceAndTheRemedy) {
  const std::uint64_t seed = firstSeed();
  Rng rng{seed};
  int right = 0;
  std::map<std::string_view, std::pair<int, int>> by_fault;  // right, drawn
  std::string wrong;
  for (int i = 0; i < kDraws; ++i) {
    const DrawnFault& fault = kDrawnFaults[rng.below(kDrawnFaults.size())];
    const RobotDraw drawn = drawFault(fault, rng);
    const DoctorResult result = examine(drawn, rng.next());
    const bool named = isRight(drawn, result);
    right += named ? 1 : 0;
    by_fault[fault.name].first += named ? 1 : 0;
    ++by_fault[fault.name].second;
    if (!named)
      wrong += "draw " + std::to_string(i) + ", " + std::string{fault.name} + ", " + expectation(drawn) + ":\n" +
               textOf(result);
  }
  std::printf("seed %llu: %d of %d named right\n", static_cast<unsigned long long>(seed), right, kDraws);
  for (const auto& [name, count] : by_fault)
    std::printf("  %-28.*s %d of %d\n", static_cast<int>(name.size()), name.data(), count.first, count.second);
  std::printf("%s", wrong.c_str());
  EXPECT_GE(right, kMustBeRight * kDraws);
  EXPECT_EQ(by_fault.size(), kDrawnFaults.size()) << "each fault is drawn";
  for (const auto& [name, count] : by_fault) EXPECT_GE(2 * count.first, count.second) << name;
}

TEST(DoctorBlindTest, FindsNothingOnAHealthyRobot) {
  const std::uint64_t seed = firstSeed() + 1;
  Rng rng{seed};
  for (int i = 0; i < kHealthy; ++i) {
    const RobotDraw drawn = drawHealthy(rng);
    const DoctorResult result = examine(drawn, rng.next());
    EXPECT_TRUE(result.named.empty() && worst(result.report.findings) == Level::kOk)
        << "seed " << seed << ", robot " << i << ":\n"
        << textOf(result);
  }
}

}  // namespace
}  // namespace darwinop::cm730
