// The example cases of other simulators, and logs of a real servo: they are read without warnings.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "core/units.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/case/bad_rows.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/write_case.hpp"
#include "support/shared_data.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> exampleCases() {
  std::vector<fs::path> found;
  if (!fs::exists(sharedData("gap-cases/cases"))) return found;
  for (const auto& entry : fs::directory_iterator{sharedData("gap-cases/cases")}) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

std::vector<std::string_view> hidden(const DataCheck& check) {
  std::vector<std::string_view> ids;
  for (const DataFinding& finding : check.findings)
    if (!finding.reveals) ids.push_back(finding.id);
  return ids;
}

TEST(ExampleCases, AreReadWithoutAWarning) {
  const auto cases = exampleCases();
  if (cases.empty()) GTEST_SKIP() << "no example cases in " << sharedData("gap-cases/cases");
  for (const fs::path& folder : cases) {
    const Case c = readCase(folder);
    const DataCheck check = checkData(c);
    EXPECT_THAT(check.warnings, testing::ElementsAre()) << folder;
    EXPECT_THAT(check.masked, testing::ElementsAre()) << folder;
    EXPECT_EQ(c.name, folder.filename());
    EXPECT_EQ(c.logs.size(), 10u);
    EXPECT_TRUE(c.datasheet.has_value());
    EXPECT_TRUE(check.has_repeats);
    for (const char* id : {"load_column", "torque_off", "payloads", "temperature", "repeats", "both_sides"})
      EXPECT_THAT(hidden(check), testing::Not(testing::Contains(id))) << folder;
  }
}

TEST(ExampleCases, AreWrittenWithoutLoss) {
  const auto cases = exampleCases();
  if (cases.size() < 5) GTEST_SKIP() << "no example cases in " << sharedData("gap-cases/cases");
  const TemporaryFolder folder;
  for (const std::size_t i : {0u, 4u}) {  // one of each law
    const Case c = readCase(cases[i]);
    EXPECT_TRUE(fitsBaseline(c));
    writeCase(c, folder / c.name);
    const Case back = readCase(folder / c.name);
    EXPECT_EQ(caseAsJson(back, false), caseAsJson(c, false));
    for (std::size_t log = 0; log < c.logs.size(); ++log) {
      EXPECT_EQ(back.logs[log].position_rad, c.logs[log].position_rad);  // to the last bit: few digits
      EXPECT_EQ(back.logs[log].time_s, c.logs[log].time_s);
      EXPECT_EQ(logAsCsv(back.logs[log]), logAsCsv(c.logs[log]));
    }
  }
}

TEST(ExampleCases, InDegreesAreRefused) {
  const auto cases = exampleCases();
  if (cases.empty()) GTEST_SKIP() << "no example cases in " << sharedData("gap-cases/cases");
  constexpr double degrees_a_rad = 57.29577951308232;
  for (std::size_t i = 0; i < cases.size(); i += 4) {
    const fs::path& path = cases[i];
    Case c = readCase(path);
    for (Trajectory& log : c.logs) {
      for (double& goal : log.goal_rad) goal *= degrees_a_rad;
      for (double& position : log.position_rad) position *= degrees_a_rad;
    }
    const TemporaryFolder folder;
    writeCase(c, folder / "degrees");
    EXPECT_THROW(readCase(folder / "degrees"), BadInput) << path;
  }
}

TEST(RealServo, IsReadAndItsLimitsAreReported) {
  if (!fs::exists(sharedData("real-servo"))) GTEST_SKIP() << "no logs of a real servo in " << sharedData("real-servo");
  const Case c = readCase(sharedData("real-servo"));
  EXPECT_EQ(c.goal_order, GoalOrder::kBeforeRead);
  EXPECT_EQ(c.logs.size(), 12u);
  EXPECT_EQ(c.model.effects.size(), 0u);  // the manual says nothing of friction
  ASSERT_TRUE(c.datasheet.has_value());
  EXPECT_NEAR(c.datasheet->servo.kt_nm_a, 0.354, 0.001);
  EXPECT_NEAR(c.datasheet->servo.resistance_ohm, 3.4, 0.01);
  EXPECT_NEAR(c.datasheet->servo.duty_per_kp_per_rad, 0.005755, 1e-6);
  const DataCheck check = checkData(c);
  EXPECT_THAT(check.warnings, testing::ElementsAre());
  EXPECT_THAT(hidden(check), testing::IsSupersetOf({"payloads", "temperature", "repeats", "held_out_load"}));
  EXPECT_THAT(hidden(check), testing::Not(testing::Contains("torque_off")));
}

TEST(RealServo, LoneFalseReadingsAreFoundAndNoOthers) {
  if (!fs::exists(sharedData("real-servo"))) GTEST_SKIP() << "no logs in " << sharedData("real-servo");
  Case c = readCase(sharedData("real-servo"));
  EXPECT_THAT(contradictionsOf(c), testing::IsEmpty());
  for (Trajectory& log : c.logs) {
    ASSERT_TRUE(log.masked.empty()) << log.file;
    std::size_t planted = 0;
    for (std::size_t row = 7; row + 7 < log.rows(); row += 100, planted += 2) {
      log.position_rad[row] = -kPi;  // a register that came back as 0
      log.position_rad[row + 50 < log.rows() - 7 ? row + 50 : row - 3] += 0.1;
      log.volt_v[row] = 0;
    }
    maskBadRows(log, log.file, c);
    std::size_t positions = 0, volts = 0;
    for (const MaskedReadings& masked : log.masked) (masked.column == "pos" ? positions : volts) += masked.rows;
    EXPECT_EQ(positions, planted) << log.file;
    EXPECT_EQ(volts, planted / 2) << log.file;
  }
}

}  // namespace
}  // namespace darwinop::gap
