// Servos that restart while they are driven. Judged at the servo: when its torque comes on, its goal is where it is
// and it has a speed limit, whatever our own bookkeeping says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

#include "safety/wire_rig.hpp"
#include "support/falling_body.hpp"

namespace darwinop {
namespace {

using std::chrono::milliseconds;

constexpr double kAtTheGoal = 9 * kRadPerTick;

std::string describe(const FallingBody::TorqueOn& edge) {
  return std::string{row(edge.joint).name} + ": goal " + std::to_string(edge.off) + " rad off, speed limit " +
         std::to_string(edge.speed_limit) + " rad/s; ";
}

/// What is wrong with the edges seen so far; empty: nothing.
std::string judge(const FallingBody& body) {
  std::string wrong;
  for (const FallingBody::TorqueOn& edge : body.torqueOn())
    if (std::abs(edge.off) > kAtTheGoal || std::isinf(edge.speed_limit)) wrong += describe(edge);
  return wrong;
}

std::bitset<kJoints> chain(Chain which) {
  std::bitset<kJoints> joints;
  for (std::size_t i = 0; i < kJoints; ++i) joints[i] = kJointTable[i].chain == which;
  return joints;
}

struct FallingRig {
  explicit FallingRig(Nanos boot) : FallingRig{std::make_unique<FallingBody>(), boot} {}

  FallingBody& body;
  WireRig rig;

  /// Joints swing about the middle of their range, each with its own phase.
  void move(double amplitude) {
    for (std::size_t i = 0; i < kJoints; ++i) {
      const double middle = radFromTicks((kJointTable[i].low + kJointTable[i].high) / 2).value;
      const double phase = static_cast<double>(rig.seen().cycle) * 0.1 + static_cast<double>(i);
      rig.commands.joint[i].setGoal(Rad{middle + amplitude * std::sin(phase)});
    }
  }
  void run(int cycles, double amplitude) {
    for (int i = 0; i < cycles; ++i) {
      if (amplitude > 0) move(amplitude);
      rig.cycle();
    }
  }

 private:
  FallingRig(std::unique_ptr<FallingBody> made, Nanos boot) : body{*made}, rig{std::move(made), bootsIn(boot)} {}
};

struct Group {
  const char* name;
  std::bitset<kJoints> joints;
};

class ServosThatRestartTogether : public ::testing::TestWithParam<Group> {};
INSTANTIATE_TEST_SUITE_P(Restart, ServosThatRestartTogether,
                         ::testing::Values(Group{"OneKnee", std::bitset<kJoints>{}.set(index(Joint::kLegLowerL))},
                                           Group{"ALegChain", chain(Chain::kLeftLeg)},
                                           Group{"BothLegs", chain(Chain::kLeftLeg) | chain(Chain::kRightLeg)},
                                           Group{"TheServoRail", std::bitset<kJoints>{}.set()}),
                         [](const auto& group) { return std::string{group.param.name}; });

TEST_P(ServosThatRestartTogether, GetTorqueWhereTheyAreAndWithASpeedLimit) {
  FallingRig falling{milliseconds{200}};
  falling.run(300, 0);
  ASSERT_EQ(falling.rig.state(), State::kDriven);
  falling.body.arm();
  falling.rig.cutSupply(GetParam().joints, falling.rig.memory.now(), milliseconds{30});
  falling.run(250, 0);
  EXPECT_EQ(judge(falling.body), "");
  EXPECT_EQ(falling.body.torqueOn().size(), GetParam().joints.count());
  EXPECT_TRUE(falling.rig.allDriven()) << "all of them are back";
}

/// Random sets of servos lose their supply while they are driven. Returns what is wrong; empty: nothing.
std::string cutSuppliesAtRandom(std::uint32_t seed) {
  std::mt19937 random{seed};
  const auto between = [&](int low, int high) { return std::uniform_int_distribution{low, high}(random); };
  // A servo that is back within 24 ms need not have missed a request; that is the test after this one.
  // Half of the time all is over soon, when a goal may go out before anybody has given the servo up.
  const int longest = between(0, 1) == 0 ? 60 : 500;
  const int boot_ms = between(5, longest);
  FallingRig falling{milliseconds{boot_ms}};
  const double amplitude = between(0, 1) == 0 ? 0 : 0.3;
  falling.run(100, amplitude);
  falling.body.arm();
  for (int fault = 0; fault < 3; ++fault) {
    std::bitset<kJoints> joints;
    const int kind = between(0, 2);
    if (kind == 0) joints.set();
    if (kind == 1) joints = chain(static_cast<Chain>(between(0, 4)));
    if (kind == 2) joints = std::bitset<kJoints>{random()};
    const Nanos at = falling.rig.memory.now() + std::chrono::microseconds{between(0, 32'000)};
    const milliseconds lasts{between(std::max(5, 24 - boot_ms), longest)};
    falling.rig.cutSupply(joints, at, lasts);
    falling.run(between(1, 120), amplitude);
  }
  falling.run(200, amplitude);
  return judge(falling.body) + (falling.rig.allDriven() ? "" : "not all are back");
}

// DARWINOP_SEED=… repeats a run, DARWINOP_RESTARTS=1000 makes it a long one.
TEST(Restart, AnySetOfServosThatLosesItsSupplyComesBackWhereItIs) {
  const char* const seed_text = std::getenv("DARWINOP_SEED");
  const char* const runs_text = std::getenv("DARWINOP_RESTARTS");
  const auto seed =
      seed_text ? static_cast<std::uint32_t>(std::strtoul(seed_text, nullptr, 10)) : std::random_device{}();
  const std::uint32_t runs = runs_text ? static_cast<std::uint32_t>(std::strtoul(runs_text, nullptr, 10)) : 40;
  std::cout << "seed " << seed << '\n';
  for (std::uint32_t i = 0; i < runs; ++i) ASSERT_EQ(cutSuppliesAtRandom(seed + i), "") << "DARWINOP_SEED=" << seed + i;
}

TEST(Restart, AServoThatWasBackTooSoonToBeMissedHasItsSpeedLimitAgainWithinOneRoundOfPolls) {
  FallingRig falling{Nanos{0}};
  falling.run(300, 0);
  const auto knee = std::bitset<kJoints>{}.set(index(Joint::kLegLowerL));
  // Between its answer and the next write: nothing can be seen of it before that.
  falling.rig.cutSupply(knee, falling.rig.release + milliseconds{9}, milliseconds{3});
  const auto& table = falling.rig.robot.board().servo(Joint::kLegLowerL).table();
  falling.run(2, 0);
  ASSERT_EQ(table.word(servo::kMovingSpeed), 0) << "it has restarted";
  falling.run(kJoints + 5, 0);
  EXPECT_GT(table.word(servo::kMovingSpeed), 0);
  EXPECT_EQ(table.byte(servo::kTorqueEnable), 1);
  EXPECT_TRUE(falling.rig.seen().safety.active.none());
}

/// Replies of one servo are spoilt, cycle by cycle.
class SpoiltLine final : public ByteLine {
 public:
  explicit SpoiltLine(ByteLine& inner, std::uint8_t id) : inner_{inner}, id_{id} {}
  std::uint8_t add_bits = 0;  // to the error byte
  bool lose = false;

  [[nodiscard]] Nanos now() noexcept override { return inner_.now(); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override { return inner_.write(bytes); }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    for (;;) {
      const LineStatus status = inner_.read(into, count, deadline);  // one status frame
      if (status != LineStatus::kOk || count < 6 || into[2] != id_) return status;
      if (lose) continue;
      into[4] |= add_bits;
      into[count - 1] = checksum(Bytes{into.data() + 2, count - 3});
      return status;
    }
  }
  void discardInput() noexcept override { inner_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return inner_.reconnects(); }

 private:
  ByteLine& inner_;
  std::uint8_t id_;
};

/// An arm is limp, is moved by hand, and is asked to stay there. Torque is switched on while its replies are spoilt.
struct ArmTakenOver {
  explicit ArmTakenOver(std::uint32_t seed) : random{seed} {}

  static constexpr Joint kArm = Joint::kShoulderR;
  std::mt19937 random;
  std::unique_ptr<hil::PlainBody> made = std::make_unique<hil::PlainBody>();
  hil::PlainBody& body = *made;
  hil::VirtualRobot robot{{}, 1, std::move(made)};
  hil::MemoryLine memory{robot};
  SpoiltLine line{memory, row(kArm).id};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(WireRig::kPeriod)};
  safety::Guard guard{safety::Config{}};
  runtime::Cycle loop{bus, guard, WireRig::kPeriod};
  Commands commands{};
  Nanos release{0};
  double fastest = 0;

  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      release += WireRig::kPeriod;
      memory.advanceTo(release);
      ++commands.sequence;
      loop.run(commands, {.release = release});
      fastest = std::max(fastest, std::abs(body.state().joint[index(kArm)].velocity_rad_s));
    }
  }
  void until(double goal, bool torque, int cycles) {
    commands.joint[index(kArm)] = {};
    commands.joint[index(kArm)].setGoal(Rad{goal});
    commands.joint[index(kArm)].setTorque(torque);
    run(cycles);
  }
  void takeOverUnderFaults(bool worst_case) {
    commands.session = 1;
    commands.start_where_it_is = true;
    until(1.5, true, 300);
    until(1.5, false, 50);
    body.place(kArm, -1.2);
    run(50);
    fastest = 0;
    until(-1.2, true, 1);
    for (int i = 0; i < 12; ++i) {
      line.lose = worst_case ? i > 0 && i <= 4 : random() % 2 == 0;
      line.add_bits = (worst_case ? i == 0 : random() % 3 == 0) ? error_bit::kOverheat : std::uint8_t{0};
      run(1);
    }
    line.lose = false;
    line.add_bits = 0;
    run(200);
  }
};

TEST(Restart, ASuspectedServoGetsNoTorqueOnBeforeItsGoalHasGoneOut) {
  ArmTakenOver arm{1};
  arm.takeOverUnderFaults(true);
  EXPECT_LT(arm.fastest, 0.3) << "asked to stay where it is";
  EXPECT_NEAR(arm.body.state().joint[index(ArmTakenOver::kArm)].position_rad, -1.2, 0.02);
}

TEST(Restart, AJointThatIsAskedToStayStaysWhateverHappensToItsReplies) {
  for (std::uint32_t seed = 1; seed <= 25; ++seed) {
    ArmTakenOver arm{seed};
    arm.takeOverUnderFaults(false);
    ASSERT_LT(arm.fastest, 0.3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace darwinop
