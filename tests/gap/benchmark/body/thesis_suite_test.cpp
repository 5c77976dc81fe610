// Findings of 2013 that need the whole robot: what is hidden, and that the workflow names the mirrored accelerometer.
#include "gap/benchmark/body/thesis_suite.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "gap/benchmark/body/body_physics.hpp"
#include "gap/benchmark/body/given_effects.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;

const BodyRequest& requestOf(const std::vector<BodyRequest>& all, const std::string& name) {
  return *std::ranges::find(all, name, &BodyRequest::name);
}

/// The recordings with a clamped trunk, their first half second.
BodyCase clamped(const BodyCase& plan) {
  constexpr std::size_t kRows = 32;
  BodyCase out = plan;
  out.logs.clear(), out.joints.logs.clear();
  for (std::size_t log = 0; log < plan.logs.size(); ++log) {
    if (plan.logs[log].setup != BodySetup::kClamped) continue;
    out.logs.push_back(plan.logs[log]);
    out.logs.back().time_s.resize(kRows), out.logs.back().repeat_of.reset();
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      Trajectory of = plan.joint(log, joint);
      of.time_s.resize(kRows), of.goal_rad.resize(kRows), of.torque_on.resize(kRows);
      of.p_register_of_row.resize(kRows);
      for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c}) column->resize(kRows);
      out.joints.logs.push_back(std::move(of));
    }
  }
  return out;
}

// T5, 5.2: x and z mirrored.
TEST(ThesisSuite, TheMirroredAccelerometerIsNamedWithItsAxes) {
  const BodyRequest request = requestOf(thesisRequests(1), "t5");
  BodyCase made = clamped(plannedBody(request.name, request.seed));
  BodyTruth truth{.model = {.robot = {.robot = {bodyBaselineOf(made), {}}, .floor = {}}}, .outside = {}, .loose = {}};
  BodyKey key;
  for (const BodyKeyEffect& effect : request.given) hide(effect, made, truth, key);
  for (std::size_t log = 0; log < made.logs.size(); ++log) {
    const Disturbance noise{.seed = 1 + log};
    (void)measureBody(made, log, truth, &noise);
  }
  const BodyIdentification found = identify(made, BodyScope::kSensors);
  EXPECT_EQ(found.verdict, Verdict::kNamed);
  const auto of = std::ranges::find(found.sensors, ImuSensor::kAccelerometer, &SensorSelection::sensor);
  ASSERT_NE(of, found.sensors.end());
  ASSERT_EQ(of->found.effects.size(), 1U);
  EXPECT_EQ(of->found.effects[0]->id, "accel_axes");
  EXPECT_THAT(of->found.map, ElementsAre(-1, 2, -3));
}

// T6, 5.2.1: a trunk too low and too far back and soles too large stood up for each other.
TEST(ThesisSuite, TheBowTestHidesTwoErrorsAndFallsEachWay) {
  const BodyRequest request = requestOf(thesisRequests(1), "t6");
  ASSERT_EQ(request.given.size(), 2U);
  EXPECT_EQ(request.given[0].id, "link_com");
  EXPECT_EQ(request.given[1].id, "sole_size");
  BodyCase made = plannedBody(request.name, request.seed, request.on_floor);
  BodyTruth truth{.model = {.robot = {.robot = {bodyBaselineOf(made), {}}, .floor = {}}}, .outside = {}, .loose = {}};
  BodyKey key;
  for (const BodyKeyEffect& effect : request.given) hide(effect, made, truth, key);
  EXPECT_NEAR(truth.model.robot.floor.trunk_com_shift_m.z(), 0.0151, 1e-9);
  EXPECT_EQ(truth.model.robot.floor.sole_scale, 0.8);
  for (std::size_t log = 0; log < made.logs.size(); ++log) {
    const bool is_bow = made.logs[log].setup == BodySetup::kFloor && made.logs[log].held_out;
    if (!is_bow) continue;
    EXPECT_TRUE(measureBody(made, log, truth, nullptr)) << log;
  }
}

TEST(ThesisSuite, EveryCauseOfTheWalkIsHiddenAlone) {
  std::size_t causes = 0;
  for (const BodyRequest& request : thesisRequests(1)) {
    if (!request.name.starts_with("t9") || request.given.empty()) continue;
    ++causes;
    ASSERT_EQ(request.given.size(), 1U);
    const BodyCase plan = plannedBody(request.name, request.seed);
    BodyTruth truth{.model = {.robot = {.robot = {bodyBaselineOf(plan), {}}, .floor = {}}}, .outside = {}, .loose = {}};
    BodyKey key;
    hide(request.given[0], plan, truth, key);
    ASSERT_EQ(key.effects.size(), 1U);
    EXPECT_EQ(key.effects[0].at, request.given[0].at);
  }
  EXPECT_EQ(causes, 12U);
}

}  // namespace
}  // namespace darwinop::gap
