// What an export does to the gap: the targets move as their manuals say, and the logs are measured again by that.
#include "gap/export/semantics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "core/units.hpp"
#include "gap/export/bodies.hpp"
#include "gap/export/export_rig.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "support/shared_data.hpp"

namespace darwinop::gap {
namespace {

/// Where it stands after so long at a goal.
double settled(Target target, const Believed& model, double p_register, double goal_rad) {
  ExportSettings settings = forArm();
  settings.p_register = p_register;
  const auto joint = jointFor(target, model.get(), settings);
  joint->reset(0);
  for (long i = std::lround(5 / settings.stepOf(target)); i > 0; --i) joint->step(true, goal_rad);
  return joint->position_rad();
}

/// Released at 90 degrees: where it rests, and how far it swings to the other side.
struct Swing {
  double rest_rad, other_side_rad;
};
Swing released(Target target, const Believed& model) {
  const ExportSettings settings = forArm(0.1);
  const auto joint = jointFor(target, model.get(), settings);
  joint->reset(kPi / 2);
  double least = kPi / 2;
  for (long i = std::lround(20 / settings.stepOf(target)); i > 0; --i) {
    joint->step(false, kPi / 2);
    least = std::min(least, joint->position_rad());
  }
  return {joint->position_rad(), least};
}

// 2013 thesis, 5.3.3: a small P leaves a loaded arm short of the goal in the robot, and never in the simulator.
TEST(ExportSemantics, ALoadedJointArrivesInWebotsAndFallsShortInMujoco) {
  Believed model;
  const double goal = 1.0, weight_nm = armOf(model.get(), 0.3).weight_nm;
  for (const double p : {8.0, 32.0}) {
    EXPECT_NEAR(settled(Target::kWebots, model, p, goal), goal, 1e-6);
    EXPECT_NEAR(settled(Target::kUrdf, model, p, goal), goal, 1e-6);
    const double there = settled(Target::kMujoco, model, p, goal);
    EXPECT_NEAR(there, goal - weight_nm * std::sin(there) / (2.5 * 0.158 * p), 1e-4);
  }
}

TEST(ExportSemantics, ReleasedArmsSwingAndComeToRest) {
  for (const Target target : {Target::kWebots, Target::kMujoco, Target::kUrdf}) {
    const Swing swing = released(target, Believed{}.friction());
    EXPECT_LT(swing.other_side_rad, -0.1) << infoOf(target).title;
    // Friction holds it wherever gravity asks for less.
    const double most = std::asin(0.06 / armOf(Believed{}.get(), 0.1).weight_nm);
    EXPECT_LT(std::abs(swing.rest_rad), most + 0.01) << infoOf(target).title;
  }
}

TEST(ExportSemantics, WebotsKeepsSpeedAndAcceleration) {
  Believed model;
  model.bySpeed().with("accel_limit", "accel", 55).with("speed_limit", "speed", 3);
  const ExportSettings settings = forArm();
  const auto joint = jointFor(Target::kWebots, model.get(), settings);
  joint->reset(0);
  double last = 0, fastest = 0;
  for (int i = 0; i < 100; ++i) {
    joint->step(true, 2);
    EXPECT_LE(std::abs(joint->velocity_rad_s() - last), 55 * 0.016 + 1e-9);
    last = joint->velocity_rad_s();
    fastest = std::max(fastest, last);
  }
  EXPECT_NEAR(fastest, 3, 1e-6);
  EXPECT_NEAR(joint->position_rad(), 2, 0.01);
}

TEST(ExportSemantics, AGapLetsTheWebotsArmMoveBehindTheMotor) {
  Believed model;
  model.with("backlash", "play", 0.02);
  const auto joint = jointFor(Target::kWebots, model.get(), forArm());
  joint->reset(0);
  for (int i = 0; i < 300; ++i) joint->step(true, 1);
  EXPECT_NEAR(joint->position_rad(), 1, 1e-3);  // the sensor sees nothing of it
}

TEST(ExportSemantics, TwoConstraintsShareAsTheyMust) {
  // A motor that holds the gear, and a stop that the arm pushes against: the arm's push goes through to the motor.
  const double most = 1e9;
  const Constraint rows[] = {{.direction = {1, 0}, .wanted = 0, .low = -most, .high = most, .softness = 0},
                             {.direction = {-1, 1}, .wanted = 0, .low = 0, .high = most, .softness = 0}};
  const auto f = solveConstraints(rows, {1e8, 100}, {0, -5});
  EXPECT_NEAR(f[1], 0.05, 1e-9);
  EXPECT_NEAR(f[0], 0.05, 1e-9);
  const auto away = solveConstraints(rows, {1e8, 100}, {0, 5});
  EXPECT_EQ(away[1], 0);
  const Constraint weak[] = {{.direction = {1, 0}, .wanted = 3, .low = -0.01, .high = 0.01, .softness = 0}};
  EXPECT_EQ(solveConstraints(weak, {100, 0}, {0, 0})[0], 0.01);
}

/// A log that a twin made of this hypothesis, at 16 ms. `read_s`: after the write, which is 0.4 ms after the row; none:
/// read at the row, then written.
Case madeFrom(const Hypothesis& hypothesis, std::optional<double> read_s = {}) {
  Case made;
  made.name = "made";
  made.model.servo = hypothesis.servo;
  made.model.effects.assign(hypothesis.effects.begin(), hypothesis.effects.end());
  made.pendulum = hypothesis.pendulum;
  for (const bool held_out : {false, true}) {
    Trajectory log;
    log.file = held_out ? "score.csv" : "fit.csv";
    log.held_out = held_out;
    log.payload_kg = 0.3;
    for (int i = 0; i < 400; ++i) {
      const double t = 0.016 * i;
      log.time_s.push_back(t);
      log.goal_rad.push_back(held_out ? 0.9 * std::sin(3 * t) : (i / 100 % 2 == 0 ? 0.8 : -0.5));
      log.torque_on.push_back(i < 330 ? 1 : 0);
      log.lines.push_back(0);
      if (!read_s) continue;
      log.written_s.push_back(0.0004);
      log.read_s.push_back(0.0004 + *read_s);
    }
    for (auto* column : {&log.position_rad, &log.speed_rad_s, &log.load, &log.volt_v, &log.temp_c})
      column->assign(400, std::numeric_limits<double>::quiet_NaN());
    made.logs.push_back(log);
  }
  for (std::size_t i = 0; i < made.logs.size(); ++i) {
    Trace trace;
    rollOut(made, i, hypothesis, {}, trace);
    made.logs[i].position_rad = trace[kPositionSignal];
  }
  return made;
}

TEST(ExportSemantics, WhatMujocoRepresentsLeavesNoGapAtASmallStep) {
  Believed model;
  model.friction();
  const Case made = madeFrom(model.get());
  ExportSettings fine = settingsFor(made);
  fine.step_s = 0.0001;
  const ReMeasured measured = remeasure(Target::kMujoco, made, model.get(), fine);
  EXPECT_LT(measured.twin_fit_mrad, 1e-9);
  EXPECT_LT(measured.target_fit_mrad, 2);
  EXPECT_LT(measured.target_held_out_mrad, 2);
  const ReMeasured usual = remeasure(Target::kMujoco, made, model.get());
  EXPECT_EQ(usual.step_s, 0.002);
  EXPECT_GT(usual.target_fit_mrad, measured.target_fit_mrad);
}

// In a recording a servo is read some milliseconds after its goal was written.
TEST(ExportSemantics, AReadAfterItsWriteIsReplayedAtItsTime) {
  Believed model;
  model.friction();
  for (const double read_s : {0.001, 0.006}) {
    const Case made = madeFrom(model.get(), read_s);
    ExportSettings fine = settingsFor(made);
    fine.step_s = 0.0001;
    const ReMeasured measured = remeasure(Target::kMujoco, made, model.get(), fine);
    EXPECT_LT(measured.twin_fit_mrad, 1e-9);
    EXPECT_LT(measured.target_fit_mrad, 2) << read_s;
    EXPECT_LT(measured.target_held_out_mrad, 2) << read_s;
  }
}

TEST(ExportSemantics, WhatWebotsCannotRepresentShowsInItsGap) {
  Believed model;
  model.friction();
  const Case made = madeFrom(model.get());
  const ReMeasured webots = remeasure(Target::kWebots, made, model.get());
  const ReMeasured mujoco = remeasure(Target::kMujoco, made, model.get());
  EXPECT_GT(webots.target_held_out_mrad, 3 * mujoco.target_held_out_mrad);
  EXPECT_NE(asText(webots).find("Webots"), std::string::npos);
  EXPECT_NE(asText(webots).find("score.csv (held out)"), std::string::npos);
}

TEST(ExportSemantics, TheThesisModelIsExactInWebots) {
  Believed model;
  model.bySpeed().with("accel_limit", "accel", 55).with("coulomb", "friction", 0.025).with("viscous", "damping", 0.002);
  Hypothesis h = model.get();
  h.servo.armature_kgm2 = 0;
  const Case made = madeFrom(h);
  ExportSettings fine = settingsFor(made);
  fine.step_s = 0.001;  // as the twin's period
  EXPECT_LT(remeasure(Target::kWebots, made, h, fine).target_held_out_mrad, 10);
  EXPECT_GT(remeasure(Target::kWebots, made, h).target_held_out_mrad, 10);  // 16 ms cost
}

TEST(ExportSemantics, ExampleCasesAreMeasuredAgain) {
  const std::filesystem::path path = sharedData("gap-cases/cases/e01");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no example case in " << path;
  const Case given = readCase(path);
  for (const TargetInfo& info : kTargetTable) {
    const ReMeasured measured = remeasure(info.target, given, baselineOf(given));
    EXPECT_EQ(measured.logs.size(), given.logs.size());
    EXPECT_GT(measured.twin_held_out_mrad, 0);
    EXPECT_TRUE(std::isfinite(measured.target_held_out_mrad) && measured.target_held_out_mrad < 1000)
        << asText(measured);
  }
}

}  // namespace
}  // namespace darwinop::gap
