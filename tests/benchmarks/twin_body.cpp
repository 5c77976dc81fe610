// The whole body with contacts, one core: a millisecond of the twin, and the plain step of the same MuJoCo body from
// the same states under the same torques, which is the limit.
#include <benchmark/benchmark.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/conversions.hpp"
#include "twin/body/robot_body.hpp"

namespace {

using namespace darwinop;
using Pose = std::array<double, kJoints>;

constexpr Nanos kMillisecond{1'000'000};
constexpr int kTurn = 1000;  // steps of a squat, and states that the plain step goes through again and again
// A robot that kneels slides into its loaded pose by fractions of a tick, and takes 8 s to do it.
constexpr int kSettling = 10'000;

enum class Motion { kKneeling, kStanding, kSquatting };

class Robot {
 public:
  Robot(const char* model, Motion motion) : body{twin::readModel(twin::findModel(model))}, motion_{motion} {
    if (motion == Motion::kKneeling)
      for (std::size_t i = 0; i < kJoints; ++i) pose_[i] = radFromTicks(kJointTable[i].start).value;
    else
      body.place(pose_);
    for (ServoDrive& drive : drives_)
      drive = {.torque_on = true, .speed_limit_rad_s = std::numeric_limits<double>::infinity(), .torque_limit = 1};
    for (int i = 0; i < kSettling; ++i) step();
  }
  void step() {
    if (motion_ == Motion::kSquatting) bendKnees(0.25 * (1 - std::cos(2 * kPi * now_ / kTurn)));
    now_ = (now_ + 1) % kTurn;
    for (std::size_t i = 0; i < kJoints; ++i) drives_[i].goal_rad = pose_[i];
    body.step(kMillisecond, drives_);
  }
  twin::RobotBody body;

 private:
  void bendKnees(double thigh_rad) {
    const auto both = [&](Joint right, Joint left, double angle) {
      pose_[index(right)] = angle;
      pose_[index(left)] = -angle;
    };
    both(Joint::kLegUpperR, Joint::kLegUpperL, -thigh_rad);
    both(Joint::kLegLowerR, Joint::kLegLowerL, 2 * thigh_rad);
    both(Joint::kAnkleR, Joint::kAnkleL, thigh_rad);
  }

  Motion motion_;
  Pose pose_{};
  Drives drives_{};
  int now_ = 0;
};

void finish(benchmark::State& state, const Robot& robot) {
  state.counters["times_real_time"] =
      benchmark::Counter(1e-3 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  if (robot.body.upright() < 0.9) state.SkipWithError("the robot fell over");
}

void ours(benchmark::State& state, const char* model, Motion motion) {
  Robot robot{model, motion};
  for (auto _ : state) robot.step();
  finish(state, robot);
}

// What a step begins with, and what the servos made of it.
struct Snapshot {
  Snapshot(Robot& robot, const mjModel& m, const mjData& d)
      : qpos(d.qpos, d.qpos + m.nq), qvel(d.qvel, d.qvel + m.nv), warm(d.qacc_warmstart, d.qacc_warmstart + m.nv) {
    robot.step();
    applied.assign(d.qfrc_applied, d.qfrc_applied + m.nv);
    damping.assign(m.dof_damping, m.dof_damping + m.nv);
    friction.assign(m.dof_frictionloss, m.dof_frictionloss + m.nv);
    motors.assign(m.tendon_frictionloss, m.tendon_frictionloss + m.ntendon);
  }
  void restore(mjModel& m, mjData& d) const {
    mju_copy(d.qpos, qpos.data(), m.nq);
    mju_copy(d.qvel, qvel.data(), m.nv);
    mju_copy(d.qacc_warmstart, warm.data(), m.nv);
    mju_copy(d.qfrc_applied, applied.data(), m.nv);
    mju_copy(m.dof_damping, damping.data(), m.nv);
    mju_copy(m.dof_frictionloss, friction.data(), m.nv);
    mju_copy(m.tendon_frictionloss, motors.data(), m.ntendon);
  }
  std::vector<mjtNum> qpos, qvel, warm, applied, damping, friction, motors;
};

void plain(benchmark::State& state, const char* model, Motion motion) {
  Robot robot{model, motion};
  auto& m = const_cast<mjModel&>(*robot.body.mujocoModel());
  mjData& d = *robot.body.mujocoData();
  std::vector<Snapshot> way;
  way.reserve(kTurn);
  while (way.size() < kTurn) way.emplace_back(robot, m, d);
  std::size_t next = 0;
  for (auto _ : state) {
    way[next].restore(m, d);
    next = (next + 1) % kTurn;
    mj_step(&m, &d);
  }
  finish(state, robot);
}

BENCHMARK_CAPTURE(ours, kneeling, "darwin-op", Motion::kKneeling);
BENCHMARK_CAPTURE(plain, kneeling, "darwin-op", Motion::kKneeling);
BENCHMARK_CAPTURE(ours, standing, "darwin-op", Motion::kStanding);
BENCHMARK_CAPTURE(plain, standing, "darwin-op", Motion::kStanding);
BENCHMARK_CAPTURE(ours, squatting, "darwin-op", Motion::kSquatting);
BENCHMARK_CAPTURE(plain, squatting, "darwin-op", Motion::kSquatting);
BENCHMARK_CAPTURE(ours, squatting_webots_2013, "webots-2013", Motion::kSquatting);
BENCHMARK_CAPTURE(plain, squatting_webots_2013, "webots-2013", Motion::kSquatting);

}  // namespace

BENCHMARK_MAIN();
