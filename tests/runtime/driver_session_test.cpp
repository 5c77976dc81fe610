// Drive sessions on a link that records what it receives.
#include "runtime/driver_session.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace darwinop::runtime {
namespace {

using testing::HasSubstr;

struct RecordingLink final : RobotLink {
  struct State {
    Sensors image{};
    std::vector<Commands> published{};
    bool loop_runs = true, holds = false;
  };
  explicit RecordingLink(State& state) : state_{state} {}

  [[nodiscard]] Nanos period() const override { return Nanos{16'000'000}; }
  [[nodiscard]] Nanos now() const override { return Nanos{0}; }
  [[nodiscard]] bool realTime() const override { return true; }
  void publish(Commands commands) override { state_.published.push_back(commands); }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override {
    return state_.loop_runs && !stop && cycle <= state_.image.cycle;
  }
  void leaveHolding() override { state_.holds = true; }
  [[nodiscard]] Sensors sensors() const override { return state_.image; }
  [[nodiscard]] std::string whyEnded() const override { return "no loop"; }

 private:
  State& state_;
};

struct Driver : testing::Test {
  Driver() { state.image.cycle = 100; }
  const Sensors& afterCycles(std::uint64_t count) {
    state.image.cycle += count;
    return state.image;
  }

  RecordingLink::State state;
  DriverSession session{std::make_unique<RecordingLink>(state)};
};

TEST_F(Driver, ReportsFromBeforeTheSessionSayNothingAboutIt) {
  state.image.safety.state = State::kDriven;
  state.image.safety.controller_must_end = true;
  state.image.safety.worst = Fault::kBatteryEmpty;
  session.start();
  EXPECT_EQ(session.firstCycle(), 102U);
  EXPECT_FALSE(session.drives(afterCycles(1)));
  EXPECT_EQ(session.faultEnd(state.image), "");
  EXPECT_TRUE(session.drives(afterCycles(1)));
  EXPECT_THAT(session.faultEnd(state.image), HasSubstr(std::string{row(Fault::kBatteryEmpty).remedy}));
  session.start();  // the next driver on this link
  EXPECT_FALSE(session.drives(afterCycles(1)));
  EXPECT_TRUE(session.drives(afterCycles(1)));
}

TEST_F(Driver, DrivesOnlyInTheStateDriven) {
  session.start();
  (void)afterCycles(2);
  for (std::size_t i = 0; i < kStates; ++i) {
    state.image.safety.state = static_cast<State>(i);
    EXPECT_EQ(session.drives(state.image), state.image.safety.state == State::kDriven) << kStateNames[i];
  }
}

TEST_F(Driver, AFaultIsNamedWithItsJoint) {
  SafetyReport report;
  report.worst = Fault::kBatteryEmpty;
  EXPECT_THAT(describe(report), Not(HasSubstr(", id ")));
  report.worst_joint = 14;
  EXPECT_THAT(describe(report), HasSubstr(" (LegLowerL, id 14); "));
}

TEST_F(Driver, TheEndOfTheLoopHasAReason) {
  session.start();
  EXPECT_EQ(session.loopEnd(state.image), "");
  state.loop_runs = false;
  EXPECT_EQ(session.loopEnd(state.image), "no loop");
}

TEST_F(Driver, HoldsWithItsLastCommandsOrEndsTheSession) {
  session.start();
  Commands last;
  last.unattended = true;
  session.hold(last);
  EXPECT_TRUE(state.holds);
  EXPECT_FALSE(state.published.back().end_of_session);
  EXPECT_TRUE(state.published.back().unattended);
  state.holds = false;
  session.end(last);
  EXPECT_FALSE(state.holds);
  EXPECT_TRUE(state.published.back().end_of_session);
  EXPECT_TRUE(state.published.back().unattended);
}

}  // namespace
}  // namespace darwinop::runtime
