// The whole bus against the virtual board, byte for byte and in simulated time.
#include "hal/cm730/bus.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/conversions.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

constexpr Nanos kPeriod{16'000'000};

hil::BoardOptions powered() {
  hil::BoardOptions options;
  options.servo_power = true;
  return options;
}

struct Bus : ::testing::Test {
  hil::VirtualRobot robot{powered()};
  hil::MemoryLine line{robot};
  Cm730Bus bus{line, BusConfig::forPeriod(kPeriod)};
  BusReadings readings{};
  Nanos release{0};

  void cycle(const SafeCommands& commands = SafeCommandsForTests{}.commands) {
    release += kPeriod;
    line.advanceTo(release);
    bus.write(commands);
    bus.read(readings);
  }
  [[nodiscard]] std::bitset<kJoints> answered() const {
    std::bitset<kJoints> who;
    for (std::size_t i = 0; i < kJoints; ++i) who[i] = readings.servo[i].answered;
    return who;
  }
  void fault(hil::FaultKind kind, Nanos lasts, std::size_t joint = 0) {
    hil::InjectedFault fault;
    fault.kind = kind;
    fault.at = release;
    fault.lasts = lasts;
    fault.joints.set(joint);
    robot.faults().add(fault);
  }
};

TEST_F(Bus, AFullCycleTakesItsWireTimeAndNoMore) {
  cycle();
  cycle(SafeCommandsForTests{}.driveAll(Rad{0}).commands);
  EXPECT_TRUE(answered().all());
  // SyncWrite 188, request 70, replies 36 (+1 tag) + 19 x 12 + 26.
  EXPECT_EQ(readings.wire.bytes_out, 258U);
  EXPECT_EQ(readings.wire.bytes_in, 291U);
  EXPECT_EQ(readings.wire.bus_ns, readings.wire.wire_ns);
}

TEST_F(Bus, GoalsAloneTake68Bytes) {
  for (int i = 0; i < 2; ++i) cycle(SafeCommandsForTests{}.driveAll(Rad{0}).commands);
  cycle(SafeCommandsForTests{}.driveAll(Rad{0.01}).commands);
  EXPECT_EQ(readings.wire.bytes_out, 68U + 70U);
}

TEST_F(Bus, GoalsReachTheServosAndPositionsAreRead) {
  cycle();
  const auto there = SafeCommandsForTests{}.drive(Joint::kNeck, radFromTicks(2300)).commands;
  for (int i = 0; i < 100; ++i) cycle(there);
  EXPECT_NEAR(readings.servo[index(Joint::kNeck)].position.value, radFromTicks(2300).value, 2 * kRadPerTick);
}

TEST_F(Bus, EveryServoReportsTemperatureAndVoltageWithinHalfASecond) {
  std::bitset<kJoints> polled;
  for (Nanos t{0}; t < Nanos{500'000'000}; t += kPeriod) {
    cycle();
    for (std::size_t i = 0; i < kJoints; ++i)
      if (readings.servo[i].polled && readings.servo[i].temperature.known() && readings.servo[i].voltage.known())
        polled.set(i);
  }
  EXPECT_TRUE(polled.all());
}

class DeadServoOnTheBus : public Bus, public ::testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(AnywhereInTheChain, DeadServoOnTheBus, ::testing::Range(std::size_t{0}, kJoints));

TEST_P(DeadServoOnTheBus, AllOthersAreReadFromThreeCyclesLaterAndItIsBackWithinASecond) {
  for (int i = 0; i < 5; ++i) cycle();
  const auto others = ~std::bitset<kJoints>{}.set(GetParam());
  fault(hil::FaultKind::kDead, Nanos{2'000'000'000}, GetParam());
  const Nanos returns = release + Nanos{2'000'000'000};
  for (int i = 0; i < 3; ++i) cycle();
  while (release + kPeriod < returns) {
    cycle();
    ASSERT_EQ(answered(), others);
  }
  EXPECT_TRUE(readings.silent[GetParam()]);
  while (!readings.servo[GetParam()].answered) {
    cycle();
    ASSERT_LT(release, returns + Nanos{1'000'000'000});
  }
  EXPECT_TRUE(readings.silent.none());
}

TEST_F(Bus, LedsAreWrittenOnceAndAgainAfterABoardReset) {
  LedCommand led;
  led.setEye(0x1234);
  led.setPanel(5);
  const auto asked = SafeCommandsForTests{}.led(led).powerOn().commands;
  for (int i = 0; i < 5; ++i) cycle(asked);
  EXPECT_EQ(readings.board.led_eye, 0x1234);
  EXPECT_EQ(readings.board.led_panel, 5);
  const auto frames = line.counters().frames;
  for (int i = 0; i < 20; ++i) cycle(asked);
  EXPECT_EQ(line.counters().frames, frames + 20);  // the BulkReads, nothing else

  fault(hil::FaultKind::kReset, Nanos{0});
  for (int i = 0; i < 60; ++i) cycle(asked);
  EXPECT_EQ(readings.board.led_eye, 0x1234);
  EXPECT_TRUE(readings.board.servo_power);
  EXPECT_TRUE(answered().all());
}

TEST_F(Bus, NeverSwitchesServoPowerOff) {
  LedCommand led;
  led.setEye(1);
  cycle(SafeCommandsForTests{}.led(led).commands);
  cycle();
  EXPECT_TRUE(robot.board().device().servoPower());
}

TEST_F(Bus, LocksTheEepromOfEveryServo) {
  for (int i = 0; i < 3; ++i) cycle();
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_EQ(robot.board().servo(static_cast<Joint>(i)).table().byte(servo::kLock), 1) << kJointTable[i].name;
}

TEST_F(Bus, LocksNoServoThatMayNotBeWrittenTo) {
  BusConfig config = BusConfig::forPeriod(kPeriod);
  config.absent.set(index(Joint::kNeck));
  config.no_writes.set(index(Joint::kHead));
  Cm730Bus careful{line, config};
  for (int i = 0; i < 3; ++i) {
    release += kPeriod;
    line.advanceTo(release);
    careful.write(SafeCommandsForTests{}.commands);
    careful.read(readings);
  }
  const auto lock = [this](Joint joint) { return robot.board().servo(joint).table().byte(servo::kLock); };
  EXPECT_EQ(lock(Joint::kNeck), 0);
  EXPECT_EQ(lock(Joint::kHead), 0);
  EXPECT_EQ(lock(Joint::kFootL), 1);
}

TEST_F(Bus, ReportsAServoRestartAtItsFirstReply) {
  for (int i = 0; i < 2; ++i) cycle(SafeCommandsForTests{}.driveAll(Rad{0}).commands);
  fault(hil::FaultKind::kDead, Nanos{40'000'000}, 7);
  int cycles = 0;
  do {
    cycle();
    ASSERT_LT(++cycles, 60);
  } while (cycles < 3 || !readings.servo[7].answered);
  EXPECT_TRUE(readings.servo[7].polled);
  EXPECT_EQ(readings.servo[7].speed_limit, RadPerSec{0});
}

TEST_F(Bus, ABoardThatMissesFiveRepliesIsReadInEveryCycle) {
  cycle();
  fault(hil::FaultKind::kStall, Nanos{1'600'000'000});
  cycle();
  const auto before = line.counters().bulk_reads;
  for (std::uint32_t i = 0; i < kAnswerPatience; ++i) cycle();
  EXPECT_EQ(line.counters().bulk_reads - before, kAnswerPatience);
}

TEST_F(Bus, ASilentBoardIsPolledRarelyAndReadAtOnceAfterItsReturn) {
  cycle();
  fault(hil::FaultKind::kStall, Nanos{1'600'000'000});
  const auto asked_before = line.counters().bulk_reads;
  for (int i = 0; i < 98; ++i) {
    cycle();
    EXPECT_FALSE(readings.board.answered);
    EXPECT_TRUE(answered().none());
  }
  EXPECT_LE(line.counters().bulk_reads - asked_before, 20U);
  int cycles = 0;
  while (!answered().all()) {
    cycle();
    ASSERT_LT(++cycles, 30);
  }
}

TEST_F(Bus, CountsLosses) {
  cycle();
  fault(hil::FaultKind::kDead, Nanos{320'000'000}, 3);
  for (int i = 0; i < 40; ++i) cycle();
  EXPECT_GE(readings.link.incomplete, 3U);
  EXPECT_GE(readings.link.retries, 2U);
  EXPECT_EQ(readings.link.exchanges, 41U);
}

/// A servo whose transmitter is stuck: there is always another byte.
class BabblingLine final : public ByteLine {
 public:
  [[nodiscard]] Nanos now() noexcept override { return now_; }
  LineStatus write(std::span<const std::uint8_t>) noexcept override { return LineStatus::kOk; }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos) noexcept override {
    now_ += Nanos{100'000};
    std::ranges::fill(into.first(10), std::uint8_t{0x55});
    count = 10;
    return LineStatus::kOk;
  }
  void discardInput() noexcept override {}
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return 0; }

 private:
  Nanos now_{0};
};

TEST(BusOnABadLine, GarbageDoesNotBlockTheLoop) {
  BabblingLine line;
  Cm730Bus bus{line, BusConfig::forPeriod(kPeriod)};
  BusReadings readings;
  bus.read(readings);
  EXPECT_FALSE(readings.board.answered);
  EXPECT_LT(line.now(), kPeriod);
}

}  // namespace
}  // namespace darwinop::cm730
