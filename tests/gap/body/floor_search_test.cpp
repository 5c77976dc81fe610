// How names of floor, trunk and loaded joints are searched, and which earn their place.
#include "gap/identify/body/floor_search.hpp"

#include <gmock/gmock.h>

#include "gap/body/standing_robot.hpp"
#include "gap/identify/body/floor_selection.hpp"
#include "gap/identify/body/floor_text.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

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

}  // namespace
}  // namespace darwinop::gap
