// Drive sessions on a link that records what it receives.
#include "runtime/driver_session.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "simulated_robot.hpp"

namespace darwinop::runtime {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kWhyEnded = "the test's reason";

struct RecordingLink final : RobotLink {
  struct State {
    Sensors image{};
    std::vector<Commands> published{};
    std::uint64_t waited_for = 0;
    bool loop_runs = true, holds = false;
    std::size_t published_before_hold = 0;
  };
  explicit RecordingLink(State& state) : state_{state} {}

  [[nodiscard]] Nanos period() const override { return Nanos{16'000'000}; }
  [[nodiscard]] Nanos now() const override { return Nanos{0}; }
  [[nodiscard]] bool realTime() const override { return true; }
  void publish(Commands commands) override { state_.published.push_back(commands); }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override {
    state_.waited_for = cycle;
    return state_.loop_runs && !stop && cycle <= state_.image.cycle;
  }
  void leaveHolding() override {
    state_.holds = true;
    state_.published_before_hold = state_.published.size();
  }
  [[nodiscard]] Sensors sensors() const override { return state_.image; }
  [[nodiscard]] std::string whyEnded() const override { return kWhyEnded; }

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
  state.image.safety.controller_must_end = false;
  EXPECT_EQ(session.faultEnd(state.image), "") << "a fault that ends no session";
  session.start();  // the next driver on this link
  EXPECT_FALSE(session.drives(afterCycles(1)));
  EXPECT_TRUE(session.drives(afterCycles(1)));
}

/// A busy computer may stop us between the two calls: the report is still about the session before, which was given up.
TEST_F(Driver, CyclesBeforeItsFirstCommandsSayNothingOfIt) {
  state.image.safety.controller_must_end = true;
  state.image.safety.worst = Fault::kControllerGone;
  session.start();
  (void)afterCycles(5);
  session.publish({});
  EXPECT_EQ(session.faultEnd(afterCycles(1)), "");
  EXPECT_NE(session.faultEnd(afterCycles(1)), "");
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
  const std::uint8_t no_joint = kJoints + 1;
  for (const std::uint8_t none : {std::uint8_t{0}, no_joint}) {
    report.worst_joint = none;
    EXPECT_THAT(describe(report), Not(HasSubstr(", id "))) << int{none};
  }
  report.worst_joint = 14;
  EXPECT_THAT(describe(report), HasSubstr(" (LegLowerL, id 14); "));
  report.worst_joint = kJoints;
  EXPECT_THAT(describe(report), HasSubstr(" (Head, id 20); "));
  report.worst_joint = 1;
  EXPECT_THAT(describe(report), StartsWith(std::string{row(Fault::kBatteryEmpty).meaning} + " (ShoulderR, id 1); "));
  EXPECT_THAT(describe(report), EndsWith(row(Fault::kBatteryEmpty).remedy));
}

TEST_F(Driver, WaitsForTheCycleUntilItIsAskedToStop) {
  EXPECT_TRUE(session.waitForCycle(100));
  EXPECT_EQ(state.waited_for, 100U);
  EXPECT_FALSE(session.waitForCycle(101));
  std::atomic<bool> stop{false};
  EXPECT_TRUE(session.waitForCycle(99, stop));
  EXPECT_EQ(state.waited_for, 99U);
  stop = true;
  EXPECT_FALSE(session.waitForCycle(99, stop));
}

TEST_F(Driver, TheEndOfTheLoopHasAReason) {
  session.start();
  EXPECT_EQ(session.loopEnd(state.image), "");
  EXPECT_EQ(state.waited_for, 100U) << "a later cycle would block";
  state.loop_runs = false;
  EXPECT_EQ(session.loopEnd(state.image), kWhyEnded);
}

TEST_F(Driver, HoldsWithItsLastCommandsOrEndsTheSession) {
  session.start();
  state.image.safety.state = State::kDriven;
  Commands last;
  last.unattended = true;
  session.publish(last);
  session.hold(last);
  EXPECT_TRUE(state.holds);
  EXPECT_EQ(state.published_before_hold, 2U) << "a link may send only what was published before";
  EXPECT_TRUE(state.published.back().hold);
  EXPECT_FALSE(last.hold) << "the caller may publish them again, in a session that drives";
  EXPECT_FALSE(state.published.back().end_of_session);
  EXPECT_TRUE(state.published.back().unattended);
  state.holds = false;
  session.end(last);
  EXPECT_FALSE(state.holds);
  EXPECT_TRUE(state.published.back().end_of_session);
  EXPECT_TRUE(state.published.back().unattended);
}

TEST_F(Driver, HoldingBeforeTheFirstCommandsPublishesNothing) {
  session.start();
  Commands commands;
  session.hold(commands);
  EXPECT_TRUE(state.published.empty()) << "no session has begun";
  EXPECT_FALSE(state.holds);
}

/// Goal of a joint that is held at `position` on its way to `commanded`; its age in cycles.
struct HeldJoint {
  const char* why;
  std::uint32_t age;
  double position, commanded, goal;
};

TEST_F(Driver, HoldsAJointThatMovesAtItsPositionAndOneAtRestAtItsGoal) {
  session.start();
  session.publish({});
  for (const HeldJoint& held : {
           HeldJoint{"on its way", 3, 0.3, 1.0, 0.3},
           {"on its way back", 0, 0.3, -1.0, 0.3},
           {"at rest: it must not sag", 0, 0.3, 0.39, 0.39},
           {"its position is old", 4, 0.3, 1.0, 1.0},
       }) {
    JointSensors& neck = state.image.joint[index(Joint::kNeck)];
    neck.motion.received();
    neck.motion.age = held.age;
    neck.position = Rad{held.position};
    neck.commanded = Rad{held.commanded};
    Commands commands;
    commands.joint[index(Joint::kNeck)].setGoal(Rad{2});
    session.hold(commands);
    EXPECT_EQ(state.published.back().joint[index(Joint::kNeck)].goal, Rad{held.goal}) << held.why;
    EXPECT_EQ(commands.joint[index(Joint::kNeck)].goal, Rad{held.goal}) << "the caller may publish them again";
  }
}

TEST_F(Driver, GivesAJointWithoutAGoalNoneToHold) {
  session.start();
  state.image.safety.state = State::kDriven;
  Commands commands;
  session.publish(commands);
  session.hold(commands);
  for (const JointCommand& joint : state.published.back().joint) EXPECT_FALSE(joint.has(JointCommand::kGoal));
}

TEST(DriverOnAnExchange, EachDriverButTheFirstBeginsANewSession) {
  SimulatedRobot robot;
  DriverSession session{std::move(robot.link)};
  const auto session_after_start = [&] {
    session.start();
    session.publish({});
    EXPECT_TRUE(session.waitForCycle(session.firstCycle()));
    return session.sensors().safety.session;
  };
  EXPECT_EQ(session_after_start(), 1U) << "begun by the link";
  EXPECT_EQ(session_after_start(), 2U);
}

}  // namespace
}  // namespace darwinop::runtime
