// The next recording of a whole robot, by what it would separate.
#include <gmock/gmock.h>

#include <algorithm>

#include "gap/body/standing_robot.hpp"
#include "gap/plan/body/motion_ranking.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

BodyCase emptyCase() {
  BodyCase out;
  out.name = "robot";
  out.joints.model = twin::readModel(twin::findModel("darwin-op"));
  return out;
}

/// Its recordings on the floor are not of the runtime.
BodyCase caseOnFloor() {
  BodyCase out = emptyCase();
  addRecording(out, BodySetup::kFloor, 10, false);
  return out;
}

FloorModel asItIs(const BodyCase& given) {
  return {.robot = {.robot = {bodyBaselineOf(given), {}}, .floor = {}}};
}

/// In these directions; none: every setup that has no direction.
std::vector<PlannedMotion> motionsOf(const std::string& experiment, const std::vector<Axes>& ups = {}) {
  std::vector<PlannedMotion> out;
  std::ranges::copy_if(plannedMotions(), std::back_inserter(out), [&](const PlannedMotion& one) {
    if (one.experiment != experiment) return false;
    return one.up ? std::ranges::count(ups, *one.up) > 0 : ups.empty();
  });
  return out;
}
constexpr Axes kUpright{0, 1, 0}, kHeadDown{0, -1, 0}, kFaceDown{0, 0, -1};

TEST(BodyPlan, AMotionHasTheGoalsOfItsExperimentAndTheTimeOfAPerson) {
  const std::vector<PlannedMotion> motions = motionsOf("body_release", {kFaceDown});
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_GT(motions[0].seconds, 60);
  const BodyCase coming = planned(emptyCase(), motions);
  ASSERT_EQ(coming.logs.size(), 1U);
  EXPECT_EQ(coming.logs[0].up, kFaceDown);
  const Trajectory& shoulder = coming.joint(0, static_cast<std::size_t>(Joint::kShoulderR));
  const Trajectory& knee = coming.joint(0, static_cast<std::size_t>(Joint::kLegLowerR));
  EXPECT_EQ(std::ranges::count(shoulder.torque_on, 0), 62);  // limp for a second
  EXPECT_EQ(std::ranges::count(knee.torque_on, 0), 0);
  EXPECT_GT(std::ranges::max(knee.goal_rad) - std::ranges::min(knee.goal_rad), 0.3);
}

// Upright, a bias along up is a scale; upside down it is not.
TEST(BodyPlan, ABiasAndAScaleOfTheAccelerometerAreSeparatedByAnotherDirection) {
  const BodyCase given = emptyCase();
  BodyQuestion question;
  question.models = {{"accel_bias", asItIs(given)}, {"accel_scale", asItIs(given)}};
  question.models[0].model.imu.accel.bias.z() = 0.49;
  question.models[1].model.imu.accel.scale.z() = 1.05;
  const BodyPlan plan = nextMotions(given, question, motionsOf("body_triangles", {kUpright, kHeadDown}));
  ASSERT_EQ(plan.ranked.size(), 2U);
  EXPECT_EQ(plan.ranked[0].motion.up, kHeadDown);
  EXPECT_EQ(plan.ranked[0].differences[0].largest, "accelerometer.z");
  EXPECT_GT(plan.ranked[0].differences[0].sigma, 5);
  EXPECT_LT(plan.ranked[1].differences[0].sigma, 1);
  EXPECT_THAT(asText(plan, "mine"), HasSubstr("darwinop gap record --add body_triangles --up 0,-1,0 --out mine\n"));
}

// Nothing carries the trunk's weight while it is clamped.
TEST(BodyPlan, ATrunkThatIsTooHeavyShowsOnTheFloorAlone) {
  const BodyCase given = caseOnFloor();
  BodyQuestion question;
  question.models = {{"light", asItIs(given)}, {"heavy", asItIs(given)}};
  question.models[1].model.robot.floor.trunk_mass_kg = 0.3;
  std::vector<PlannedMotion> motions = motionsOf("body_triangles", {kUpright});
  const std::vector<PlannedMotion> on_floor = motionsOf("body_stand");
  motions.insert(motions.end(), on_floor.begin(), on_floor.end());
  const BodyPlan plan = nextMotions(given, question, motions);
  ASSERT_EQ(plan.ranked.size(), 2U);
  EXPECT_EQ(plan.ranked[0].motion.experiment, "body_stand");
  EXPECT_GT(plan.ranked[0].differences[0].sigma, 3);
  EXPECT_EQ(plan.ranked[1].differences[0].sigma, 0);
  EXPECT_EQ(asJson(plan, "mine")["experiments"][0]["entry"]["setup"], "floor");
}

// floorLogs() leaves them out.
TEST(BodyPlan, OnTheFloorNothingIsPlannedThatTheRuntimeWouldRecord) {
  const BodyCase given = emptyCase();
  BodyQuestion question;
  question.models = {{"light", asItIs(given)}, {"heavy", asItIs(given)}};
  question.models[1].model.robot.floor.trunk_mass_kg = 0.3;
  const BodyPlan plan = nextMotions(given, question, {motionsOf("body_stand").front(), motionsOf("body_lie").front()});
  EXPECT_TRUE(plan.ranked.empty());
  EXPECT_THAT(asText(plan, "mine"), HasSubstr(std::string{messages::kFloorNotPlanned} + "body_stand"));
}

// Standing, a tilted floor and a shifted centre of mass are alike; lying they are not: docs/gap/body.md.
TEST(BodyPlan, ATiltOfTheFloorAndAShiftedTrunkAreSeparatedByLying) {
  const BodyCase given = caseOnFloor();
  BodyQuestion question;
  question.models = {{"tilt", asItIs(given)}, {"shift", asItIs(given)}};
  question.models[0].model.robot.floor.tilt_rad = {0, 0.04};
  question.models[1].model.robot.floor.trunk_com_shift_m.z() = 0.02;
  const BodyPlan plan = nextMotions(given, question, {motionsOf("body_lie").front()});
  ASSERT_EQ(plan.ranked.size(), 1U);
  EXPECT_GT(plan.ranked[0].differences[0].sigma, 5);
}

TEST(BodyPlan, RivalsOfAnAmbiguityAreWhatIsSeparated) {
  const BodyCase given = emptyCase();
  const std::vector<FloorEffect> effects = floorEffects(given.joints.model);
  const auto placed = [&](std::string_view id) {
    const auto found = std::ranges::find(effects, id, &FloorEffect::id);
    return PlacedFloor{&*found, found->starts.front()};
  };
  BodyIdentification found;
  found.verdict = Verdict::kAmbiguous;
  found.floor.found = {{.placed = placed("floor_tilt"), .sigmas = {}, .rivals = {placed("link_com")}}};
  const BodyQuestion question = questionAfter(given, found);
  EXPECT_TRUE(question.is_rivalry);
  ASSERT_EQ(question.models.size(), 2U);
  EXPECT_THAT(question.models[0].name, StartsWith("floor_tilt"));
  EXPECT_THAT(question.models[1].name, StartsWith("link_com"));
  EXPECT_GT(question.models[0].model.robot.floor.tilt_rad[0], 0);
  EXPECT_EQ(question.models[1].model.robot.floor.tilt_rad[0], 0);
  found.verdict = Verdict::kCannotTell, found.floor.found.clear();
  EXPECT_FALSE(questionAfter(given, found).is_rivalry);
}

}  // namespace
}  // namespace darwinop::gap
