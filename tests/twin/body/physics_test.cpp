// Free motion against closed forms: energy, momentum, a swinging arm; and runs that repeat.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

double energyOf(RobotBody& body) {
  const mjModel& m = *body.mujocoModel();
  mjData& d = *body.mujocoData();
  mj_forward(&m, &d);
  mj_energyPos(&m, &d);
  mj_energyVel(&m, &d);
  return d.energy[0] + d.energy[1];
}

TEST(Flight, KeepsEnergyAndAngularMomentum) {
  RobotBody body{modelWith(), {.ball = Ball::kNone}};
  body.place(Pose{});
  lift(body, 5);
  mju_copy3(trunkQvel(body) + 3, Vec{1, 2, 0.5}.data());
  const double before = energyOf(body);
  const int trunk = idOf(body, mjOBJ_BODY, "Body");
  const auto momentum = [&] {
    mj_subtreeVel(body.mujocoModel(), body.mujocoData());
    const mjtNum* at = body.mujocoData()->subtree_angmom + 3 * trunk;
    return Vec{at[0], at[1], at[2]};
  };
  const Vec turning = momentum();
  const double kinetic = body.mujocoData()->energy[1];
  run(body, limp(), 0.3);
  // First order in the step of 1 ms: some per mille, measured 0.4 %.
  EXPECT_NEAR(energyOf(body), before, 0.02 * kinetic);
  const Vec after = momentum();
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(after[k], turning[k], 0.01 * std::hypot(turning[0], turning[1], turning[2]));
}

// The right arm as it hangs, upper and lower arm straight, and what it is as a pendulum about the shoulder.
struct HangingArm {
  explicit HangingArm(const Model& model) : body{model, {.ball = Ball::kNone}} {
    Pose straight{};
    straight[index(Joint::kArmUpperR)] = -0.68;
    hangUp(body, straight);
    mjData& d = *body.mujocoData();
    mj_forward(body.mujocoModel(), &d);
    const int dof = dofOf(body, Joint::kShoulderR), arm = idOf(body, mjOBJ_BODY, "ShoulderR");
    inertia = d.qM[body.mujocoModel()->dof_Madr[dof]];
    const mjtNum* com = d.subtree_com + 3 * arm;
    const mjtNum* anchor = d.xanchor + 3 * idOf(body, mjOBJ_JOINT, "ShoulderR");
    // In the plane across the joint's axis, which is the trunk's left.
    const double forward = com[0] - anchor[0], down = anchor[2] - com[2];
    weight_nm = body.mujocoModel()->body_subtreemass[arm] * kGravity * std::hypot(forward, down);
    rest_rad = -std::atan2(forward, down);
  }
  RobotBody body;
  double inertia = 0, weight_nm = 0, rest_rad = 0;
};

Model oneFreeJoint(Joint free) {
  Model model = modelWith(50);
  model.effects.push_back({findEffect("coulomb"), {0}, free});
  return model;
}

TEST(Arm, SwingsWithThePeriodOfAPendulum) {
  HangingArm arm{oneFreeJoint(Joint::kShoulderR)};
  const int qpos = qposOf(arm.body, Joint::kShoulderR);
  constexpr double kAmplitude = 0.05;  // small: the period is longer by 1.6e-4 of it
  arm.body.mujocoData()->qpos[qpos] = arm.rest_rad + kAmplitude;
  double first = -1, last = -1, before = kAmplitude;
  int turns = 0;
  for (int i = 0; i < 6000; ++i) {
    arm.body.step(kStep, limp());
    const double now = arm.body.mujocoData()->qpos[qpos] - arm.rest_rad;
    if (before > 0 && now <= 0) {
      last = arm.body.time_s();
      if (first < 0)
        first = last;
      else
        ++turns;
    }
    before = now;
  }
  ASSERT_GT(turns, 3);
  const double period = 2 * kPi * std::sqrt(arm.inertia / arm.weight_nm);
  EXPECT_NEAR((last - first) / turns, period, 0.005 * period);  // crossings are known to 1 ms
}

TEST(Arm, WithoutFrictionKeepsItsEnergy) {
  HangingArm arm{oneFreeJoint(Joint::kShoulderR)};
  const int qpos = qposOf(arm.body, Joint::kShoulderR);
  arm.body.mujocoData()->qpos[qpos] = arm.rest_rad + 1.0;
  double highest = 0;
  for (int i = 0; i < 10000; ++i) {
    arm.body.step(kStep, limp());
    if (i > 8000) highest = std::max(highest, arm.body.mujocoData()->qpos[qpos] - arm.rest_rad);
  }
  // The step is symplectic: ten seconds on it still swings as far, within 1 %.
  EXPECT_NEAR(highest, 1.0, 0.01);
}

void expectEqualBits(const BodyState& a, const BodyState& b) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_EQ(a.joint[i].position_rad, b.joint[i].position_rad);
    EXPECT_EQ(a.joint[i].load, b.joint[i].load);
  }
  EXPECT_EQ(a.gyro_rad_s, b.gyro_rad_s);
  EXPECT_EQ(a.accel_m_s2, b.accel_m_s2);
}

Model noisy() {
  Model model = modelWith(0.05);
  model.imu.gyro_noise_rad_s = 0.01;
  return model;
}

TEST(Runs, WithTheSameSeedAreEqualToTheLastBit) {
  RobotBody a{noisy(), {.seed = 7}}, b{noisy(), {.seed = 7}}, other{noisy(), {.seed = 8}};
  for (RobotBody* body : {&a, &b, &other}) {
    run(*body, holding(Pose{}), 1);
    run(*body, limp(), 0.5);
  }
  expectEqualBits(a.state(), b.state());
  EXPECT_EQ(a.trunkPosition(), b.trunkPosition());
  EXPECT_NE(a.state().gyro_rad_s, other.state().gyro_rad_s);
}

TEST(Runs, DoNotDependOnHowTimeIsCut) {
  RobotBody fine{noisy()}, coarse{noisy()}, odd{noisy()};
  run(fine, holding(Pose{}), 0.48);
  for (int i = 0; i < 30; ++i) coarse.step(16 * kStep, holding(Pose{}));
  for (int i = 0; i < 320; ++i) odd.step(Nanos{1'500'000}, holding(Pose{}));
  expectEqualBits(fine.state(), coarse.state());
  expectEqualBits(fine.state(), odd.state());
  EXPECT_DOUBLE_EQ(fine.time_s(), 0.48);
}

RC_GTEST_PROP(Place, PutsTheLowestPointOnTheFloor, ()) {
  static RobotBody body{modelWith(), {.ball = Ball::kNone}};
  Pose angles{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double share = *rc::gen::inRange(0, 1001) / 1000.0;
    const double low = radFromTicks(kJointTable[i].low).value, high = radFromTicks(kJointTable[i].high).value;
    angles[i] = low + share * (high - low);
  }
  body.place(angles, *rc::gen::inRange(-3142, 3142) / 1000.0);
  mj_forward(body.mujocoModel(), body.mujocoData());
  const mjData& d = *body.mujocoData();
  for (int c = 0; c < d.ncon; ++c) RC_ASSERT(d.contact[c].dist > -1e-9);
  // A hair lower, and something touches.
  trunkQpos(body)[2] -= 1e-6;
  mj_forward(body.mujocoModel(), body.mujocoData());
  RC_ASSERT(d.ncon > 0);
}

}  // namespace
}  // namespace darwinop::twin::test
