// A suite runs cases of the whole robot as it does those of one servo.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gap/benchmark/run/answer.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;

std::string written(const BodyTexts& texts, const TemporaryFolder& folder, const std::string& name) {
  std::filesystem::create_directory(folder / name);
  std::ofstream{folder / (name + "/case.json")} << texts.json;
  for (const auto& [file, text] : texts.logs) std::ofstream{folder / (name + "/" + file)} << text;
  return folder / name;
}

TEST(BodySuite, ACaseOfTheWholeRobotIsAnswered) {
  SyntheticRobot robot;
  robot.gyro_bias = {0.12, 0, 0};
  const TemporaryFolder folder;
  const nlohmann::json answer = answerFor(written(BodyTexts{robot}, folder, "b1"));
  EXPECT_EQ(answer["case"], "b1");
  ASSERT_EQ(answer["verdict"], "named");
  EXPECT_EQ(answer["effects"][0]["at"], "gyro");
  EXPECT_THAT(lineOf(answer), HasSubstr("gyro_bias"));
}

TEST(BodySuite, AnAmbiguousAnswerHasALine) {
  SyntheticRobot robot;
  robot.accel_scale = {1, 1, 1.05};
  BodyTexts texts{robot};
  for (const char* file : {"side.csv", "face.csv", "tilt.csv"})
    texts = texts.with(
        std::string{file} + "\", \"role\": \"" + (*file == 't' ? "score" : "fit") + "\", \"setup\": \"stand_clamped\"",
        std::string{file} + "\", \"role\": \"" + (*file == 't' ? "score" : "fit") + "\", \"setup\": \"floor\"");
  const TemporaryFolder folder;
  const nlohmann::json answer = answerFor(written(texts, folder, "b2"));
  ASSERT_EQ(answer["verdict"], "ambiguous");
  EXPECT_THAT(lineOf(answer), testing::AllOf(HasSubstr("accel_bias"), HasSubstr("accel_scale")));
}

TEST(BodySuite, ABrokenCaseIsBadInputWithItsFile) {
  const BodyTexts texts = BodyTexts{}.withLog("side.csv", "gyro.y [rad/s]", "gyro.y [deg/s]");
  const TemporaryFolder folder;
  const nlohmann::json answer = answerFor(written(texts, folder, "b3"));
  EXPECT_EQ(answer["verdict"], "bad_input");
  EXPECT_THAT(answer["why"].get<std::string>(), HasSubstr("side.csv"));
}

}  // namespace
}  // namespace darwinop::gap
