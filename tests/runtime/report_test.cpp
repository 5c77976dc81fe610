// The report line that scripts read, and the text for people.
#include "runtime/report.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

using testing::HasSubstr;

Sensors allFresh() {
  Sensors s;
  s.cycle = 10;
  s.period_ns = 16'000'000;
  s.board.motion.received();
  s.board.voltage = Volt{11.8};
  for (JointSensors& joint : s.joint) joint.motion.received();
  return s;
}

StatsView statsOf(const Sensors& sensors, int cycles, LoopStats::Timed timed) {
  const auto stats = std::make_unique<LoopStats>();
  for (int i = 0; i < cycles; ++i) stats->account(sensors, 0, timed);
  StatsView view;
  stats->copyTo(view);
  return view;
}

TEST(Report, LineHasItsFixedNamesInFixedOrder) {
  Sensors s = allFresh();
  s.wake_latency_ns = 34'000;
  s.wire = {258, 276, 500'000, 400'000};
  s.link.retries = 7;
  EXPECT_EQ(reportLine(statsOf(s, 625, LoopStats::Timed::kYes), s),
            "report: cycles=625 overruns=0 wake_p50_us=34 wake_p99_us=34 wake_max_us=34 bus_ms_median=0.400 "
            "wire_ms=0.500 bus_ratio=0.800 retries=7 stale=0");
}

TEST(Report, LineSaysNanForWhatWasNotMeasured) {
  const Sensors s = allFresh();
  EXPECT_EQ(reportLine(statsOf(s, 3, LoopStats::Timed::kNo), s),
            "report: cycles=3 overruns=0 wake_p50_us=nan wake_p99_us=nan wake_max_us=nan bus_ms_median=nan "
            "wire_ms=nan bus_ratio=nan retries=0 stale=0");
}

TEST(Report, CountsStaleDevicesInTheLineAndNamesThemInTheText) {
  Sensors s = allFresh();
  s.joint[index(Joint::kNeck)].motion.age = Freshness::kStale;
  s.joint[index(Joint::kHead)].motion.age = Freshness::kStale - 1;  // a few losses are ignored
  s.joint[index(Joint::kFootL)].motion = Freshness{};               // never received
  const StatsView stats = statsOf(s, 3, LoopStats::Timed::kYes);
  EXPECT_THAT(reportLine(stats, s), HasSubstr(" stale=2"));
  EXPECT_THAT(reportText(stats, s), HasSubstr("stale devices FootL, Neck\n"));
}

TEST(Report, WithoutABoardNothingOfItIsStaleAndServoPowerIsUnknown) {
  Sensors s = allFresh();
  s.board = {};
  EXPECT_THAT(reportText(statsOf(s, 3, LoopStats::Timed::kYes), s), HasSubstr("stale devices CM-730\n"));
  s.board.absent = true;
  EXPECT_THAT(reportText(statsOf(s, 3, LoopStats::Timed::kYes), s), HasSubstr("stale devices none\n"));
  EXPECT_THAT(robotText(s), HasSubstr(messages::kNoBoard));
}

TEST(Report, TextSaysSoWhenNoCycleHasRun) {
  EXPECT_EQ(reportText(StatsView{}, Sensors{}), messages::kNoCycle);
  EXPECT_THAT(reportLine(StatsView{}, Sensors{}), HasSubstr("cycles=0 "));
}

TEST(Report, RobotTextNamesFaultJointAndRemedy) {
  Sensors s = allFresh();
  s.safety.state = State::kKneeling;
  s.safety.worst = Fault::kServoOverload;
  s.safety.worst_joint = 13;
  for (std::size_t i = 0; i < kFaults; ++i) s.safety.active[i] = kFaultTable[i].fault == Fault::kServoOverload;
  const std::string text = robotText(s);
  EXPECT_THAT(text, HasSubstr("kneeling"));
  EXPECT_THAT(text, HasSubstr("24 servo_overload"));
  EXPECT_THAT(text, HasSubstr("(LegLowerR)"));
  EXPECT_THAT(text, HasSubstr(std::string{row(Fault::kServoOverload).remedy}));
  EXPECT_THAT(text, HasSubstr("11.8 V"));
}

}  // namespace
}  // namespace darwinop::runtime
