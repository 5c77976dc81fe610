// Cases of the whole robot: plan, physics, files.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "gap/benchmark/body/body_motions.hpp"
#include "gap/benchmark/body/body_suite.hpp"
#include "gap/benchmark/body/write_body_case.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "gap/plant/body/limb.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

constexpr double kTick = 2 * kPi / 4096;
constexpr double kSame = 2e-4;  // rad: a reading that is a millisecond late is off by more

/// The first rows of one recording of a plan.
BodyCase shortened(const BodyCase& plan, std::size_t log, std::size_t rows) {
  BodyCase out = plan;
  out.logs = {plan.logs[log]};
  out.logs[0].time_s.resize(rows), out.logs[0].repeat_of.reset();
  out.joints.logs.clear();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    Trajectory of = plan.joint(log, joint);
    of.time_s.resize(rows), of.goal_rad.resize(rows), of.torque_on.resize(rows), of.p_register_of_row.resize(rows);
    for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c}) column->resize(rows);
    out.joints.logs.push_back(std::move(of));
  }
  return out;
}

BodyTruth shipped(const BodyCase& plan) {
  return {.model = {.robot = {.robot = {bodyBaselineOf(plan), {}}, .floor = {}}}, .outside = {}, .loose = {}};
}

TEST(BodyPhysics, JointsOfAClampedRobotMoveAsThoseOfTheLimbs) {
  BodyCase made = shortened(plannedBody("a", 1), 0, 40);
  const BodyTruth truth = shipped(made);
  EXPECT_FALSE(measureBody(made, 0, truth, nullptr));
  for (const Limb& limb : limbsOf(made.joints.model)) {
    const LimbTrace trace = rollOut(made, 0, limb, truth.model.robot.robot);
    for (std::size_t k = 0; k < limb.size(); ++k)
      for (std::size_t at = 0; at < 40; ++at)
        EXPECT_NEAR(made.joint(0, static_cast<std::size_t>(limb[k].joint)).position_rad[at],
                    trace.position_rad(static_cast<Eigen::Index>(at), static_cast<Eigen::Index>(k)), kSame)
            << row(limb[k].joint).name << " " << at;
  }
  EXPECT_NEAR(made.logs[0].accel_m_s2[2][20], 9.81, 1e-6);  // upright
}

TEST(BodyPhysics, ARobotOnTheFloorCarriesItsWeightAndShowsItsTilt) {
  BodyCase made = shortened(plannedBody("a", 1), 4, 3), tilted = made;
  BodyTruth truth = shipped(made);
  ASSERT_FALSE(measureBody(made, 0, truth, nullptr));
  truth.model.robot.floor.tilt_rad = {0.04, 0};  // the left side up
  ASSERT_FALSE(measureBody(tilted, 0, truth, nullptr));
  const auto size = [](const BodyCase& of) {
    double square = 0;
    for (const auto& axis : of.logs[0].accel_m_s2) square += axis[2] * axis[2];
    return std::sqrt(square);
  };
  EXPECT_NEAR(size(made), 9.81, 0.02);
  EXPECT_NEAR(std::abs(tilted.logs[0].accel_m_s2[0][2] - made.logs[0].accel_m_s2[0][2]), 9.81 * 0.04, 0.1);
}

TEST(BodyCases, AreReadAsTheyWereWritten) {
  BodyCase made = plannedBody("a", 3);
  for (Trajectory& of : made.joints.logs)
    for (auto* column : {&of.position_rad, &of.load, &of.volt_v, &of.temp_c}) column->assign(of.rows(), 0.1235);
  for (BodyLog& log : made.logs) {
    log.board_v.assign(log.rows(), 11.8);
    for (auto* sensor : {&log.gyro_rad_s, &log.accel_m_s2}) sensor->fill(std::vector<double>(log.rows(), 0.5));
  }
  made.trust = {{"servo", 0.03}};
  const TemporaryFolder folder;
  writeBodyCase(made, folder / "a");
  const BodyCase read = readBodyCase(folder / "a");
  ASSERT_EQ(read.logs.size(), 10U);
  EXPECT_EQ(read.trust, made.trust);
  EXPECT_EQ(read.logs[1].repeat_of, 0U);
  EXPECT_EQ(read.logs[7].held_out, true);
  EXPECT_EQ(read.logs[6].lies_on, made.logs[6].lies_on);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR((*read.logs[7].up)[axis], (*made.logs[7].up)[axis], 1e-9);
  for (std::size_t i = 0; i < made.joints.logs.size(); ++i) {
    ASSERT_EQ(read.joints.logs[i].torque_on, made.joints.logs[i].torque_on);
    for (std::size_t at = 0; at < made.joints.logs[i].rows(); ++at) {
      if (made.joints.logs[i].torque_on[at] == 0) continue;
      ASSERT_NEAR(read.joints.logs[i].goal_rad[at], made.joints.logs[i].goal_rad[at], kTick / 2);
    }
  }
}

TEST(BodyCases, EachSuiteIsThatOfItsSeedUnderNeutralNames) {
  const auto all = bodyRequests(5, BodyPart::kAll), again = bodyRequests(5, BodyPart::kAll);
  std::set<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(names.insert(all[i].name).second);
    EXPECT_EQ(all[i].seed, again[i].seed);
    for (const BodyEffect& effect : all[i].effects) EXPECT_EQ(all[i].name.find(effect.id), std::string::npos);
  }
  EXPECT_GT(all.size(), 100U);
}

TEST(BodyCases, EveryEffectCanBeHidden) {
  const BodyCase plan = plannedBody("a", 1);
  Rng rng{1};
  for (const BodyEffect& effect : bodyEffects()) {
    BodyTruth truth = shipped(plan);
    BodyKey key;
    hide(effect, plan, rng, truth, key);
    ASSERT_EQ(key.effects.size(), 1U) << effect.id;
    EXPECT_EQ(key.effects[0].id, effect.id);
    EXPECT_FALSE(key.effects[0].at.empty()) << effect.id;
  }
}

BodyKeyEffect hidden(const char* effect, std::uint64_t seed, BodyTruth& truth) {
  Rng rng{seed};
  BodyKey key;
  hide(bodyEffectCalled(effect), plannedBody("a", 1), rng, truth, key);
  return key.effects.front();
}

TEST(BodyCases, ARippleHasADrawnCountAndPhase) {
  std::set<double> counts, phases;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    BodyTruth truth = shipped(plannedBody("a", 1));
    const BodyKeyEffect one = hidden("cogging", seed, truth);
    counts.insert(one.values.at("count").front()), phases.insert(one.values.at("phase").front());
  }
  EXPECT_GT(counts.size(), 2U);
  EXPECT_EQ(phases.size(), 8U);
}

TEST(BodyCases, AFrictionOfAllJointsComesOnTopOfEachJointsOwn) {
  BodyTruth truth = shipped(plannedBody("a", 1));
  const BodyKeyEffect all = hidden("coulomb@all", 1, truth);
  EXPECT_FALSE(all.values.contains("friction")) << "hips and ankles have another total";
  const double added = all.values.at("friction_added").front();
  const auto total = [&](Joint joint) {
    return atJoint(truth.model.robot.robot.servos, joint).find("coulomb")->values.front();
  };
  EXPECT_NEAR(total(Joint::kNeck), 0.025 + added, 1e-9);
  EXPECT_NEAR(total(Joint::kAnkleR), 0.25 + added, 1e-9);
}

TEST(BodyCases, AnUnknownEffectIsRefused) {
  EXPECT_THROW((void)bodyRequestsFor(1, {"gyro_bais"}), std::runtime_error);
  EXPECT_THROW((void)bodyRequestsFor(1, {"gyro_bias@pair"}), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::gap
