// A suite runs cases of the whole robot as it does those of one servo.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gap/benchmark/run/answer.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "gap/identify/body/body_identification.hpp"
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

/// Of its sensors alone: no simulated robot moves as these joints do.
nlohmann::json answerOf(const BodyTexts& texts) {
  const BodyCase given = texts.read();
  nlohmann::json answer = asJson(given, identify(given, BodyScope::kSensors));
  answer["case"] = "b";
  return answer;
}

TEST(BodySuite, ANamedAnswerHasALine) {
  SyntheticRobot robot;
  robot.gyro_bias = {0.12, 0, 0};
  const nlohmann::json answer = answerOf(BodyTexts{robot});
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
  const nlohmann::json answer = answerOf(texts);
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
