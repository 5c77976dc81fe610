// Recordings that cannot be of the robot, its stand and its battery as the case has them.
#include "gap/case/body/contradicted_recording.hpp"

#include <gmock/gmock.h>

#include "gap/body/edited_columns.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "gap/case/body/clamped_trunk.hpp"
#include "gap/case/body/exchanged_columns.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// With side.csv as `edit` makes it.
std::string errorWith(const std::function<std::string(std::string)>& edit) {
  BodyTexts texts;
  texts.logs["side.csv"] = edit(texts.logs["side.csv"]);
  return texts.error();
}

TEST(ContradictedRecording, ALoadWithTheOtherSignIsRefused) {
  const std::string error = errorWith([](const std::string& log) { return withNegated(log, "AnkleR.load"); });
  EXPECT_THAT(error,
              HasSubstr(std::string{"side.csv: load"} + messages::kOtherSign + messages::kFitsOtherColumn + "AnkleR"));
}

TEST(ContradictedRecording, TheOtherSideIsNotBlamedForTheSignOfAMirroredJoint) {
  const std::string mirrored = errorWith([](std::string log) {
    for (const std::string column : {"commanded", "position", "load"}) {
      const Cells right = cellsOf(log);
      const std::size_t from = columnIn(right, "AnkleR." + column);
      log = withColumn(log, "AnkleL." + column, [&](std::size_t row, const std::string&) {
        return std::to_string(-std::stod(right[row + 1][from]));
      });
    }
    return withNegated(withNegated(log, "AnkleR.load"), "AnkleL.load");
  });
  EXPECT_THAT(mirrored, HasSubstr(std::string{"load"} + messages::kOtherSign));
}

TEST(ContradictedRecording, APositionOrGoalWithTheOtherSignIsRefused) {
  for (const std::string column : {"position", "commanded"})
    EXPECT_THAT(errorWith([&](const std::string& log) { return withNegated(log, "Neck." + column); }),
                HasSubstr(column + messages::kOtherSign + messages::kFitsOtherColumn + "Neck"));
}

TEST(ContradictedRecording, ExchangedJointsAreNamed) {
  for (const std::string column : {"position", "commanded", "load"})
    EXPECT_THAT(errorWith([&](const std::string& log) {
                  return withExchanged(log, "ArmLowerR." + column, "ArmUpperR." + column);
                }),
                HasSubstr(column + " of ArmLowerR" + messages::kFitsOtherColumn + "ArmUpperR"));
}

TEST(ContradictedRecording, AServoThatFollowsAnotherLawIsNot) {
  SyntheticRobot robot;
  robot.duty = [](std::size_t joint, double duty) { return joint % 2 == 0 ? 0.3 * duty : duty > 0 ? 1.8 * duty : 0; };
  EXPECT_EQ(BodyTexts{robot}.error(), "");
}

TEST(ContradictedRecording, GoalsThatNoSafetyLayerLetsPassAreRefused) {
  const auto lower = [](std::size_t, const std::string& field) { return std::to_string(std::stod(field) - 1); };
  EXPECT_THAT(errorWith([&](const std::string& log) {
                return withColumn(withColumn(log, "LegLowerR.commanded", lower), "LegLowerR.position", lower);
              }),
              AllOf(HasSubstr("side.csv, line "), HasSubstr("LegLowerR"), HasSubstr(messages::kGoalBeyondRange)));
}

TEST(ContradictedRecording, ABatteryOfAnotherVoltageThanTheBoardReadsIsRefused) {
  EXPECT_THAT(errorWith([](const std::string& log) {
                return withColumn(log, "board.voltage", [](std::size_t, const std::string&) { return "118"; });
              }),
              AllOf(HasSubstr("side.csv"), HasSubstr("`battery_V`"), HasSubstr(messages::kOtherBattery)));
  EXPECT_EQ(errorWith([](const std::string& log) {
              return withColumn(log, "board.voltage", [](std::size_t, const std::string&) { return "10.8"; });
            }),
            "")
      << "a battery sags";
}

TEST(ContradictedRecording, AJointThatIsLimpInTheFirstRowWasNotHeld) {
  const auto limp_until = [](std::size_t until) {
    return [until](std::size_t row, const std::string& field) { return row < until ? "" : field; };
  };
  EXPECT_THAT(errorWith([&](const std::string& log) { return withColumn(log, "Head.commanded", limp_until(5)); }),
              AllOf(HasSubstr("side.csv: Head"), HasSubstr(messages::kLimpAtStart)));
  EXPECT_EQ(errorWith([&](const std::string& log) { return withColumn(log, "Head.commanded", limp_until(1000)); }), "")
      << "it hangs all the time";
}

TEST(ContradictedRecording, AClampedTrunkThatTurnsIsRefused) {
  const auto turning = [](std::size_t row, const std::string& field) {
    return row > 40 && row < 80 ? std::string{"1.2"} : field;
  };
  EXPECT_THAT(errorWith([&](const std::string& log) { return withColumn(log, "gyro.y", turning); }),
              AllOf(HasSubstr("side.csv"), HasSubstr(messages::kTrunkTurns)));
  BodyTexts floor;
  floor.logs["floor.csv"] = withColumn(floor.logs["floor.csv"], "gyro.y", turning);
  EXPECT_EQ(floor.error(), "") << "there it may";
}

logs::Log headOf(const std::string& file, const std::string& robot, const std::string& model) {
  logs::Log out;
  out.file = file;
  out.head = {{"robot", robot}, {"model", model}};
  return out;
}

TEST(ContradictedRecording, RecordingsOfTwoRobotsAreRefused) {
  const logs::Log ours = headOf("a.csv", "op2-nr1", "/dev/ttyUSB0, CM-730, 20 servos");
  std::vector<std::string> warnings;
  refuseOtherRobot(ours, headOf("b.csv", "op2-nr1", "/dev/ttyUSB0, CM-730, 20 servos"), warnings);
  EXPECT_THAT(warnings, IsEmpty());
  refuseOtherRobot(ours, headOf("b.csv", "op2-nr1", "/dev/ttyUSB1, CM-730, 20 servos"), warnings);
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("b.csv"), HasSubstr("ttyUSB1"))));
  EXPECT_THROW(refuseOtherRobot(ours, headOf("b.csv", "op2-nr7", "/dev/ttyUSB0"), warnings), BadInput);
  EXPECT_THROW(refuseOtherRobot(ours, headOf("b.csv", "op2-nr1", "twin in memory, model darwin-op"), warnings),
               BadInput);
}

TEST(ContradictedRecording, ACaseIsOfOneRobot) {
  BodyTexts texts;
  texts.logs["up.csv"] = "# robot: nr1\n" + texts.logs["up.csv"];
  texts.logs["side.csv"] = "# robot: nr7\n" + texts.logs["side.csv"];
  EXPECT_THAT(texts.error(), AllOf(HasSubstr("side.csv: it is of nr7"), HasSubstr(messages::kOtherRobotInHead)));
}

}  // namespace
}  // namespace darwinop::gap
