// Fault script parser: meaning and error messages.
#include "hil-mocks/fault_script.hpp"

#include <gtest/gtest.h>

#include "core/packet.hpp"

namespace darwinop::hil {
namespace {

using namespace std::chrono_literals;

InjectedFault one(const std::string& line) {
  const std::vector<InjectedFault> faults = parseFaultScript(line, "f");
  EXPECT_EQ(faults.size(), 1u) << line;
  return faults.at(0);
}

std::string errorOf(const std::string& text) {
  try {
    static_cast<void>(parseFaultScript(text, "my.faults"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(FaultScript, DeadServoByNameByIdAndSeveral) {
  const InjectedFault named = one("2.0 dead Neck for 1.5");
  EXPECT_EQ(named.kind, FaultKind::kDead);
  EXPECT_EQ(named.at, 2s);
  EXPECT_EQ(named.lasts, 1500ms);
  EXPECT_EQ(named.joints.to_ulong(), 1ul << 18);
  EXPECT_EQ(one("0 dead 19").joints, named.joints);
  EXPECT_EQ(one("0 dead 19").lasts, InjectedFault::kForEver);
  EXPECT_EQ(one("0 dead Neck+20+ShoulderR").joints.count(), 3u);
  EXPECT_TRUE(one("0 dead all").joints.all());
}

TEST(FaultScript, EveryKindHasItsArguments) {
  EXPECT_EQ(one("1 errors Head overload+overheat").bits, error_bit::kOverload | error_bit::kOverheat);
  EXPECT_EQ(one("1 heat Head 85 over 20").amount, 85);
  EXPECT_EQ(one("1 heat Head 85 over 20").over, 20s);
  EXPECT_EQ(one("1 voltage 9.8 for 3").amount, 9.8);
  EXPECT_EQ(one("1 reset").kind, FaultKind::kReset);
  EXPECT_EQ(one("1 button mode").lasts, 300ms);
  EXPECT_EQ(one("1 button mode+start for 2").bits, 3);
  EXPECT_EQ(one("1 fallen back for 2").fall, Fall::kBack);
  EXPECT_EQ(one("1 stall for 2").lasts, 2s);
  EXPECT_EQ(one("1 unplug for 0.5").lasts, 500ms);
  EXPECT_EQ(one("1 repeat-frame requests").way, Way::kRequests);
  EXPECT_EQ(one("1 delay 2.5 both chance 0.1").way, Way::kBoth);
  EXPECT_EQ(one("1 random 2 for 60").amount, 2);
  EXPECT_EQ(one("1 dead all for 0.03 boot 200").boot, 200ms);
  EXPECT_EQ(one("1 errors Head overload chance 0.2").chance, 0.2);
  EXPECT_EQ(one("1 jam 13 1.5 for 4").amount, 1.5);
  EXPECT_EQ(one("1 miss 5").amount, 5);
  EXPECT_EQ(one("1 babble 8 for 2").lasts, 2s);
  EXPECT_EQ(one("1 twins Neck+Head").joints.count(), 2u);
  EXPECT_EQ(one("1 sag 12 for 3").amount, 12);
  EXPECT_EQ(one("1 random 2 of dead+stall").kinds.count(), 2u);
}

TEST(FaultScript, AWireFaultAffectsOneFrameUnlessChanceOrTimeIsGiven) {
  EXPECT_EQ(one("1 drop 3").lasts, 0s);
  EXPECT_EQ(one("1 drop 3").way, Way::kReplies);
  EXPECT_EQ(one("1 drop 3 chance 0.5").lasts, InjectedFault::kForEver);
  EXPECT_EQ(one("1 garbage 20 chance 0.01 for 4").lasts, 4s);
  EXPECT_EQ(one("1 corrupt 1 for 4").chance, 1);
}

TEST(FaultScript, CommentsBlanksAndCrlfAreAccepted) {
  EXPECT_EQ(parseFaultScript("# a comment\n\n \t\n1 reset # why\r\n2\treset", "f").size(), 2u);
  EXPECT_EQ(parseFaultScript("", "f").size(), 0u);
}

TEST(FaultScript, ErrorsNameFileLineFieldAndExpectedValues) {
  EXPECT_EQ(errorOf("1 reset\n1 stall"), "my.faults:2: end of line: 'for SECONDS' is missing");
  EXPECT_EQ(errorOf("x reset"), "my.faults:1: field 'x': seconds from the start must be a number from 0 to 1e+06");
  EXPECT_EQ(errorOf("1 reset for 2"), "my.faults:1: field 'for': expected nothing");
  EXPECT_EQ(errorOf("1 heat Neck 300"), "my.faults:1: field '300': deg C must be a number from 0 to 255");
  EXPECT_EQ(errorOf("1 fallen up"), "my.faults:1: field 'up': expected one of: front, back, left, right");
  EXPECT_EQ(errorOf("1 button Mode"), "my.faults:1: field 'Mode': expected, joined by '+': mode, start");
  EXPECT_EQ(errorOf("1 drop 3 chance 2"), "my.faults:1: field '2': a probability must be a number from 0 to 1");
  EXPECT_EQ(errorOf("1 drop 3 sometimes"),
            "my.faults:1: field 'sometimes': expected 'for SECONDS', 'chance PROBABILITY', 'replies', "
            "'requests', 'both'");
  EXPECT_EQ(errorOf("1 explode").find("my.faults:1: field 'explode': fault kinds: dead, errors"), 0u);
  EXPECT_EQ(errorOf("1 dead Nek for 2").find("my.faults:1: field 'Nek for'"), std::string::npos);
  EXPECT_NE(errorOf("1 dead Nek").find("names: ShoulderR, ShoulderL"), std::string::npos);
  for (const char* bad : {"1", "nan reset", "inf reset", "-1 reset", "1 heat Neck", "1 heat Neck 1e999", "1 dead",
                          "1 dead Neck+", "1 dead Neck for", "1 dead Neck for 0", "1 random 2 of random", "1 drop 0",
                          "1 errors Neck 32", "1 dead 21", "1 dead 0"})
    EXPECT_NE(errorOf(bad), "none") << bad;
}

TEST(FaultScript, TooManyFaultsAreReportedWithTheLine) {
  std::string text;
  for (std::size_t i = 0; i < kMostFaults; ++i) text += "1 reset\n";
  EXPECT_EQ(parseFaultScript(text, "my.faults").size(), kMostFaults);
  EXPECT_EQ(errorOf(text + "1 reset"), "my.faults:100001: field '1': a script has at most 100000 faults");
}

}  // namespace
}  // namespace darwinop::hil
