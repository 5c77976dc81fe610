// An MX-64 or MX-106 is driven only if robot.ini permits it and goals have their usual effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hal/cm730/diagnosis/fault_naming.hpp"
#include "hal/cm730/diagnosis/probe_bench.hpp"
#include "hal/cm730/diagnosis/rows.hpp"
#include "hil-mocks/robot_options.hpp"

namespace darwinop::cm730 {
namespace {

using testing::HasSubstr;

ProbeReport probeKnee(std::initializer_list<const char*> settings, const ServoModels& permitted) {
  hil::BoardOptions board = ProbeBench::powered();
  for (const char* setting : settings) hil::setServo(board, std::string{"LegLowerR="} + setting);
  ProbeBench bench{board};
  ProbeOptions options;
  options.permitted.servo_models = permitted;
  return bench.probe(options);
}

ServoModels only(std::uint16_t number) {
  return ServoModels{}.set(static_cast<std::size_t>(findServoModel(number) - kServoModels.data()));
}

struct StrongerServo : testing::TestWithParam<const ServoModel*> {
  const ServoModel& model = *GetParam();
  const std::string setting = "model:" + std::to_string(model.number);
  [[nodiscard]] ProbeReport probe(const ServoModels& permitted, const char* also = "firmware:36") const {
    return probeKnee({setting.c_str(), also}, permitted);
  }
};

TEST_P(StrongerServo, IsRefusedWithItsNameAndTheSettingThatPermitsIt) {
  const ProbeReport report = probe(~only(model.number));
  const Finding row = rowOf(report.findings, Joint::kLegLowerR);
  EXPECT_TRUE(row.is(Kind::kServoModel));
  EXPECT_THAT(row.what, HasSubstr(model.name));
  EXPECT_THAT(row.remedy, HasSubstr("servo_models = " + std::string{model.name}));
  EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kRefuse);
  EXPECT_TRUE(noWrites(report.findings, Purpose::kRescue)[index(Joint::kLegLowerR)]);
}

TEST_P(StrongerServo, IsDrivenAndCorrectedIfPermitted) {
  const ProbeReport report = probe(only(model.number), "return-delay:250");
  EXPECT_EQ(worst(report.findings), Level::kOk);
  EXPECT_THAT(rowOf(report.findings, Joint::kLegLowerR).what, HasSubstr(model.name));
  EXPECT_EQ(report.facts.servo[index(Joint::kLegLowerR)].delay_correction, Correction::kDone);
  EXPECT_TRUE(nameFaults(report.facts, report.findings).empty());
}

TEST_P(StrongerServo, IsRefusedInAModeInWhichGoalsDoNotMoveOrStopIt) {
  for (const char* mode : {"torque-control", "drive-mode:1", "drive-mode:2"}) {
    const ProbeReport report = probe(only(model.number), mode);
    EXPECT_TRUE(rowOf(report.findings, Joint::kLegLowerR).is(Kind::kServoMode)) << mode;
    EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kRefuse) << mode;
    EXPECT_TRUE(leftOut(report.findings, Purpose::kRescue)[index(Joint::kLegLowerR)]) << mode;
    EXPECT_TRUE(noWrites(report.findings, Purpose::kRescue).none()) << "a rescue switches its torque off";
    const auto named = nameFaults(report.facts, report.findings);
    ASSERT_EQ(named.size(), 1U) << mode;
    EXPECT_EQ(named[0].fault, BusFault::kServoMode) << mode;
  }
}

INSTANTIATE_TEST_SUITE_P(Permitted, StrongerServo, testing::Values(findServoModel(310), findServoModel(320)),
                         [](const auto& test) { return "Model" + std::to_string(test.param->number); });

TEST(ServoOfProtocol2, IsRefusedByNameEvenIfEveryModelIsPermitted) {
  for (const char* setting : {"model:30", "model:311", "model:321"}) {
    const ProbeReport report = probeKnee({setting}, ServoModels{}.set());
    const Finding row = rowOf(report.findings, Joint::kLegLowerR);
    EXPECT_TRUE(row.is(Kind::kServoModel)) << setting;
    EXPECT_THAT(row.what, HasSubstr("(2.0)"));
    EXPECT_EQ(decide(report.findings, Purpose::kDrive), Policy::kRefuse) << setting;
  }
}

}  // namespace
}  // namespace darwinop::cm730
