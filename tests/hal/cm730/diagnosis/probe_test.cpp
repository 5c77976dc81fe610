// Start-up probe on a virtual robot: findings, corrections, and no other writes.
#include "hal/cm730/diagnosis/probe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bitset>

#include "core/registers.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hil-mocks/memory_line.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;
using hil::BoardOptions;
using hil::ServoOptions;
using testing::AllOf;
using testing::HasSubstr;

constexpr std::size_t at(Joint joint) {
  return index(joint);
}

/// Counts writes to servos.
class WriteWatch final : public hil::WireObserver {
 public:
  void request(const Frame& frame, Nanos) noexcept override {
    const bool sync_write = frame.code == static_cast<std::uint8_t>(Instruction::kSyncWrite);
    if (sync_write && frame.params[0] != find(kMx28, "led").address) ++ram_writes;
    if (frame.code != static_cast<std::uint8_t>(Instruction::kWrite) || frame.id == kBoardId) return;
    ++(frame.params[0] < servo::kTorqueEnable ? eeprom_writes : ram_writes);
  }
  void reply(Bytes, Nanos) noexcept override {}
  int eeprom_writes = 0, ram_writes = 0;
};

struct Bench {
  explicit Bench(const BoardOptions& options = powered()) : robot{options}, line{robot} { line.observe(&writes); }
  static BoardOptions powered() {
    BoardOptions options;
    options.servo_power = true;
    return options;
  }
  ProbeReport probe(const ProbeOptions& options = ProbeOptions::quick()) { return cm730::probe(line, options); }
  const hil::VirtualServo& servo(Joint joint) { return robot.board().servo(joint); }

  hil::VirtualRobot robot;
  hil::MemoryLine line;
  WriteWatch writes;
};

Finding rowWith(const ProbeReport& report, const std::string& text) {
  for (const Finding& row : report.findings)
    if (row.what.find(text) != std::string::npos) return row;
  return {Level::kError, "(no such row)", {}};
}

std::string allRows(const ProbeReport& report) {
  std::string text;
  for (const Finding& row : report.findings) text += toText(row);
  return text;
}

/// An adapter that delays replies.
class SlowLine final : public ByteLine {
 public:
  SlowLine(hil::MemoryLine& line, Nanos delay) : line_{line}, delay_{delay} {}
  [[nodiscard]] Nanos now() noexcept override { return line_.now(); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override {
    not_before_ = line_.now() + delay_;
    return line_.write(bytes);
  }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    line_.advanceTo(std::min(not_before_, deadline));
    return line_.read(into, count, deadline);
  }
  void discardInput() noexcept override { line_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return line_.reconnects(); }

 private:
  hil::MemoryLine& line_;
  Nanos delay_, not_before_{0};
};

TEST(Probe, AHealthyRobotPassesQuickly) {
  Bench bench;
  const ProbeReport report = bench.probe();
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_LT(report.facts.took, 500ms);
  EXPECT_EQ(report.facts.board.firmware, 0x13);
  for (const ServoFacts& servo : report.facts.servo) EXPECT_TRUE(servo.readable);
  EXPECT_EQ(rowWith(report, "servo 13 LegLowerR (right knee)").level, Level::kOk);
}

TEST(Probe, SwitchesServoPowerOnAndWaitsForTheServosToBoot) {
  BoardOptions options;
  options.servo_boot = 200ms;
  Bench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_FALSE(report.facts.board.power_was_on);
  EXPECT_TRUE(bench.robot.board().device().servoPower());
  EXPECT_LT(report.facts.took, 1s);
  EXPECT_EQ(rowWith(report, "switched on").level, Level::kOk);
}

TEST(Probe, WritesNothingToAHealthyServo) {
  Bench bench;
  bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes + bench.writes.ram_writes, 0);
}

TEST(Probe, CorrectsAFactoryReturnDelayOnce) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kNeck)].return_delay = 250;
  Bench bench{options};
  const ProbeReport first = bench.probe();
  EXPECT_EQ(bench.servo(Joint::kNeck).returnDelay(), 0ns);
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
  EXPECT_EQ(worst(first.findings), Level::kOk) << allRows(first);
  EXPECT_THAT(rowWith(first, "servo 19 Neck").what, HasSubstr("return delay was 500 us, set to 0"));
  bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
  EXPECT_EQ(bench.writes.ram_writes, 0);
}

TEST(Probe, LeavesASmallReturnDelayAlone) {
  BoardOptions options = Bench::powered();
  for (ServoOptions& servo : options.servo) servo.return_delay = kMostReturnDelay;
  Bench bench{options};
  EXPECT_EQ(worst(bench.probe().findings), Level::kOk);
  EXPECT_EQ(bench.writes.eeprom_writes, 0);
}

TEST(Probe, WritesNothingInReadOnlyMode) {
  BoardOptions options = Bench::powered();
  for (ServoOptions& servo : options.servo) servo.return_delay = 250;
  options.servo[at(Joint::kHead)].status_level = 0;
  Bench bench{options};
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  EXPECT_EQ(bench.writes.eeprom_writes + bench.writes.ram_writes, 0);
  EXPECT_THAT(rowWith(report, "servo 1 ").remedy, HasSubstr("darwinop doctor --fix"));
  EXPECT_EQ(rowWith(report, "servo 1 ").level, Level::kWarning);
}

TEST(Probe, FactoryReturnDelayOnAllServosBreaksTheCycle) {
  BoardOptions options = Bench::powered();
  for (ServoOptions& servo : options.servo) servo.return_delay = 250;
  Bench bench{options};
  ProbeOptions look = ProbeOptions::quick();
  look.correct = false;
  SlowLine usb{bench.line, 1500us};
  const ProbeReport report = probe(usb, look);
  const Finding row = rowWith(report, "a full cycle takes");
  EXPECT_EQ(row.level, Level::kError);
  EXPECT_THAT(row.what, AllOf(HasSubstr("10.0 of return delays"), HasSubstr("too long")));
}

TEST(Probe, DoesNotWriteToAServoUnderTorqueAndReportsWhy) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kNeck)].return_delay = 250;
  Bench bench{options};
  const std::uint8_t on = 1;
  ASSERT_TRUE(writeRegisters(bench.line, 19, servo::kTorqueEnable, Bytes{&on, 1}).ok());
  const ProbeReport report = bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes, 0);
  EXPECT_EQ(report.facts.servo[at(Joint::kNeck)].delay_correction, Correction::kTorqueOn);
  const Finding row = rowWith(report, "servo 19 Neck");
  EXPECT_EQ(row.level, Level::kWarning);
  EXPECT_THAT(row.what, HasSubstr("return delay is 500 us"));
  EXPECT_THAT(row.remedy, HasSubstr("its torque is on"));
}

TEST(Probe, ReportsARejectedSetting) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kNeck)].return_delay = 250;
  Bench bench{options};
  const std::uint8_t lock = 1;
  ASSERT_TRUE(writeRegisters(bench.line, 19, find(kMx28, "lock").address, Bytes{&lock, 1}).ok());
  const ProbeReport report = bench.probe();
  EXPECT_EQ(report.facts.servo[at(Joint::kNeck)].delay_correction, Correction::kRefused);
  EXPECT_THAT(rowWith(report, "servo 19 Neck").remedy, HasSubstr("it rejected the new value"));
  EXPECT_LE(bench.writes.eeprom_writes, 2);
}

class ProbeStatusLevel : public testing::TestWithParam<int> {};

TEST_P(ProbeStatusLevel, IsSetToTwoOnce) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kFootL)].status_level = static_cast<std::uint8_t>(GetParam());
  Bench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_EQ(bench.servo(Joint::kFootL).statusLevel(), 2);
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
  EXPECT_THAT(rowWith(report, "servo 18 FootL").what, HasSubstr("status return level set to 2"));
  bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
}
INSTANTIATE_TEST_SUITE_P(ZeroAndOne, ProbeStatusLevel, testing::Values(0, 1));

TEST(Probe, CorrectsAServoWithTwoWrongSettings) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kFootL)].status_level = 0;
  options.servo[at(Joint::kFootL)].return_delay = 250;
  Bench bench{options};
  EXPECT_EQ(worst(bench.probe().findings), Level::kOk);
  EXPECT_EQ(bench.writes.eeprom_writes, 2);
}

TEST(Probe, RefusesOldFirmware) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kAnkleR)].firmware = 26;
  Bench bench{options};
  const Finding row = rowWith(bench.probe(), "servo 15 AnkleR");
  EXPECT_EQ(row.level, Level::kError);
  EXPECT_THAT(row.what, HasSubstr("firmware is older than 27"));
}

TEST(Probe, NamesAMissingServoAndTheSetupOfAReplacement) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kArmUpperR)].missing = true;
  Bench bench{options};
  const ProbeReport report = bench.probe();
  const Finding row = rowWith(report, "servo 3 ArmUpperR");
  EXPECT_TRUE(row.is(Kind::kServoSilent));
  EXPECT_THAT(row.what, HasSubstr("silent"));
  EXPECT_THAT(row.remedy, HasSubstr("id 1 and 57142 baud: connect it alone and set id 3"));
  EXPECT_EQ(rowWith(report, "servo 5 ArmLowerR").level, Level::kOk);
}

TEST(Probe, AReplacementServoAtItsFactoryBaudLooksMissing) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kHead)] = ServoOptions::factoryFresh();
  Bench bench{options};
  EXPECT_THAT(rowWith(bench.probe(), "servo 20 Head").remedy, HasSubstr("a new servo has id 1"));
}

TEST(Probe, LocatesABrokenCableInAChain) {
  BoardOptions options = Bench::powered();
  for (const Joint joint : {Joint::kLegLowerR, Joint::kAnkleR, Joint::kFootR}) options.servo[at(joint)].missing = true;
  Bench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_THAT(rowWith(report, "servo 13 LegLowerR").remedy,
              HasSubstr("cable from servo 11 LegUpperR (right hip pitch) into servo 13 LegLowerR"));
  EXPECT_THAT(rowWith(report, "servo 17 FootR").what, HasSubstr("silent, behind servo 13 LegLowerR"));
  EXPECT_EQ(rowWith(report, "servo 11 LegUpperR").level, Level::kOk);
}

TEST(Probe, AWholeSilentChainPointsAtTheBoard) {
  BoardOptions options = Bench::powered();
  for (const Joint joint : {Joint::kNeck, Joint::kHead}) options.servo[at(joint)].missing = true;
  Bench bench{options};
  EXPECT_THAT(rowWith(bench.probe(), "servo 19 Neck").remedy, HasSubstr("cable from the board into servo 19 Neck"));
}

TEST(Probe, TwentySilentServosAreOneRowAndCostLessThanASecond) {
  BoardOptions options = Bench::powered();
  for (ServoOptions& servo : options.servo) servo.missing = true;
  Bench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_EQ(rowWith(report, "none of the twenty servos").level, Level::kError);
  EXPECT_LT(report.facts.took, 1s);
  EXPECT_LT(report.findings.size(), 10u);
}

TEST(Probe, AStallOfTheComputerMakesNoServoSilent) {
  for (Nanos at = 5ms; at < 100ms; at += 3ms) {
    Bench bench;
    hil::Fault stall;
    stall.kind = hil::FaultKind::kStall;
    stall.at = at;
    stall.lasts = 25ms;
    bench.robot.faults().add(stall);
    const ProbeReport report = bench.probe();
    EXPECT_NE(worst(report.findings), Level::kError) << "at " << at.count() << " ns\n" << allRows(report);
  }
}

TEST(Probe, TwoServosWithIdOneAreDistinguishedFromABadCable) {
  BoardOptions options = Bench::powered();
  options.servo[at(Joint::kHead)] = ServoOptions::factoryFresh(1);
  Bench bench{options};
  const ProbeReport report = bench.probe();
  const Finding row = rowWith(report, "servo 1 ShoulderR");
  EXPECT_EQ(row.level, Level::kError);
  EXPECT_THAT(row.remedy, HasSubstr("two servos may share id 1"));
  EXPECT_TRUE(rowWith(report, "servo 20 Head").is(Kind::kServoSilent));
  EXPECT_EQ(bench.writes.eeprom_writes, 0) << "the id is ambiguous";
}

TEST(Probe, DetectsAnFtdiTimerByItsSignatureAndReportsTheCommand) {
  Bench bench;
  SlowLine slow{bench.line, 16ms};
  ProbeOptions options = ProbeOptions::quick();
  options.port = "/dev/ttyUSB1";
  const ProbeReport report = probe(slow, options);
  const Finding row = rowWith(report, "a short read takes 16.");
  EXPECT_EQ(rowWith(report, "a full cycle takes").level, Level::kError);
  EXPECT_THAT(row.remedy, HasSubstr("/sys/bus/usb-serial/devices/ttyUSB1/latency_timer"));
  EXPECT_EQ(rowWith(report, "servo 13 ").level, Level::kOk) << "a slow servo is not silent";
  EXPECT_LT(report.facts.took, 1300ms) << "loss reads must stop when their time is over";
}

TEST(Probe, AFastAdapterPasses) {
  Bench bench;
  SlowLine quick{bench.line, 1500us};
  const ProbeReport report = probe(quick, ProbeOptions::quick());
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_LT(report.facts.took, 1s);
}

hil::Fault losing(double chance) {
  hil::Fault fault;
  fault.kind = hil::FaultKind::kDrop;
  fault.amount = 1;
  fault.chance = chance;
  return fault;
}

TEST(Probe, ANoisyLineIsReportedByItsRate) {
  Bench bench;
  bench.robot.faults().add(losing(0.05));
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  const Finding row = rowWith(report, "single reads were lost");
  EXPECT_EQ(row.level, Level::kWarning) << allRows(report);
  EXPECT_THAT(row.remedy, HasSubstr("most at servo"));
  for (const ServoFacts& servo : report.facts.servo) EXPECT_TRUE(servo.readable) << "a noisy servo is not silent";
}

TEST(Probe, AFewLossesAreNormal) {
  Bench bench;
  bench.robot.faults().add(losing(0.003));
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  EXPECT_EQ(rowWith(report, "single reads were lost").level, Level::kOk) << allRows(report);
}

TEST(Probe, ErrorBitsAreNamed) {
  Bench bench;
  bench.robot.board().setServoErrors(Joint::kArmLowerL, error_bit::kOverload);
  bench.robot.board().setServoErrors(Joint::kArmLowerR, error_bit::kVoltage);
  const ProbeReport report = bench.probe();
  EXPECT_TRUE(rowWith(report, "servo 6 ArmLowerL").is(Kind::kServoOverloadBit));
  EXPECT_THAT(rowWith(report, "servo 6 ArmLowerL").what, HasSubstr("error bit: overload"));
  EXPECT_EQ(rowWith(report, "servo 5 ArmLowerR").level, Level::kWarning);
}

TEST(Probe, HeatAndALowBatteryAreReported) {
  Bench bench;
  bench.robot.board().setTemperature(Joint::kLegLowerL, 68);
  bench.robot.board().setSupply(10.6);
  const ProbeReport report = bench.probe();
  EXPECT_EQ(rowWith(report, "servo 14 LegLowerL").level, Level::kWarning);
  EXPECT_EQ(rowWith(report, "supply 10.6 V").level, Level::kWarning);
}

TEST(Probe, ReportsAMissingBoard) {
  Bench bench;
  hil::Fault stall;
  stall.kind = hil::FaultKind::kStall;
  bench.robot.faults().add(stall);
  const ProbeReport report = bench.probe();
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_THAT(report.findings[0].what, HasSubstr("no CM-730 answers"));
  EXPECT_LT(report.facts.took, 1s);
}

TEST(Probe, EndsAtOnceWhenThePortIsLost) {
  Bench bench;
  hil::Fault unplug;
  unplug.kind = hil::FaultKind::kUnplug;
  unplug.at = 10ms;
  bench.robot.faults().add(unplug);
  const ProbeReport report = bench.probe();
  EXPECT_TRUE(report.facts.lost);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_THAT(report.findings[0].what, HasSubstr("was lost during the check"));
  EXPECT_LT(report.facts.took, 100ms);
}

TEST(Probe, MovesNothingAndLeavesTorqueAlone) {
  Bench bench;
  const std::uint8_t on = 1;
  ASSERT_TRUE(writeRegisters(bench.line, 19, servo::kTorqueEnable, Bytes{&on, 1}).ok());
  const auto before = bench.robot.body().state().joint;
  bench.writes.ram_writes = 0;
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  EXPECT_EQ(bench.writes.ram_writes, 0);
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_EQ(bench.robot.body().state().joint[i].position_rad, before[i].position_rad);
  EXPECT_TRUE(report.facts.servo[at(Joint::kNeck)].torque_on);
  EXPECT_FALSE(report.facts.servo[at(Joint::kHead)].torque_on);
}

}  // namespace
}  // namespace darwinop::cm730
