// Start-up probe on a virtual robot: findings, corrections, and no other writes.
#include "hal/cm730/diagnosis/probe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>

#include "core/registers.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/probe_bench.hpp"
#include "hal/cm730/diagnosis/rows.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hil-mocks/memory_line.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;
using hil::BoardOptions;
using hil::ServoOptions;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::size_t at(Joint joint) {
  return index(joint);
}

std::string allRows(const ProbeReport& report) {
  std::string text;
  for (const Finding& row : report.findings) text += toText(row);
  return text;
}

TEST(Probe, AHealthyRobotPassesQuickly) {
  ProbeBench bench;
  const ProbeReport report = bench.probe();
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_LT(report.facts.took, 500ms);
  EXPECT_EQ(report.facts.board.firmware, 0x13);
  for (const ServoFacts& servo : report.facts.servo) EXPECT_TRUE(servo.readable);
  EXPECT_EQ(rowOf(report.findings, Joint::kLegLowerR).level, Level::kOk);
  EXPECT_THAT(rowOf(report.findings, Joint::kLegLowerR).what, StartsWith("servo 13 LegLowerR"));
}

TEST(Probe, SwitchesServoPowerOnAndWaitsForTheServosToBoot) {
  BoardOptions options;
  options.servo_boot = 200ms;
  ProbeBench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_FALSE(report.facts.board.power_was_on);
  EXPECT_TRUE(bench.robot.board().device().servoPower());
  EXPECT_LT(report.facts.took, 1s);
  EXPECT_TRUE(report.facts.board.power_on);
}

TEST(Probe, SaysThatServoPowerIsOffBeforeItSwitchesItOn) {
  for (const bool powered : {false, true}) {
    BoardOptions board;
    board.servo_power = powered;
    ProbeBench bench{board};
    int said = 0;
    ProbeOptions options = ProbeOptions::quick();
    options.before_servo_power = [&] {
      ++said;
      EXPECT_FALSE(bench.robot.board().device().servoPower());
    };
    bench.probe(options);
    EXPECT_EQ(said, powered ? 0 : 1);
  }
}

TEST(Probe, WritesNothingToAHealthyServo) {
  ProbeBench bench;
  bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes + bench.writes.ram_writes, 0);
}

TEST(Probe, CorrectsAFactoryReturnDelayOnce) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kNeck)].return_delay = 250;
  ProbeBench bench{options};
  const ProbeReport first = bench.probe();
  EXPECT_EQ(bench.servo(Joint::kNeck).returnDelay(), 0ns);
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
  EXPECT_EQ(worst(first.findings), Level::kOk) << allRows(first);
  EXPECT_EQ(first.facts.servo[at(Joint::kNeck)].delay_correction, Correction::kDone);
  EXPECT_THAT(rowOf(first.findings, Joint::kNeck).what, HasSubstr(" 500 us, "));
  bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
  EXPECT_EQ(bench.writes.ram_writes, 0);
}

TEST(Probe, LeavesASmallReturnDelayAlone) {
  BoardOptions options = ProbeBench::powered();
  for (ServoOptions& servo : options.servo) servo.return_delay = kMostReturnDelay;
  ProbeBench bench{options};
  EXPECT_EQ(worst(bench.probe().findings), Level::kOk);
  EXPECT_EQ(bench.writes.eeprom_writes, 0);
}

TEST(Probe, WritesNothingInReadOnlyMode) {
  BoardOptions options = ProbeBench::powered();
  for (ServoOptions& servo : options.servo) servo.return_delay = 250;
  options.servo[at(Joint::kHead)].status_level = 0;
  ProbeBench bench{options};
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  EXPECT_EQ(bench.writes.eeprom_writes + bench.writes.ram_writes, 0);
  const Finding row = rowOf(report.findings, Joint::kShoulderR);
  EXPECT_TRUE(row.is(Kind::kReturnDelay));
  EXPECT_THAT(row.remedy, HasSubstr("doctor --fix"));
  EXPECT_EQ(row.level, Level::kWarning);
}

TEST(Probe, FactoryReturnDelayOnAllServosBreaksTheCycle) {
  BoardOptions options = ProbeBench::powered();
  for (ServoOptions& servo : options.servo) servo.return_delay = 250;
  ProbeBench bench{options};
  ProbeOptions look = ProbeOptions::quick();
  look.correct = false;
  SlowLine usb{bench.line, 1500us};
  const ProbeReport report = probe(usb, look);
  const Finding row = rowOf(report.findings, Kind::kCycleTooLong);
  EXPECT_EQ(row.level, Level::kError);
  EXPECT_THAT(row.what, HasSubstr(" 10.0 of ")) << "the share of the return delays";
  EXPECT_THAT(row.remedy, HasSubstr("doctor --fix"));
}

TEST(Probe, DoesNotWriteToAServoUnderTorqueAndReportsWhy) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kNeck)].return_delay = 250;
  ProbeBench bench{options};
  const std::uint8_t on = 1;
  ASSERT_TRUE(writeRegisters(bench.line, 19, servo::kTorqueEnable, Bytes{&on, 1}).ok());
  const ProbeReport report = bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes, 0);
  EXPECT_EQ(report.facts.servo[at(Joint::kNeck)].delay_correction, Correction::kTorqueOn);
  const Finding row = rowOf(report.findings, Joint::kNeck);
  EXPECT_EQ(row.level, Level::kWarning);
  EXPECT_TRUE(row.is(Kind::kReturnDelay));
  EXPECT_THAT(row.what, HasSubstr(" 500 us "));
  EXPECT_THAT(row.remedy, AllOf(HasSubstr("torque"), HasSubstr("doctor --fix")));
}

TEST(Probe, ReportsARejectedSetting) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kNeck)].return_delay = 250;
  ProbeBench bench{options};
  const std::uint8_t lock = 1;
  ASSERT_TRUE(writeRegisters(bench.line, 19, find(kMx28, "lock").address, Bytes{&lock, 1}).ok());
  const ProbeReport report = bench.probe();
  EXPECT_EQ(report.facts.servo[at(Joint::kNeck)].delay_correction, Correction::kRefused);
  EXPECT_THAT(rowOf(report.findings, Joint::kNeck).remedy, HasSubstr("RESET"));
  EXPECT_LE(bench.writes.eeprom_writes, 2);
}

TEST(Probe, SetsStatusLevelOneToTwoOnce) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kFootL)].status_level = 1;
  ProbeBench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_EQ(bench.servo(Joint::kFootL).statusLevel(), 2);
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
  EXPECT_THAT(rowOf(report.findings, Joint::kFootL).what, HasSubstr(kStatusLevelCorrected));
  bench.probe();
  EXPECT_EQ(bench.writes.eeprom_writes, 1);
}

TEST(Probe, CorrectsAServoWithTwoWrongSettings) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kFootL)].status_level = 1;
  options.servo[at(Joint::kFootL)].return_delay = 250;
  ProbeBench bench{options};
  EXPECT_EQ(worst(bench.probe().findings), Level::kOk);
  EXPECT_EQ(bench.writes.eeprom_writes, 2);
}

TEST(Probe, RefusesOldFirmware) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kAnkleR)].firmware = 26;
  ProbeBench bench{options};
  const Finding row = rowOf(bench.probe().findings, Joint::kAnkleR);
  EXPECT_EQ(row.level, Level::kError);
  EXPECT_TRUE(row.is(Kind::kServoFirmware));
}

TEST(Probe, NamesAMissingServoAndTheSetupOfAReplacement) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kArmUpperR)].missing = true;
  ProbeBench bench{options};
  const ProbeReport report = bench.probe();
  const Finding row = rowOf(report.findings, Joint::kArmUpperR);
  EXPECT_TRUE(row.is(Kind::kServoSilent));
  EXPECT_THAT(row.remedy, AllOf(HasSubstr("id 1 "), HasSubstr("57142 baud"), HasSubstr("id 3 ")));
  EXPECT_EQ(rowOf(report.findings, Joint::kArmLowerR).level, Level::kOk);
}

TEST(Probe, AReplacementServoAtItsFactoryBaudLooksMissing) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kHead)] = ServoOptions::factoryFresh();
  ProbeBench bench{options};
  EXPECT_THAT(rowOf(bench.probe().findings, Joint::kHead).remedy, HasSubstr("57142 baud"));
}

TEST(Probe, LocatesABrokenCableInAChain) {
  BoardOptions options = ProbeBench::powered();
  for (const Joint joint : {Joint::kLegLowerR, Joint::kAnkleR, Joint::kFootR}) options.servo[at(joint)].missing = true;
  ProbeBench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_THAT(rowOf(report.findings, Joint::kLegLowerR).remedy,
              AllOf(HasSubstr(servoName(Joint::kLegUpperR)), HasSubstr(servoName(Joint::kLegLowerR))));
  EXPECT_TRUE(rowOf(report.findings, Joint::kFootR).is(Kind::kLegServoSilent));
  EXPECT_THAT(rowOf(report.findings, Joint::kFootR).what, HasSubstr(servoName(Joint::kLegLowerR)));
  EXPECT_EQ(rowOf(report.findings, Joint::kLegUpperR).level, Level::kOk);
}

TEST(Probe, AWholeSilentChainPointsAtTheBoard) {
  BoardOptions options = ProbeBench::powered();
  for (const Joint joint : {Joint::kNeck, Joint::kHead}) options.servo[at(joint)].missing = true;
  ProbeBench bench{options};
  EXPECT_THAT(rowOf(bench.probe().findings, Joint::kNeck).remedy,
              AllOf(HasSubstr("board"), HasSubstr(servoName(Joint::kNeck))));
}

TEST(Probe, TwentySilentServosAreOneRowAndCostLessThanASecond) {
  BoardOptions options = ProbeBench::powered();
  for (ServoOptions& servo : options.servo) servo.missing = true;
  ProbeBench bench{options};
  const ProbeReport report = bench.probe();
  EXPECT_EQ(rowOf(report.findings, Kind::kNoServo).level, Level::kError);
  EXPECT_LT(report.facts.took, 1s);
  EXPECT_LT(report.findings.size(), 10u);
}

TEST(Probe, AStallOfTheComputerMakesNoServoSilent) {
  for (Nanos at = 5ms; at < 100ms; at += 3ms) {
    ProbeBench bench;
    hil::InjectedFault stall;
    stall.kind = hil::FaultKind::kStall;
    stall.at = at;
    stall.lasts = 25ms;
    bench.robot.faults().add(stall);
    const ProbeReport report = bench.probe();
    EXPECT_NE(worst(report.findings), Level::kError) << "at " << at.count() << " ns\n" << allRows(report);
  }
}

TEST(Probe, TwoServosWithIdOneAreDistinguishedFromABadCable) {
  BoardOptions options = ProbeBench::powered();
  options.servo[at(Joint::kHead)] = ServoOptions::factoryFresh(1);
  ProbeBench bench{options};
  const ProbeReport report = bench.probe();
  const Finding row = rowOf(report.findings, Joint::kShoulderR);
  EXPECT_EQ(row.level, Level::kError);
  EXPECT_TRUE(row.is(Kind::kServoGarbled));
  EXPECT_THAT(row.remedy, HasSubstr(kIdOneTwice));
  EXPECT_TRUE(rowOf(report.findings, Joint::kHead).is(Kind::kServoSilent));
  EXPECT_EQ(bench.writes.eeprom_writes, 0) << "the id is ambiguous";
}

TEST(Probe, DetectsAnFtdiTimerByItsSignatureAndReportsTheCommand) {
  ProbeBench bench;
  SlowLine slow{bench.line, 16ms};
  ProbeOptions options = ProbeOptions::quick();
  options.port = "/dev/ttyUSB1";
  const ProbeReport report = probe(slow, options);
  const Finding row = rowOf(report.findings, Kind::kRoundTripLong);
  EXPECT_EQ(rowOf(report.findings, Kind::kCycleTooLong).level, Level::kError);
  EXPECT_THAT(row.what, HasSubstr(" 16."));
  EXPECT_THAT(row.remedy, HasSubstr("/sys/bus/usb-serial/devices/ttyUSB1/latency_timer"));
  EXPECT_EQ(rowOf(report.findings, Joint::kLegLowerR).level, Level::kOk) << "a slow servo is not silent";
  EXPECT_LT(report.facts.took, 1300ms) << "loss reads must stop when their time is over";
}

TEST(Probe, AComputerThatIsBusyForAQuarterOfASecondPasses) {
  ProbeBench bench;
  BusyLine busy{bench.line, bench.line.now() + 250ms};
  const ProbeReport report = probe(busy, ProbeOptions::quick());
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
}

TEST(Probe, AComputerThatStaysBusyIsNotTakenForALatencyTimer) {
  ProbeBench bench;
  BusyLine busy{bench.line, bench.line.now() + 1h};
  const ProbeReport report = probe(busy, ProbeOptions::quick());
  for (const Kind kind : {Kind::kRoundTripLong, Kind::kCycleTooLong}) {
    const Finding row = rowOf(report.findings, kind);
    EXPECT_THAT(row.remedy, HasSubstr(kDelayRemedy));
    EXPECT_THAT(row.remedy, Not(HasSubstr("latency_timer")));
  }
}

TEST(Probe, AFastAdapterPasses) {
  ProbeBench bench;
  SlowLine quick{bench.line, 1500us};
  const ProbeReport report = probe(quick, ProbeOptions::quick());
  EXPECT_EQ(worst(report.findings), Level::kOk) << allRows(report);
  EXPECT_LT(report.facts.took, 1s);
}

hil::InjectedFault losing(double chance) {
  hil::InjectedFault fault;
  fault.kind = hil::FaultKind::kDrop;
  fault.amount = 1;
  fault.chance = chance;
  return fault;
}

TEST(Probe, ANoisyLineIsReportedByItsRate) {
  ProbeBench bench;
  bench.robot.faults().add(losing(0.05));
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  const Finding row = rowOf(report.findings, Kind::kRepliesLost);
  EXPECT_EQ(row.level, Level::kWarning) << allRows(report);
  const auto* const lossiest = std::ranges::max_element(report.facts.servo, {}, &ServoFacts::losses);
  EXPECT_THAT(row.remedy, HasSubstr(servoName(static_cast<Joint>(lossiest - report.facts.servo.begin()))));
  for (const ServoFacts& servo : report.facts.servo) EXPECT_TRUE(servo.readable) << "a noisy servo is not silent";
}

TEST(Probe, AFewLossesAreNormal) {
  ProbeBench bench;
  bench.robot.faults().add(losing(0.003));
  const ProbeReport report = bench.probe(ProbeOptions::thorough());
  EXPECT_GT(report.facts.servo[0].reads, 0);
  EXPECT_FALSE(has(report.findings, Kind::kRepliesLost)) << allRows(report);
}

TEST(Probe, ErrorBitsAreNamed) {
  ProbeBench bench;
  bench.robot.board().setServoErrors(Joint::kArmLowerL, error_bit::kOverload);
  bench.robot.board().setServoErrors(Joint::kArmLowerR, error_bit::kVoltage);
  const ProbeReport report = bench.probe();
  EXPECT_TRUE(rowOf(report.findings, Joint::kArmLowerL).is(Kind::kServoOverloadBit));
  EXPECT_THAT(rowOf(report.findings, Joint::kArmLowerL).what, HasSubstr(": overload"));
  EXPECT_EQ(rowOf(report.findings, Joint::kArmLowerR).level, Level::kWarning);
}

TEST(Probe, HeatAndALowBatteryAreReported) {
  ProbeBench bench;
  bench.robot.board().setTemperature(Joint::kLegLowerL, 68);
  bench.robot.board().setSupply(10.6);
  const ProbeReport report = bench.probe();
  EXPECT_EQ(rowOf(report.findings, Joint::kLegLowerL).level, Level::kWarning);
  EXPECT_EQ(rowOf(report.findings, Kind::kSupplyLow).level, Level::kWarning);
  EXPECT_THAT(rowOf(report.findings, Kind::kSupplyLow).what, HasSubstr(" 10.6 V"));
}

TEST(Probe, ReportsAMissingBoard) {
  ProbeBench bench;
  hil::InjectedFault stall;
  stall.kind = hil::FaultKind::kStall;
  bench.robot.faults().add(stall);
  const ProbeReport report = bench.probe();
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_TRUE(report.findings[0].is(Kind::kBoardSilent));
  EXPECT_LT(report.facts.took, 1s);
}

TEST(Probe, EndsAtOnceWhenThePortIsLost) {
  ProbeBench bench;
  hil::InjectedFault unplug;
  unplug.kind = hil::FaultKind::kUnplug;
  unplug.at = 10ms;
  bench.robot.faults().add(unplug);
  const ProbeReport report = bench.probe();
  EXPECT_TRUE(report.facts.lost);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_TRUE(report.findings[0].is(Kind::kPortLost));
  EXPECT_LT(report.facts.took, 100ms);
}

TEST(Probe, MovesNothingAndLeavesTorqueAlone) {
  ProbeBench bench;
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
