// How names of floor, trunk and loaded joints are searched, and which earn their place.
#include "gap/identify/body/floor_search.hpp"

#include <gmock/gmock.h>

#include "gap/body/standing_robot.hpp"
#include "gap/identify/body/floor_selection.hpp"
#include "gap/identify/body/floor_start.hpp"
#include "gap/identify/body/floor_text.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const FloorEffect& effectCalled(const std::vector<FloorEffect>& all, std::string_view id, std::string_view at) {
  return *std::ranges::find_if(all, [&](const FloorEffect& one) { return one.id == id && one.at == at; });
}

FloorSelection selectionFor(const FloorModel& hidden) {
  return identifyFloor(standingRobot(hidden), shippedOnFloor(), {}, 0);
}

TEST(FloorSearch, NoModelIsSimulatedTwiceWhereOldTracesAreForgotten) {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  addRecording(given, BodySetup::kLying, 2, false);
  for (Trajectory& joint : given.joints.logs) joint.position_rad = joint.goal_rad;
  for (auto* sensor : {&given.logs[0].gyro_rad_s, &given.logs[0].accel_m_s2})
    sensor->fill({std::nan(""), std::nan("")});
  const MovingImu imu{given.joints.model};
  const FloorResiduals residuals{given, {0}, imu, shippedOnFloor()};
  FloorEvaluator evaluator{residuals, shippedOnFloor()};
  const std::vector<FloorEffect> effects = floorEffects(given.joints.model);
  const FloorEffect& friction = *std::ranges::find(effects, "floor_friction", &FloorEffect::id);
  constexpr std::size_t kMoreThanAreKept = 50;
  for (std::size_t i = 0; i < kMoreThanAreKept; ++i)
    (void)evaluator.residuals({{{&friction, {0.2 + 0.01 * static_cast<double>(i)}}}});
  EXPECT_EQ(evaluator.simulations(), kMoreThanAreKept);
}

// The place of a mass that is not there.
TEST(FloorSearch, ANumberWithoutInfluenceIsAsUncertainAsItsPrior) {
  FloorModel heavy = shippedOnFloor();
  heavy.robot.floor.trunk_com_shift_m = {0, 0, 0.01};
  const BodyCase given = standingRobot(heavy);
  const MovingImu imu{given.joints.model};
  const FloorResiduals residuals{given, {0, 1}, imu, shippedOnFloor()};
  FloorEvaluator evaluator{residuals, shippedOnFloor()};
  const std::vector<FloorEffect> effects = floorEffects(given.joints.model);
  const FloorEffect& mass = effectCalled(effects, "link_mass", "Body");
  const FloorFit fit = fitFloor(evaluator, {{&mass, {0, 0, 0, 0}}}, 1);
  for (const std::size_t of_place : {1, 2, 3})
    EXPECT_NEAR(fit.sigmas.front().at(of_place), mass.numbers.at(of_place).prior_sigma, 1e-6);
}

// A robot that leans is not linear in the floor that slopes; one that lies still is. Both together suggest 0.093.
TEST(FloorSearch, AFitBeginsWhereOneLogByItselfIsExplained) {
  FloorModel sloped = shippedOnFloor();
  sloped.robot.floor.tilt_rad = {0.08, -0.1};
  const BodyCase given = standingRobot(sloped);
  const MovingImu imu{given.joints.model};
  const FloorResiduals residuals{given, {0, 1}, imu, shippedOnFloor()};
  FloorEvaluator evaluator{residuals, shippedOnFloor()};
  const std::vector<FloorEffect> effects = floorEffects(given.joints.model);
  const FloorStart start = bestStart(evaluator, {}, effectCalled(effects, "floor_tilt", "floor"));
  EXPECT_THAT(start.set.back().values, testing::Pointwise(testing::DoubleNear(0.003), {0.08, -0.1}));
}

TEST(FloorSearch, AMassIsVariedAsAWholeAndWithoutItsPlace) {
  const std::vector<FloorEffect> effects = floorEffects(twin::readModel(twin::findModel("darwin-op")));
  const FloorEffect &mass = effectCalled(effects, "link_mass", "Body"),
                    &tilt = effectCalled(effects, "floor_tilt", "floor");
  const std::vector<FloorSet> of_mass = variationsOf({{&mass, {0.2, 0, 0, 0.04}}});
  EXPECT_THAT(of_mass, SizeIs(8)) << "each is a simulation of every log";
  for (const FloorSet& set : of_mass) EXPECT_NE(set.back().values[0], 0);
  EXPECT_THAT(variationsOf({{&tilt, {0.04, -0.01}}}), SizeIs(4));
}

TEST(FloorSearch, ANumberIsAsUncertainAsEquallyGoodFitsDiffer) {
  const std::vector<FloorEffect> effects = floorEffects(twin::readModel(twin::findModel("darwin-op")));
  const FloorEffect& tilt = effectCalled(effects, "floor_tilt", "floor");
  const auto fitAt = [&](double x, double y, double cost) {
    return FloorFit{.set = {{&tilt, {x, y}}}, .sigmas = {{0.001, 0.002}}, .cost = cost};
  };
  FloorFit best = fitAt(0.04, 0.01, 3870);
  widenByEqualFits(best, {best, fitAt(0.05, 0.011, 4100), fitAt(0.09, 0.09, 4400)});
  EXPECT_THAT(best.sigmas.front(), testing::Pointwise(testing::DoubleNear(1e-9), {0.01, 0.002}));
  EXPECT_EQ(best.cost, 3870);
}

TEST(FloorSearch, AContactTimeGainsNoMoreThanItsDeviationAmongEnginesCosts) {
  const std::vector<FloorEffect> effects = floorEffects(twin::readModel(twin::findModel("darwin-op")));
  const FloorEffect &time = effectCalled(effects, "contact_time", "floor"),
                    &soles = effectCalled(effects, "sole_size", "floor");
  const auto costOf = [](const FloorEffect& effect, double value) {
    return PlacedFloor{&effect, {value}}.costAmongEngines();
  };
  EXPECT_NEAR(costOf(time, 0.008 * 1.3), 1, 1e-9);
  EXPECT_NEAR(costOf(time, 0.008 / 1.3), 1, 1e-9);
  EXPECT_GT(costOf(time, 0.031), 22) << "the price of a name, and what chance exceeds in 1 %";
  EXPECT_LT(costOf(time, 0.02), 22);
  EXPECT_TRUE(std::isinf(costOf(soles, 0.5)));
}

TEST(FloorSearch, AnEncoderOfAnAnkleIsNotNamedAsAFloorThatSlopes) {
  for (const std::vector<std::string>& joints : {std::vector<std::string>{"AnkleR"}, {"FootR", "FootL"}}) {
    FloorModel hidden = shippedOnFloor();
    for (const std::string& joint : joints)
      hidden.robot.robot.servos.with(*twin::findEffect("encoder_offset"), {.kind = Place::Kind::kJoint, .name = joint})
          .values = {0.03};
    const FloorSelection answer = selectionFor(hidden);
    ASSERT_THAT(answer.found, SizeIs(1)) << joints.front();
    const nlohmann::ordered_json json = effectJson(answer.found.front());
    EXPECT_EQ(json["id"], "encoder_offset");
    EXPECT_EQ(json["at"], joints.size() == 1 ? nlohmann::ordered_json(joints.front()) : nlohmann::ordered_json(joints));
    EXPECT_NEAR(json["params"]["offset"].get<double>(), 0.03, 0.004);
  }
}

TEST(FloorSearch, AnEffectThatLeavesTooMuchForANameIsReportedAsNearest) {
  FloorModel sloped = shippedOnFloor();
  sloped.robot.floor.tilt_rad = {0.03, -0.01};
  BodyCase given = standingRobot(sloped);
  Rng rng{7};
  for (Trajectory& log : given.joints.logs)  // what no effect of the floor does
    if (log.joint == Joint::kShoulderR)
      for (double& position : log.position_rad) position += 0.1 * rng.normal();
  const FloorSelection answer = identifyFloor(given, shippedOnFloor(), {}, 0);
  EXPECT_THAT(answer.found, IsEmpty());
  ASSERT_THAT(answer.tried, SizeIs(1));
  EXPECT_EQ(answer.tried.front().effect->id, "floor_tilt");
  EXPECT_THAT(asText(answer), testing::HasSubstr(std::string{kNotNamed} + "floor_tilt at floor, tilt 0.03"));
}

TEST(FloorSearch, ANameThatAHeldOutLogContradictsDoesNotEndTheSearch) {
  FloorModel sloped = shippedOnFloor();
  sloped.robot.floor.tilt_rad = {0.03, -0.01};
  BodyCase given = standingRobot(sloped);
  const BodyCase level = standingRobot(shippedOnFloor());
  given.logs[2] = level.logs[2];  // held out
  std::copy_n(level.joints.logs.begin() + 2 * kJoints, kJoints, given.joints.logs.begin() + 2 * kJoints);
  const FloorSelection answer = identifyFloor(given, shippedOnFloor(), {}, 0);
  EXPECT_THAT(answer.found, IsEmpty());
  EXPECT_GT(answer.tried.size(), 1u);
}

}  // namespace
}  // namespace darwinop::gap
