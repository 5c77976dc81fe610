// Every shipped experiment by command: on the virtual robot and on the twin, with both recordings in one plot.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/joints.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/logs/read_log.hpp"
#include "safety/config.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;

std::vector<std::string> suite() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{DARWINOP_SUITE}) names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

bool known(double value) {
  return !std::isnan(value);
}

class OnBoth : public Rig, public testing::WithParamInterface<std::string> {
 protected:
  /// Runs the command; the output is in `output`.
  int experiment(std::vector<std::string> words) {
    words.insert(words.begin(), program("darwinop-experiment"));
    Program command{words, file("out.txt")};
    const int status = command.wait(std::chrono::seconds{120}).value_or(-1);
    output = command.output();
    return status;
  }
  void runAndLookAtTheLog(const std::string& robot);
  std::string output;
};

/// Checks a joint that the experiment records.
void expectMeasured(const logs::Log& log, Joint joint) {
  const std::string name{row(joint).name};
  const safety::JointRange allowed = safety::hardRanges()[index(joint)];
  const auto& position = log.column(name + ".position").values;
  const auto& asked = log.column(name + ".asked").values;
  EXPECT_TRUE(std::isnan(position.front())) << name << ": no reply in the first cycle";
  EXPECT_TRUE(std::isnan(asked.front())) << name << ": no command in the first cycle";
  EXPECT_GT(std::ranges::count_if(position, known), 0.95 * static_cast<double>(log.rows())) << name;
  EXPECT_GT(std::ranges::count_if(asked, known), 0.8 * static_cast<double>(log.rows())) << name;
  double low = 10, high = -10;
  for (const double rad : position)
    if (known(rad)) {
      low = std::min(low, rad);
      high = std::max(high, rad);
    }
  EXPECT_GT(high - low, 0.08) << name << ": the smallest amplitude is 5 degrees";
  // A limp arm may swing slightly beyond its limit.
  EXPECT_GT(low, allowed.low.value - 0.1) << name;
  EXPECT_LT(high, allowed.high.value + 0.1) << name;
}

void OnBoth::runAndLookAtTheLog(const std::string& robot) {
  const std::string path = file(robot + ".csv");
  ASSERT_EQ(experiment({"run", GetParam(), "--robot", robot, "--record", path}), 0) << output;
  const logs::Log log = logs::readLog(path);
  EXPECT_TRUE(log.complete);
  EXPECT_THAT(log.warnings, testing::IsEmpty());
  EXPECT_EQ(log.headValue("experiment"), GetParam());
  const auto described = experiments::readExperiment(DARWINOP_SUITE "/" + GetParam() + ".ini");
  for (const Joint joint : described.record_joints) expectMeasured(log, joint);
  for (const std::string& sensor : described.record_sensors)
    EXPECT_GT(std::ranges::count_if(log.column(sensor + ".z").values, known), 0.95 * static_cast<double>(log.rows()));
}

TEST_P(OnBoth, RunsWithARecordingAndPlots) {
  for (const char* robot : {"virtual", "twin"}) runAndLookAtTheLog(robot);
  if (process::findProgram("gnuplot").empty()) GTEST_SKIP() << "gnuplot is not installed";
  ASSERT_EQ(experiment({"plot", file("virtual.csv"), file("twin.csv"), "-o", file("both")}), 0) << output;
  EXPECT_THAT(output, testing::Not(HasSubstr("note:"))) << "an incomplete plot";
  const auto content = [this](const char* name) {
    std::ostringstream text;
    text << std::ifstream{file(name), std::ios::binary}.rdbuf();
    return text.str();
  };
  EXPECT_THAT(content("both.html"), HasSubstr("\"title\":\"" + GetParam() + ": "));
  for (const char* curve : {"\"label\":\"virtual\",\"log\":0", "\"label\":\"twin\",\"log\":1"})
    EXPECT_THAT(content("both.html"), HasSubstr(curve));
  EXPECT_TRUE(content("both.png").starts_with("\x89PNG"));
  EXPECT_GT(content("both.png").size(), 10'000U) << "an empty frame is smaller";
}

INSTANTIATE_TEST_SUITE_P(Suite, OnBoth, testing::ValuesIn(suite()), [](const auto& test) { return test.param; });

}  // namespace
}  // namespace darwinop
