// `darwinop gap run` on a folder of raw logs, from files to a verdict in one command.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gap/case/bam_log.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/write_case.hpp"
#include "gap/small_case.hpp"
#include "support/shared_data.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kFriction = 0.05;  // N m, of the servo that was measured
constexpr int kNamed = 10, kAmbiguous = 11, kBadInput = 2;
const std::string kRun = std::string{DARWINOP_GAP} + " run ";
/// What a data sheet says of the servo of smallBench().
const std::string kSheet =
    " --declare stall_Nm_at_12V=2.5 --declare stall_A_at_12V=1.4 --declare duty_per_kp_per_rad=0.158";

Case measuredBench() {
  const Case bench = smallBench();
  Hypothesis truth = baselineOf(bench);
  truth.with(*twin::findEffect("coulomb")).values = {kFriction};
  return measured(bench, truth, 7);
}

void write(const std::string& path, const std::string& text) {
  std::ofstream{path} << text;
}

/// The lines of a CSV with two more columns.
std::string withBench(const std::string& csv, const Trajectory& log) {
  std::istringstream lines{csv};
  std::string out, line;
  for (bool head = true; std::getline(lines, line); head = false) {
    std::ostringstream more;
    if (head)
      more << ",kp,payload_kg";
    else
      more << ',' << log.p_register << ',' << log.payload_kg;
    out += line + more.str() + "\n";
  }
  return out;
}

/// Answer of `run --json`, and that it names the friction with its number.
void expectFriction(const Outcome& outcome, const std::string& report) {
  EXPECT_THAT(outcome.status, testing::AnyOf(kNamed, kAmbiguous)) << outcome.said;
  const auto json = nlohmann::json::parse(textOf(report + "/report.json"));
  std::vector<std::string> ids;
  for (const auto& effect : json["effects"]) {
    ids.push_back(effect["id"]);
    if (ids.back() == "coulomb") {
      EXPECT_NEAR(effect["params"]["friction"].get<double>(), kFriction, 0.2 * kFriction);
    }
  }
  EXPECT_THAT(ids, Contains("coulomb"));
  EXPECT_LT(json["held_out"]["after_mrad"].get<double>(), 0.3 * json["held_out"]["before_mrad"].get<double>());
}

TEST(RawLogs, OfCsvGiveANameInOneCommand) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "servo");
  const Case bench = measuredBench();
  for (const Trajectory& log : bench.logs) write(folder / "servo/" + log.file, withBench(logAsCsv(log), log));
  const std::string report = folder / "report", run = kRun + (folder / "servo") + " --no-open --report " + report;
  const Outcome asked = shell(run);
  EXPECT_EQ(asked.status, kBadInput);
  for (const char* const missing : {"length_m", "supply_V", "stall_Nm", "stall_A", "duty_per_kp_per_rad"})
    EXPECT_THAT(asked.said, HasSubstr(missing));
  EXPECT_THAT(asked.said, testing::Not(HasSubstr("kp="))) << "a column has it";
  expectFriction(
      shell(run + kSheet + " --declare length_m=0.14 --declare arm_mass_kg=0.03 --declare supply_V=12 --keep kept"),
      report);
}

TEST(RawLogs, OfBamGiveANameInOneCommand) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "servo");
  const Case bench = measuredBench();
  for (const Trajectory& log : bench.logs)
    write((folder / "servo/") + log.kind + ".json", asBamJson(bench, log, "own"));
  const std::string report = folder / "report", run = kRun + (folder / "servo") + " --no-open --report " + report;
  EXPECT_EQ(shell(run).status, kBadInput) << "the motor is not known";
  const Outcome named = shell(run + kSheet + " --keep kept");
  expectFriction(named, report);
  EXPECT_THAT(named.said, HasSubstr(messages::kArmatureAssumed));

  const std::string made = report + "/case/case.json", edited = textOf(made) + "\n";
  write(made, edited);
  const Outcome again = shell(run + kSheet + " --keep kept");
  EXPECT_EQ(again.status, kBadInput);
  EXPECT_THAT(again.said, HasSubstr(made));
  EXPECT_EQ(textOf(made), edited) << "it is kept";
}

TEST(RawLogs, RefuseWhatCannotBeDeclared) {
  const TemporaryFolder folder;
  const Case bench = measuredBench();
  write(folder / "a.csv", logAsCsv(bench.logs[0]));
  const std::string run = kRun + (folder / "");
  EXPECT_THAT(shell(run + " --declare lenght_m=0.1").said,
              AllOf(HasSubstr(messages::kNotDeclarable), HasSubstr(" length_m?")));
  EXPECT_THAT(shell(run + " --declare stal_A_at_5V=1").said, HasSubstr(" stall_A_at_5V?"));
  EXPECT_THAT(shell(run + " --declare colour=red").said, HasSubstr("payload_kg, "));
  EXPECT_THAT(shell(run + kSheet + " --declare stall_Nm_at_12V=2,4").said, HasSubstr(messages::kDecimalComma));
  EXPECT_THAT(shell(run + " --declare kp=many").said, HasSubstr(messages::kNotKeyValue));
  EXPECT_THAT(shell(run + " --declare=kp").said, HasSubstr(messages::kNotKeyValue));
}

TEST(RawLogs, RefuseAColumnWithSeveralValuesOfTheBench) {
  const TemporaryFolder folder;
  const Case bench = measuredBench();
  std::string csv = withBench(logAsCsv(bench.logs[0]), bench.logs[0]);
  csv.replace(csv.find(",16,"), 4, ",,");  // not received: no second value
  write(folder / "a.csv", csv);
  EXPECT_THAT(shell(kRun + (folder / "")).said, Not(HasSubstr(messages::kSeveralValues)));
  csv.replace(csv.rfind(",16,"), 4, ",32,");
  write(folder / "a.csv", csv);
  EXPECT_THAT(shell(kRun + (folder / "")).said, HasSubstr(messages::kSeveralValues));
}

/// The same log as a program for an arm writes it: no torque_on, and a second joint that does something else.
std::string asLogOfAnArm(const std::string& csv) {
  std::istringstream lines{csv};
  std::string out, line;
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, line.find(",load")), "t_s,goal_rad,torque_on,pos_rad") << "columns of a case's log";
  out = "t_s,goal_Pitch_rad,goal_Wrist_Pitch_rad,pos_Pitch_rad,pos_Wrist_Pitch_rad,speed_Pitch_50steps_s\n";
  while (std::getline(lines, line)) {
    std::istringstream cells{line};
    std::string time, goal, torque, position;
    std::getline(cells, time, ',');
    std::getline(cells, goal, ',');
    std::getline(cells, torque, ',');
    std::getline(cells, position, ',');
    out.append(time).append(",").append(goal).append(",0.1,").append(position).append(",0.2,7\n");
  }
  return out;
}

TEST(RawLogs, OfAnArmAreReadJointByJoint) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "arm");
  const Case bench = measuredBench();
  const Trajectory& log = bench.logs[0];
  write(folder / "arm/steps.csv", asLogOfAnArm(logAsCsv(log)));
  const std::string make = std::string{DARWINOP_GAP} + " case --from-csv " + (folder / "arm") + kSheet +
                           " --declare torque_on=1 --declare kp=16 --declare payload_kg=0.3 --declare length_m=0.14" +
                           " --declare supply_V=12 --declare from_s=0.4 --declare to_s=3 --declare hangs_at_rad=0.25" +
                           " --declare payload_kg_rel_sigma=0.5 --out " + (folder / "case");
  EXPECT_THAT(shell(make).said, HasSubstr("goal")) << "two goals, and no word of which";
  const Outcome other = shell(make + " --declare joint=Wrist");
  EXPECT_THAT(other.said, HasSubstr(messages::kNoGoalOfJoint));
  EXPECT_THAT(other.said, HasSubstr("Pitch, Wrist_Pitch"));
  const Outcome made = shell(make + " --declare joint=Pitch");
  ASSERT_EQ(made.status, 0) << made.said;
  EXPECT_THAT(made.said, HasSubstr(messages::kUnitLeftOut));
  const Case read = readCase(folder / "case");
  EXPECT_EQ(std::ranges::find(read.priors, "payload", &Prior::number)->relative_sigma, 0.5);
  const Trajectory& of_joint = read.logs.at(0);
  ASSERT_GT(of_joint.rows(), 100U);
  EXPECT_NEAR(of_joint.time_s.front(), 0.4, kRow);
  EXPECT_NEAR(of_joint.time_s.back(), 3, kRow);
  for (std::size_t row = 0, from = 25; row < of_joint.rows(); ++row) {
    ASSERT_NEAR(of_joint.time_s[row], log.time_s[row + from], 1e-9);
    ASSERT_NEAR(of_joint.goal_rad[row], log.goal_rad[row + from] - 0.25, 1e-6);
    ASSERT_NEAR(of_joint.position_rad[row], log.position_rad[row + from] - 0.25, 1e-6);
    ASSERT_EQ(of_joint.torque_on[row], 1);
  }
}

// Two minutes of processor time. The fitted logs end at 71 % of the duty.
TEST(RealServo, LeavesOpenWhatOnlyFullDutyDecides) {
  if (!std::filesystem::exists(sharedData("real-servo"))) GTEST_SKIP() << "no logs of a real servo";
  const TemporaryFolder folder;
  const std::string report = folder / "report";
  const Outcome outcome = shell(kRun + sharedData("real-servo").string() + " --no-open --report " + report);
  EXPECT_EQ(outcome.status, kAmbiguous) << outcome.said;
  const auto json = nlohmann::json::parse(textOf(report + "/report.json"));
  EXPECT_THAT(json["ambiguity"][0], testing::IsSupersetOf({"quadratic_load_friction", "torque_limit"}));
  EXPECT_LE(json["ambiguity"][0].size(), 3U) << "a set of more separates nothing";
  for (const auto& effect : json["effects"]) {
    EXPECT_NE(effect["id"], "supply_sag");
    if (effect["id"] == "kp_scale") {
      EXPECT_NEAR(effect["params"]["scale"].get<double>(), 0.5, 0.01);
    }
  }
  EXPECT_LT(json["mean_error_held_out_after_mrad"].get<double>(), 40);
}

}  // namespace
}  // namespace darwinop::gap
