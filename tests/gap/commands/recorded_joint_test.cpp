// A joint of the twin as the runtime records it in lockstep, from experiments to a verdict.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gap/case/case.hpp"
#include "gap_files.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::gap {
namespace {

constexpr int kNone = 0, kNamed = 10;

/// A twin with more in it than the model that it is compared with.
class RecordedJoint : public testing::Test {
 protected:
  /// Exit status and output of `run`; `lines`: of the twin's model file.
  Outcome answerFor(const std::string& lines) {
    const std::filesystem::path models{DARWINOP_TWIN_MODELS};
    std::filesystem::copy_file(models / "darwin-op.xml", folder_ / "darwin-op.xml",
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream{folder_ / "robot.ini"} << darwinop::textOf(models / "darwin-op.ini") << '\n' << lines;
    std::string recordings;
    for (const std::string name : {"steps", "slow_triangle", "chirp"}) {
      const std::string file = folder_ / (name + ".csv");
      const Outcome made = shell(std::string{DARWINOP_BIN} + "/darwinop-experiment run " + name +
                                 " --robot twin:" + (folder_ / "robot.ini") + " --record " + file);
      EXPECT_EQ(made.status, 0) << made.said;
      recordings += " " + file;
    }
    const std::string gap = std::string{DARWINOP_BIN} + "/darwinop-gap ";
    const Outcome made = shell(gap + "case" + recordings + " --joint ShoulderR --out " + case_);
    EXPECT_EQ(made.status, 0) << made.said;
    return shell(gap + "run --no-open --report " + (folder_ / "report") + " " + case_);
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> ids;
    const auto json = nlohmann::json::parse(darwinop::textOf(folder_ / "report/report.json"));
    for (const auto& effect : json.at("effects")) ids.push_back(effect.at("id"));
    return ids;
  }

  const TemporaryFolder folder_;
  const std::string case_ = folder_ / "case";
};

TEST_F(RecordedJoint, OfAnUnchangedTwinLacksNothing) {
  const Outcome answer = answerFor("");
  EXPECT_EQ(answer.status, kNone) << answer.said;
  EXPECT_EQ(answer.said.find(messages::kModelOfReport), std::string::npos) << "there are none";
  const Case made = readCase(case_);
  for (const Trajectory& log : made.logs) {
    EXPECT_TRUE(log.isReadAfterWrite()) << log.file;
    EXPECT_TRUE(log.is_phase_known) << log.file;
    EXPECT_FALSE(std::isnan(log.load[log.rows() / 2])) << log.file;
  }
  const Outcome refused = shell(std::string{DARWINOP_BIN} + "/darwinop-gap plan " + case_ + " --joint ArmLowerR");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, testing::HasSubstr("is a case of ShoulderR"));
}

// 4 ms are far less than a row, and back EMF looks alike in the position.
TEST_F(RecordedJoint, OfATwinWithASmallDelayLacksTheDelay) {
  const Outcome answer = answerFor("[effect transport_delay ShoulderR]\ndelay = 0.004 s\nreading = 0 s\n");
  EXPECT_EQ(answer.status, kNamed) << answer.said;
  EXPECT_THAT(names(), testing::ElementsAre("transport_delay"));
}

TEST_F(RecordedJoint, OfATwinWithAWeakGainLacksTheGain) {
  const Outcome answer = answerFor("[effect kp_scale ShoulderR]\nscale = 0.8\n");
  EXPECT_EQ(answer.status, kNamed) << answer.said;
  EXPECT_THAT(names(), testing::ElementsAre("kp_scale"));
  const Outcome planned =
      shell(std::string{DARWINOP_BIN} + "/darwinop-gap plan " + case_ + " " + (folder_ / "report/report.json"));
  EXPECT_EQ(planned.status, 0) << planned.said;
  EXPECT_THAT(planned.said, testing::HasSubstr("verdict: named"));
  EXPECT_THAT(planned.said, testing::Not(testing::HasSubstr("misfit"))) << "the search is not repeated";
  const Outcome both = shell(std::string{DARWINOP_BIN} + "/darwinop-gap plan " + case_ + " " +
                             (folder_ / "report/report.json") + " --against backlash,deadband");
  EXPECT_EQ(both.status, 2);
  EXPECT_THAT(both.said, testing::HasSubstr("--against both"));
}

}  // namespace
}  // namespace darwinop::gap
