// Start policy: doctor, start and docs/doctor.md agree.
#include "hal/cm730/diagnosis/start_policy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>

#include "core/servo_limits.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/instruction_trial.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hal/cm730/diagnosis/probe_bench.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hal/cm730/wire.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/robot_options.hpp"
#include "hil-mocks/torque_on_counter.hpp"
#include "support/text_of.hpp"

namespace darwinop::cm730 {
namespace {

using testing::HasSubstr;

std::string docsTable() {
  std::string text;
  for (const KindRow& row : kKindTable)
    text += "| " + std::string{row.finding} + " | " + std::string{kPolicyNames[static_cast<std::size_t>(row.drive)]} +
            " | " + std::string{kPolicyNames[static_cast<std::size_t>(row.rescue)]} + " | " + std::string{row.reason} +
            " |\n";
  return text;
}

TEST(StartPolicyDocs, TheDocumentationHasTheTable) {
  const std::string page = textOf(DARWINOP_DOCTOR_PAGE);
  EXPECT_THAT(page, HasSubstr(docsTable())) << "expected table:\n" << docsTable();
}

TEST(StartPolicyDocs, TheTableNamesTheThresholds) {
  const auto shown = [](const char* format, double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return std::string{text.data()};
  };
  const struct {
    Kind kind;
    std::string threshold;
  } thresholds[] = {
      {Kind::kSupplyLow, shown("under %g V", kBatteryLowV)},
      {Kind::kSupplyEmpty, shown("under %g V", kBatteryEmptyV)},
      {Kind::kRoundTripLong, shown("%g ms or more", static_cast<double>(kLatencySignature.count()) / 1e6)},
      {Kind::kRepliesLost, shown("over %g %%", kLossAlarm * 100)},
      {Kind::kServoFirmware, shown("before %g", kOldestFirmware)},
      {Kind::kServoHot, shown("%g deg C or more", kServoHotC)},
      {Kind::kServoTooHot, shown("%g deg C or more", kServoOverheatC)},
  };
  for (const auto& expected : thresholds)
    EXPECT_THAT(std::string{kKindTable[static_cast<std::size_t>(expected.kind)].finding},
                HasSubstr(expected.threshold));
}

TEST(StartPolicy, ARobotIsReportedDrivableExactlyWhenALoopDrivesIt) {
  for (const KindRow& row : kKindTable) {
    const Findings one{Finding::of(row.kind, "", "")};
    EXPECT_EQ(worst(one) == Level::kError, decide(one, Purpose::kDrive) > Policy::kNoWrites) << row.finding;
  }
}

TEST(StartPolicy, TheMostSevereFindingDecides) {
  const Findings both{Finding::of(Kind::kLegServoSilent, "", ""), Finding::of(Kind::kWheelMode, "", "")};
  EXPECT_EQ(decide(both, Purpose::kDrive), Policy::kRefuse);
  EXPECT_EQ(decide({}, Purpose::kDrive), Policy::kDrive);
}

TEST(StartPolicy, AJointIsOmittedEvenIfItsRowHasAMoreSevereFinding) {
  Finding row = Finding::of(Kind::kWheelMode, "", "");
  row.kinds.set(static_cast<std::size_t>(Kind::kServoTooHot));
  row.joint = Joint::kNeck;
  EXPECT_TRUE(leftOut(std::array{row}, Purpose::kRescue)[index(Joint::kNeck)]);
}

/// A fault of the virtual robot and its expected consequences.
struct Case {
  const char* option;  // JOINT=SETTING, or a setting of the board
  Kind kind;
  Policy drive, rescue;
};
class EveryFault : public testing::TestWithParam<Case> {};

TEST_P(EveryFault, HasItsKindAndItsPolicy) {
  hil::BoardOptions options;
  options.servo_power = true;
  const std::string_view option = GetParam().option;
  option.find('=') == option.npos ? hil::setBoard(options, option) : hil::setServo(options, option);
  hil::TorqueOnCounter torque_on;
  hil::VirtualRobot robot{options};
  robot.board().observe(&torque_on);
  hil::MemoryLine line{robot};
  const ProbeReport report = probe(line, ProbeOptions::quick());
  EXPECT_TRUE(std::ranges::any_of(report.findings, [](const Finding& row) { return row.is(GetParam().kind); }));
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), GetParam().drive);
  EXPECT_EQ(decide(report.findings, Purpose::kRescue), GetParam().rescue);
  EXPECT_EQ(torque_on.count(), 0U) << "the check must not enable torque";
}
INSTANTIATE_TEST_SUITE_P(
    OfTheVirtualRobot, EveryFault,
    testing::Values(Case{"LegLowerR=wheel", Kind::kWheelMode, Policy::kRefuse, Policy::kLeaveOut},
                    Case{"Head=wheel", Kind::kWheelMode, Policy::kRefuse, Policy::kLeaveOut},
                    Case{"LegLowerR=multi-turn", Kind::kMultiTurnMode, Policy::kRefuse, Policy::kLeaveOut},
                    Case{"ArmLowerL=model:12", Kind::kServoModel, Policy::kRefuse, Policy::kNoWrites},
                    Case{"ArmLowerL=model:30", Kind::kServoModel, Policy::kRefuse, Policy::kNoWrites},
                    Case{"ArmLowerL=model:310", Kind::kServoModel, Policy::kRefuse, Policy::kNoWrites},
                    Case{"FootL=firmware:26", Kind::kServoFirmware, Policy::kRefuse, Policy::kLeaveOut},
                    Case{"FootL=max-torque:0", Kind::kMaxTorqueZero, Policy::kRefuse, Policy::kLeaveOut},
                    Case{"LegLowerR=missing", Kind::kLegServoSilent, Policy::kWait, Policy::kNoWrites},
                    Case{"PelvYR=missing", Kind::kLegServoSilent, Policy::kWait, Policy::kNoWrites},
                    Case{"FootL=missing", Kind::kLegServoSilent, Policy::kWait, Policy::kNoWrites},
                    Case{"ShoulderR=missing", Kind::kServoSilent, Policy::kNoWrites, Policy::kNoWrites},
                    Case{"Neck=missing", Kind::kServoSilent, Policy::kNoWrites, Policy::kNoWrites},
                    Case{"Head=id:1", Kind::kServoGarbled, Policy::kRefuse, Policy::kNoWrites},
                    Case{"Neck=cw-limit:3200", Kind::kNoRange, Policy::kRefuse, Policy::kLeaveOut},
                    Case{"LegLowerR=ccw-limit:3400", Kind::kStartPoseOutside, Policy::kRefuse, Policy::kDrive},
                    Case{"LegLowerR=ccw-limit:3450", Kind::kNarrowRange, Policy::kDrive, Policy::kDrive},
                    Case{"PelvR=cw-limit:1536", Kind::kNarrowRange, Policy::kDrive, Policy::kDrive},
                    Case{"Neck=status-level:0", Kind::kServoUnreadable, Policy::kRefuse, Policy::kNoWrites},
                    Case{"model:30000", Kind::kBoardModel, Policy::kRefuse, Policy::kRefuse},
                    Case{"none", Kind::kNoBoard, Policy::kWait, Policy::kWait},
                    Case{"no-bulk-read", Kind::kNoBulkRead, Policy::kRefuse, Policy::kRefuse},
                    Case{"no-sync-write", Kind::kNoSyncWrite, Policy::kRefuse, Policy::kRefuse},
                    Case{"one-block-length", Kind::kBlockLengths, Policy::kDrive, Policy::kDrive}),
    [](const auto& test) {
      std::string name = test.param.option;
      std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
      return name;
    });

struct Instructions : testing::Test {
  static hil::BoardOptions powered() {
    hil::BoardOptions options;
    options.servo_power = true;
    return options;
  }
  void start(const hil::BoardOptions& options = powered()) {
    robot = std::make_unique<hil::VirtualRobot>(options);
    line = std::make_unique<hil::MemoryLine>(*robot);
  }
  [[nodiscard]] std::uint8_t led(Joint joint) const {
    return robot->board().servo(joint).table().byte(find(kMx28, "led").address);
  }
  std::unique_ptr<hil::VirtualRobot> robot;
  std::unique_ptr<hil::MemoryLine> line;
};

TEST_F(Instructions, LedsAreRestored) {
  start();
  const std::uint8_t on = 1;
  ASSERT_TRUE(writeRegisters(*line, 19, find(kMx28, "led").address, Bytes{&on, 1}).ok());
  const ProbeReport report = probe(*line);
  EXPECT_TRUE(report.facts.instructions.sync_write);
  EXPECT_EQ(led(Joint::kNeck), 1);
  EXPECT_EQ(led(Joint::kHead), 0);
}

TEST_F(Instructions, ANoisyLineIsNotReportedAsAnotherFirmware) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    robot = std::make_unique<hil::VirtualRobot>(powered(), seed);
    line = std::make_unique<hil::MemoryLine>(*robot);
    hil::InjectedFault noise;
    noise.kind = hil::FaultKind::kDrop;
    noise.amount = 1;
    noise.chance = 0.02;
    robot->faults().add(noise);
    const RobotFacts facts = measure(*line, ProbeOptions::quick());
    EXPECT_TRUE(facts.instructions.bulk_read && facts.instructions.sync_write && facts.instructions.all_blocks) << seed;
    for (const ServoFacts& servo : facts.servo) EXPECT_TRUE(servo.bulk_read_works && servo.sync_write_works) << seed;
    for (std::size_t i = 0; i < kJoints; ++i) EXPECT_EQ(led(static_cast<Joint>(i)), 0) << seed;
  }
}

/// Damages the board's first reply to a BULK_READ.
class DamagedBlock final : public SlowLine {
 public:
  explicit DamagedBlock(hil::MemoryLine& line) : SlowLine{line, Nanos{0}} {}
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    const LineStatus status = SlowLine::read(into, count, deadline);
    if (status != LineStatus::kOk || count != kBoardWindow.frameBytes() || into[2] != kBoardId || damaged_)
      return status;
    into[count - 1] ^= 1;
    damaged_ = true;
    return status;
  }

 private:
  bool damaged_ = false;
};

TEST_F(Instructions, ADamagedReplyOfTheBoardIsNotReportedAsAnotherFirmware) {
  start();
  DamagedBlock damaged{*line};
  const RobotFacts facts = measure(damaged, ProbeOptions::quick());
  EXPECT_TRUE(facts.instructions.bulk_read && facts.instructions.sync_write && facts.instructions.all_blocks);
}

TEST_F(Instructions, ASilentServoDoesNotHideTheOthers) {
  hil::BoardOptions options = powered();
  hil::setServo(options, "ShoulderR=missing");
  start(options);
  const RobotFacts facts = measure(*line, ProbeOptions::quick());
  EXPECT_TRUE(facts.instructions.bulk_read && facts.instructions.sync_write);
  for (const ServoFacts& servo : facts.servo) EXPECT_TRUE(servo.bulk_read_works && servo.sync_write_works);
}

/// Detects any request to a servo.
class Contacts final : public hil::WireObserver {
 public:
  void request(const Frame& frame, Nanos) noexcept override {
    if (frame.id == 19) ++direct;
    const bool bulk = frame.code == static_cast<std::uint8_t>(Instruction::kBulkRead);
    for (std::size_t i = 2; bulk && i < frame.params.size(); i += 3) direct += frame.params[i] == 19 ? 1 : 0;
    const bool sync = frame.code == static_cast<std::uint8_t>(Instruction::kSyncWrite);
    for (std::size_t i = 2; sync && i < frame.params.size(); i += frame.params[1] + 1u)
      direct += frame.params[i] == 19 ? 1 : 0;
  }
  void reply(Bytes, Nanos) noexcept override {}
  int direct = 0;
};

TEST_F(Instructions, AnAbsentServoIsNeverAddressedAndNotReported) {
  start();
  Contacts neck;
  line->observe(&neck);
  ProbeOptions options = ProbeOptions::quick();
  options.absent.set(index(Joint::kNeck));
  const ProbeReport report = probe(*line, options);
  EXPECT_EQ(neck.direct, 0);
  EXPECT_EQ(worst(report.findings), Level::kOk);
  const auto row = std::ranges::find(report.findings, std::optional{Joint::kNeck}, &Finding::joint);
  ASSERT_NE(row, report.findings.end());
  EXPECT_THAT(row->what, HasSubstr("absent"));
}

}  // namespace
}  // namespace darwinop::cm730
