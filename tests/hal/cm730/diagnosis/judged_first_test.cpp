// The start-up probe reads the model of a board or a servo before it writes anything to it.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "core/board_models.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/probe_bench.hpp"
#include "hal/cm730/diagnosis/rows.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hil-mocks/robot_options.hpp"

namespace darwinop::cm730 {
namespace {

/// Counts writes of any kind by receiver.
class WritesById final : public hil::WireObserver {
 public:
  void request(const Frame& frame, Nanos) noexcept override {
    const auto is = [&](Instruction instruction) { return frame.code == static_cast<std::uint8_t>(instruction); };
    if (is(Instruction::kSyncWrite)) {
      for (std::size_t i = 2; i < frame.params.size(); i += frame.params[1] + 1u) ++count[frame.params[i]];
    } else if (!is(Instruction::kPing) && !is(Instruction::kRead) && !is(Instruction::kBulkRead)) {
      ++count[frame.id];
    }
  }
  void reply(Bytes, Nanos) noexcept override {}
  [[nodiscard]] int all() const {
    int sum = 0;
    for (const int writes : count) sum += writes;
    return sum;
  }
  std::array<int, 256> count{};
};

struct JudgedFirst : testing::Test {
  static constexpr std::uint8_t kNeck = row(Joint::kNeck).id, kHead = row(Joint::kHead).id;

  ProbeReport probeWith(std::initializer_list<const char*> servos,
                        const ProbeOptions& options = ProbeOptions::quick()) {
    for (const char* servo : servos) hil::setServo(board, servo);
    return probe(options);
  }
  ProbeReport probe(const ProbeOptions& options = ProbeOptions::quick()) {
    hil::VirtualRobot robot{board};
    hil::MemoryLine line{robot};
    writes = {};
    line.observe(&writes);
    ProbeReport report = cm730::probe(line, options);
    for (std::size_t i = 0; i < kJoints; ++i) {  // as EEPROM keeps it
      const hil::ControlTable& table = robot.board().servo(static_cast<Joint>(i)).table();
      board.servo[i].status_level = table.byte(servo::kStatusLevel);
      board.servo[i].return_delay = table.byte(servo::kReturnDelay);
    }
    return report;
  }
  static ProbeOptions doctorFix() {
    ProbeOptions options = ProbeOptions::thorough();
    options.correct = options.correct_mute = true;
    return options;
  }

  hil::BoardOptions board = ProbeBench::powered();
  WritesById writes;
};

class AnotherServo : public JudgedFirst, public testing::WithParamInterface<const char*> {};

TEST_P(AnotherServo, GetsNoWriteOfAnyKindAtStart) {
  const ProbeReport report = probeWith({GetParam(), "Neck=return-delay:250", "Head=return-delay:250"});
  EXPECT_EQ(writes.count[kNeck], 0);
  EXPECT_EQ(writes.count[kBroadcastId], 0);
  EXPECT_GT(writes.count[kHead], 0) << "a supported one is corrected";
  EXPECT_EQ(report.facts.servo[index(Joint::kHead)].delay_correction, Correction::kDone);
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kRefuse);
}
INSTANTIATE_TEST_SUITE_P(ThanAnMx28, AnotherServo,
                         testing::Values("Neck=model:12", "Neck=model:30", "Neck=firmware:26", "Neck=status-level:0",
                                         "Neck=model:310", "Neck=model:320", "Neck=model:311"),
                         [](const auto& test) { return "Case" + std::to_string(test.index); });

TEST_F(JudgedFirst, AServoOfAnotherModelKeepsItsStatusLevelEvenFromTheDoctor) {
  const ProbeReport report = probeWith({"Neck=model:12", "Neck=status-level:1", "Neck=return-delay:250"}, doctorFix());
  EXPECT_EQ(writes.count[kNeck], 0);
  EXPECT_TRUE(rowOf(report.findings, Joint::kNeck).is(Kind::kServoModel));
}

TEST_F(JudgedFirst, AServoThatAnswersPingsOnlyIsRefusedUntilTheDoctorHasFixedIt) {
  const ProbeReport refused = probeWith({"Neck=status-level:0"});
  EXPECT_TRUE(rowOf(refused.findings, Joint::kNeck).is(Kind::kServoUnreadable));
  EXPECT_EQ(decide(refused.findings, Purpose::kDrive), Policy::kRefuse);
  EXPECT_EQ(leftOut(refused.findings, Purpose::kRescue), std::bitset<kJoints>{}.set(index(Joint::kNeck)));
  EXPECT_EQ(noWrites(refused.findings, Purpose::kRescue), leftOut(refused.findings, Purpose::kRescue));
  const ProbeReport fixed = probe(doctorFix());
  EXPECT_EQ(worst(fixed.findings), Level::kOk);
  EXPECT_NE(rowOf(fixed.findings, Joint::kNeck).what.find(kMuteCorrected), std::string::npos);
  EXPECT_EQ(board.servo[index(Joint::kNeck)].status_level, 2);
  EXPECT_EQ(decide(probe().findings, Purpose::kDrive), Policy::kDrive);
}

TEST_F(JudgedFirst, AMuteServoThatTurnsOutToBeAnotherModelGetsNothingElse) {
  const ProbeReport report = probeWith({"Neck=model:12", "Neck=status-level:0", "Neck=return-delay:250"}, doctorFix());
  EXPECT_EQ(writes.count[kNeck], 1) << "its status return level";
  EXPECT_EQ(board.servo[index(Joint::kNeck)].return_delay, 250);
  EXPECT_TRUE(rowOf(report.findings, Joint::kNeck).is(Kind::kServoModel));
}

TEST_F(JudgedFirst, NothingIsWrittenToABoardOfAnotherModelNorToItsServos) {
  hil::setBoard(board, "model:30000");
  for (const bool power : {false, true}) {
    board.servo_power = power;
    const ProbeReport report = probeWith({"Neck=return-delay:250"}, doctorFix());
    EXPECT_EQ(writes.all(), 0);
    ASSERT_TRUE(rowOf(report.findings, Kind::kBoardModel).is(Kind::kBoardModel));
    EXPECT_EQ(report.findings.back().level, Level::kOk) << "what was not measured is not reported";
    for (const auto purpose : {Purpose::kDrive, Purpose::kRescue})
      EXPECT_EQ(decide(report.findings, purpose), Policy::kRefuse);
  }
}

TEST_F(JudgedFirst, NothingIsWrittenToServosWithoutABoard) {
  hil::setBoard(board, "none");
  const ProbeReport report = probeWith({"Neck=return-delay:250", "Head=missing"}, doctorFix());
  EXPECT_EQ(writes.all(), 0);
  EXPECT_TRUE(has(report.findings, Kind::kNoBoard));
  EXPECT_EQ(report.facts.board.servos_without_it, 19);
  for (const auto purpose : {Purpose::kDrive, Purpose::kRescue})
    EXPECT_GE(decide(report.findings, purpose), Policy::kWait);
}

TEST_F(JudgedFirst, ACm740IsDrivenAndNamedWithWhatIsNotConfirmed) {
  hil::setBoard(board, "cm-740");
  const ProbeReport report = probe();
  EXPECT_EQ(worst(report.findings), Level::kOk);
  EXPECT_NE(report.findings.front().what.find("CM-740"), std::string::npos);
  EXPECT_NE(report.findings.front().what.find(findBoardModel(0x7400)->unconfirmed), std::string::npos);
}

TEST_F(JudgedFirst, ABoardOfThePermittedModelIsDriven) {
  hil::setBoard(board, "model:30000");
  ProbeOptions options = ProbeOptions::quick();
  options.permitted.board_model = 30000;
  EXPECT_EQ(worst(probe(options).findings), Level::kOk);
  options.permitted.board_model = 30001;
  EXPECT_TRUE(has(probe(options).findings, Kind::kBoardModel)) << "only that model is permitted";
}

}  // namespace
}  // namespace darwinop::cm730
