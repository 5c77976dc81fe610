// The shipped experiments, run on the twin, reproduce the findings of the 2013 thesis.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/run/models.hpp"
#include "experiments/run/rig.hpp"

namespace darwinop::experiments {
namespace {

Experiment delivered(const std::string& name) {
  return readExperiment(DARWINOP_SUITE "/" + name + ".ini");
}
double angle(const VirtualRun::Row& row, Joint joint) {
  return row.seen.joint[index(joint)].position.value;
}

constexpr double kStep = 0.016;  // s, period of loop and log
constexpr double kTiny = 1e-9;   // rounding of summed steps

/// Final error of each step to 0.8 rad, rad, by rising P gain.
std::vector<double> missing(const std::string& model) {
  const Experiment experiment = delivered("p_gain");
  VirtualRun run{experiment, model};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  std::vector<double> errors;
  for (const Round& round : experiment.rounds)
    errors.push_back(0.8 - angle(run.rowsOf(round.label + ", up").back(), Joint::kArmUpperR));
  return errors;
}

TEST(PGain, OnSpeedTheArmAlwaysArrives) {
  const std::vector<double> errors = missing("twin:webots-2013");
  ASSERT_EQ(errors.size(), 6U);
  // The error of 1.45 rad decays with exp(-P t): at P = 0.5, 9.8 mrad remain after 10 s. At higher gains only encoder
  // and goal quantization remain.
  EXPECT_NEAR(errors[0], 1.45 * std::exp(-5), 3 * kRadPerTick) << "P = 0.5";
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(errors[i], 0, 2.5 * kRadPerTick) << i;
}

// The arm is horizontal at 0.8 rad: 168 g at 36 mm and 59 g at 106 mm give 0.120 N m. Dry friction of 0.025 N m adds to
// the load; the motor gives 3.16 N m/rad at P = 1.
TEST(PGain, OnTorqueTheArmStopsShortAndLessSoWithMoreGain) {
  const Experiment experiment = delivered("p_gain");
  VirtualRun run{experiment, "twin"};
  ASSERT_EQ(run.run(), RunOutcome::kDone);
  double before = 1;
  for (const Round& round : experiment.rounds) {
    const auto rows = run.rowsOf(round.label + ", up");
    const double gain = round.phases.back().p_gain, error = 0.8 - angle(rows.back(), Joint::kArmUpperR);
    EXPECT_NEAR(error, (0.120 + 0.025) / (3.16 * gain), 1.5 * kRadPerTick)
        << round.label << ": tolerance of an encoder tick";
    EXPECT_LT(error, before) << round.label;
    const double second_before = angle(rows.at(rows.size() - 63), Joint::kArmUpperR);
    EXPECT_NEAR(0.8 - second_before, error, 1.5 * kRadPerTick) << round.label << ": must be at rest";
    before = error;
  }
}

/// Seconds until the head stays at the end of half a turn, by rising speed setting. Resolution 16 ms.
std::vector<double> halfTurns(const std::string& model) {
  const Experiment experiment = delivered("speed");
  VirtualRun run{experiment, model};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  std::vector<double> seconds;
  for (const Round& round : experiment.rounds) {
    auto rows = run.rowsOf(round.label + ", right");
    const auto rest = run.rowsOf(round.label + ", rest");
    rows.insert(rows.end(), rest.begin(), rest.end());
    const auto away = std::find_if(rows.rbegin(), rows.rend(), [](const VirtualRun::Row& row) {
      return std::abs(angle(row, Joint::kNeck) + kPi / 2) > 0.05;
    });
    seconds.push_back(static_cast<double>(rows.rend() - away) * kStep);
  }
  return seconds;
}

// A limit of 55 rad/s2 costs v / (2 * 55) s: 5 ms at 0.5 rad/s, 111 ms at 12.2 rad/s, partly recovered later. With
// P = 10 the acceleration never exceeds P v.
TEST(Speed, OnlyFastTurnsShowAnAccelerationLimit) {
  const Models models;
  const auto limited = halfTurns("twin:webots-2013");
  const auto unlimited = halfTurns(models.copy("webots-2013", "accel_max = 55 rad/s2", "accel_max = none"));
  const std::vector<double> speeds{0.5, 1, 2, 4, 8, 12.2};
  ASSERT_EQ(limited.size(), speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double more = limited[i] - unlimited[i];
    EXPECT_GE(more, -kTiny) << speeds[i];
    EXPECT_LE(more, speeds[i] / 110 + kStep) << speeds[i] << ": plus one log period";
    if (speeds[i] < 3) {
      EXPECT_LE(more, 0.012 * unlimited[i]) << speeds[i] << ": the curves coincide";
    }
    if (speeds[i] > 6) {
      EXPECT_GE(more, 0.04 * unlimited[i]) << speeds[i] << ": the curves differ";
      EXPECT_GE(more, 2 * kStep - kTiny) << speeds[i] << ": visible in the log";
    }
  }
}

/// One release of the arm, until rest.
std::vector<double> release(const std::string& model) {
  Experiment experiment = delivered("damping");
  experiment.rounds.resize(1);
  VirtualRun run{experiment, model};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  std::vector<double> angles;
  for (const auto& row : run.rowsOf("release")) angles.push_back(angle(row, Joint::kShoulderR));
  return angles;
}

double apart(std::vector<double> a, std::vector<double> b) {
  const std::size_t size = std::max(a.size(), b.size());
  a.resize(size, a.back());
  b.resize(size, b.back());
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(size));
}

/// Number of reversals of more than a hundredth of a turn.
int swings(const std::vector<double>& angles) {
  int count = 0;
  double extreme = angles.front(), way = -1;
  for (const double a : angles) {
    if ((a - extreme) * way > 0) extreme = a;
    if ((extreme - a) * way > 0.06) {
      ++count;
      way = -way;
      extreme = a;
    }
  }
  return count;
}

std::string damped(const Models& models, double dry_nm, double viscous_nms) {
  return models.with("darwin-op", "[effect coulomb ShoulderR]\nfriction = " + std::to_string(dry_nm) +
                                      " N m\n[effect viscous ShoulderR]\ndamping = " + std::to_string(viscous_nms) +
                                      " N m s/rad\n");
}

// The model has the friction of the thesis: viscous 0.002 N m s/rad, dry 0.025 N m.
TEST(Damping, ViscousDampingAloneCannotMatchDryFriction) {
  const Models models;
  const auto arm = release("twin");
  double best = 10, worst_of_ends = 10;
  const std::vector<double> scan{0.004, 0.009, 0.0125, 0.018, 0.03};
  for (const double viscous : scan) {
    const auto other = release(damped(models, 0, viscous));
    const double rms = apart(arm, other);
    best = std::min(best, rms);
    if (viscous == scan.front() || viscous == scan.back()) worst_of_ends = std::min(worst_of_ends, rms);
    // Final angle 0.129 rad (vertical, the trunk pitches forward); dry friction stops the arm within
    // asin(0.025 / 0.12) = 0.21 rad of it.
    if (viscous > 0.008) {
      EXPECT_NEAR(other.back(), 0.129, 0.01) << viscous;
    }
    EXPECT_FALSE(swings(other) == swings(arm) && std::abs(other.back() - arm.back()) < 0.04) << viscous;
  }
  EXPECT_EQ(swings(arm), 2);
  EXPECT_GT(std::abs(arm.back() - 0.129), 0.04);
  EXPECT_LT(std::abs(arm.back() - 0.129), 0.21);
  EXPECT_GT(best, 0.05) << "rad rms: 30 encoder ticks";
  EXPECT_LT(apart(arm, release(damped(models, 0.025, 0.0022))), 0.02) << "both kinds of friction, one 10 % too large";
  EXPECT_LT(best, 0.6 * worst_of_ends) << "the optimum is within the scanned range";
}

/// The robot bows until it falls. Returns the ankle angle at the fall, rad.
double bow(const std::string& name, const std::string& model) {
  VirtualRun run{delivered(name), model};
  EXPECT_EQ(run.run(), RunOutcome::kDone) << "an expected fall is not a failure";
  const auto rows = run.rowsOf("bow"), lie = run.rowsOf("lie");
  EXPECT_LT(static_cast<double>(rows.size()) * kStep, 35) << "without a fall the phase takes 40 s";
  EXPECT_EQ(rows.front().seen.safety.worst, Fault::kNone) << "no fault until the fall";
  EXPECT_EQ(run.rows.back().seen.safety.worst, Fault::kFell);
  // The accelerometer's y is -1 g on the face, +1 g on the back; arms and head keep the trunk slightly tilted.
  const double y = lie.back().seen.board.accelerometer[1].value / 9.81;
  EXPECT_NEAR(name == "bow_forward" ? -y : y, 0.9, 0.2);
  const std::size_t ankle = index(Joint::kAnkleR);
  return std::abs(rows.back().asked.joint[ankle].goal.value - rows.front().asked.joint[ankle].goal.value);
}

// 5.2.1: with the trunk's mass shifted down and back the simulated robot falls at a larger angle in both directions,
// more so forward. The default model has half of that shift, as the thesis concludes.
TEST(Bow, Webots2013FallsAtLargerAnglesMoreSoForward) {
  const double forward = bow("bow_forward", "twin:webots-2013") - bow("bow_forward", "twin");
  const double backward = bow("bow_backward", "twin:webots-2013") - bow("bow_backward", "twin");
  // Half the shift is 15 mm back and 20 mm down for a third of the weight, about 0.2 m above the ankles: a few 0.01
  // rad, and about the same for the steady-state error of the ankles with P on torque.
  EXPECT_GT(backward, 0.02);
  EXPECT_GT(forward, backward + 0.02);
  EXPECT_LT(forward, 0.15);
}

}  // namespace
}  // namespace darwinop::experiments
