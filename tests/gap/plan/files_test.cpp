// The files for `darwinop experiment run` are the planned experiments.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/format/experiment_files.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "gap/plan/commands.hpp"
#include "gap/plan/experiment_text.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/plan_rig.hpp"
#include "gap/plan/write_experiments.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;
using experiments::Experiment;
using testing::HasSubstr;

/// Phase by phase, whatever the round.
void expectSame(const Experiment& a, const Experiment& b) {
  std::vector<experiments::Phase> first, second;
  for (const auto& round : a.rounds) first.insert(first.end(), round.phases.begin(), round.phases.end());
  for (const auto& round : b.rounds) second.insert(second.end(), round.phases.begin(), round.phases.end());
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto &p = first[i], &q = second[i];
    EXPECT_EQ(p.goal.shape, q.goal.shape) << p.name;
    EXPECT_EQ(p.goal.to, q.goal.to) << p.name;
    EXPECT_EQ(p.goal.amplitude, q.goal.amplitude) << p.name;
    EXPECT_EQ(p.goal.period_s, q.goal.period_s) << p.name;
    EXPECT_EQ(p.goal.hz, q.goal.hz) << p.name;
    EXPECT_EQ(p.goal.goals, q.goal.goals) << p.name;
    EXPECT_EQ(p.goal.every_s, q.goal.every_s) << p.name;
    EXPECT_EQ(p.duration_s, q.duration_s) << p.name;
    EXPECT_EQ(p.velocity, q.velocity) << p.name;
    EXPECT_EQ(p.p_gain, q.p_gain) << p.name;
    EXPECT_EQ(p.torque, q.torque) << p.name;
    EXPECT_EQ(p.newton_meter.begin, q.newton_meter.begin) << p.name;
    EXPECT_EQ(p.newton_meter.end, q.newton_meter.end) << p.name;
    EXPECT_EQ(p.until, q.until) << p.name;
    EXPECT_EQ(p.within, q.within) << p.name;
    EXPECT_EQ(p.joints, q.joints) << p.name;
  }
  EXPECT_EQ(a.setup.pose, b.setup.pose);
  EXPECT_EQ(a.setup.is_clamped, b.setup.is_clamped);
  EXPECT_EQ(a.setup.duration_s, b.setup.duration_s);
  EXPECT_EQ(a.setup.settle_s, b.setup.settle_s);
  EXPECT_EQ(a.record_joints, b.record_joints);
  EXPECT_EQ(a.record_sensors, b.record_sensors);
  EXPECT_EQ(a.title, b.title);
}

TEST(ExperimentText, TheDeliveredSetComesBackToTheLastBit) {
  const std::vector<std::string> files = experiments::experimentFiles();
  ASSERT_GE(files.size(), 17U);
  for (const std::string& file : files) {
    const Experiment read = experiments::readExperiment(file);
    expectSame(read, experiments::parseExperiment(experimentText(read, {"for a test"}), file));
  }
}

TEST(ExperimentText, BenchExperimentsAreTakenByTheirReaderAndTheirCheck) {
  for (const Joint joint : {Joint::kShoulderR, Joint::kShoulderL})
    for (const Experiment& made : benchExperiments(armSetupFor(joint))) {
      const Experiment read = experiments::parseExperiment(experimentText(made, {}), made.name);
      expectSame(made, read);
      EXPECT_NO_THROW((void)experiments::makePlan(read, safety::hardRanges())) << made.name;
    }
}

TEST(MovedTo, KeepsTheAnglesOfTheArm) {
  const Experiment raised = experiments::readExperiment(experiments::findExperiment("p_gain"));  // ArmUpperR
  const auto moved = movedTo(armSetupFor(Joint::kShoulderL), raised);
  ASSERT_TRUE(moved);
  const auto& up = moved->rounds.at(0).phases.at(2);
  EXPECT_EQ(up.joints.at(0).joint, Joint::kShoulderL);
  EXPECT_NEAR(up.goal.to, 1.6, 1e-9) << "0.8 rad, 1.6 rad from where the upper arm hangs";
  EXPECT_NEAR(moved->setup.pose[index(Joint::kShoulderL)], 0.15, 1e-9);
  EXPECT_NO_THROW((void)experiments::makePlan(*moved, safety::hardRanges()));
}

TEST(MovedTo, LeavesAloneWhatMovesLegsOrSeveralJoints) {
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  for (const char* name : {"bow_forward", "gyroscope"})
    EXPECT_FALSE(movedTo(stand, experiments::readExperiment(experiments::findExperiment(name)))) << name;
}

TEST(Again, HasTheCommandsOfTheLog) {
  const Case bench = smallBench();
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  for (const Trajectory& log : bench.logs) {
    ExperimentCandidate candidate{.experiment = again(log, stand, "first_log_again"), .payload_kg = 0.3, .prepare = {}};
    const Experiment read = experiments::parseExperiment(experimentText(candidate.experiment, {}), "again");
    EXPECT_NO_THROW((void)experiments::makePlan(read, safety::hardRanges())) << log.kind;
    const std::vector<Stretch> stretches = commandsOf(candidate, read.rounds.at(0), stand);
    ASSERT_EQ(stretches.size(), 1U) << log.kind;
    const Trajectory& made = stretches[0].log;
    EXPECT_EQ(made.p_register, log.p_register);
    ASSERT_NEAR(double(made.rows()), double(log.rows()), 2) << log.kind;
    double worst = 0;
    for (std::size_t row = 1; row + 2 < log.rows(); ++row) {
      EXPECT_EQ(made.torque_on[row], log.torque_on[row]) << log.kind << row;
      // A time is a multiple of a row; rounding may take the row before or after.
      double off = 1e9;
      for (const std::size_t near : {row - 1, row, row + 1})
        off = std::min(off, std::abs(made.goal_rad[row] - log.goal_rad[near]));
      if (log.torque_on[row] != 0) worst = std::max(worst, off);
    }
    EXPECT_LT(worst, 1e-4) << log.kind;
  }
}

TEST(Commands, OneLogForEachPGain) {
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  const ExperimentCandidate candidate = named("steps_three_gains");
  std::vector<double> registers;
  for (const auto& round : candidate.experiment.rounds)
    for (const Stretch& stretch : commandsOf(candidate, round, stand)) registers.push_back(stretch.log.p_register);
  EXPECT_THAT(registers, testing::ElementsAre(8, 16, 32));
}

TEST(Commands, RefuseWhatALogDoesNotRecord) {
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  for (const auto& [name, why] : {std::pair{"max_torque", messages::kTorqueLimitNotLogged},
                                  {"applied_torque", messages::kTorqueNotLogged},
                                  {"speed", messages::kEndDependsOnMotion}}) {
    const ExperimentCandidate candidate{
        .experiment = *movedTo(stand, experiments::readExperiment(experiments::findExperiment(name))), .prepare = {}};
    const Vetted one = vetted(candidate, stand, smallBench(), {baselineOf(smallBench())});
    EXPECT_THAT(one.refused, HasSubstr(why)) << name;
  }
}

TEST(HandOver, WritesFilesThatRunAndStateTheirPurpose) {
  NextExperiments next;
  next.stand = armSetupFor(Joint::kShoulderL);
  const Case bench = smallBench();
  next.question = {
      Aim::kSeparate,
      {hypothesisWith(bench, "coulomb", "friction", 0.04, 1), hypothesisWith(bench, "com_mass", "mass", 0.1, 1)},
      0};
  Ranked ranked;
  ranked.vetted.candidate = named("steps_three_gains", next.stand);
  ranked.vetted.candidate.prepare = "hang 100 g more to the arm";  // no message
  ranked.vetted.seconds = 30;
  ranked.separations = {{0, 1, 9}};
  next.ranked.push_back(ranked);
  const fs::path folder = fs::path{testing::TempDir()} / "darwinop_plan_files";
  const std::vector<std::string> paths = writeBest(next, folder.string());
  ASSERT_EQ(paths.size(), 1U);
  const Experiment read = experiments::readExperiment(paths[0]);
  expectSame(ranked.vetted.candidate.experiment, read);
  EXPECT_EQ(commandFor("d/steps.ini"), "darwinop experiment run d/steps.ini --record steps.csv");
  const std::string text = fileOf(next, ranked);
  EXPECT_THAT(text, HasSubstr("; First: " + ranked.vetted.candidate.prepare));
  EXPECT_THAT(text, HasSubstr("\"joint\": \"ShoulderL\", \"hangs_at_rad\": 0, \"payload_kg\": 0.3"));
  EXPECT_THAT(text, HasSubstr("goals        = 0 rad, 0.9 rad, 0.3 rad, -0.9 rad, 0 rad"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace darwinop::gap
