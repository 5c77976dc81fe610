// Example cases of another simulator, where they are there: effects of floor and trunk, against the answer key. The key
// is read by this test alone.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "gap/identify/body/body_identification.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "support/shared_data.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

fs::path floorExamples() {
  return sharedData("body-gap-cases");
}

BodyCase floorExample(const std::string& name) {
  return readBodyCase((floorExamples() / "cases" / name).string());
}

FloorModel baselineOf(const BodyCase& c) {
  return {.robot = {.robot = {bodyBaselineOf(c), {}}, .floor = {}}};
}

TEST(BodyFloorExamples, TheSimulatedRobotWalksAsARecordedOneWithoutEffectsDoes) {
  if (!fs::exists(floorExamples())) GTEST_SKIP() << "no example cases in " << floorExamples();
  const BodyCase c = floorExample("x13");
  for (std::size_t log = 0; log < c.logs.size(); ++log) {
    if (c.logs[log].setup == BodySetup::kClamped) continue;
    const FloorTrace trace = rollOut(c, log, baselineOf(c).robot);
    double square = 0, count = 0;
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      for (std::size_t row = 0; row < c.logs[log].rows(); ++row) {
        const double error = c.joint(log, joint).position_rad[row] -
                             trace.position_rad(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(joint));
        square += error * error, count += 1;
      }
    EXPECT_LT(1e3 * std::sqrt(square / count), 1.1) << c.logs[log].file;
  }
}

TEST(BodyFloorExamples, EffectsOfTheFloorAreNamedWithTheirNumbers) {
  if (!fs::exists(floorExamples())) GTEST_SKIP() << "no example cases in " << floorExamples();
  struct Expected {
    const char *name, *id;
    std::vector<double> values;
    double within;
  };
  // The centre of mass of x05 is found 1.4 mm off (docs/gap/body.md).
  for (const Expected& one :
       {Expected{"x05", "link_com", {0, 0, -0.018}, 0.002}, Expected{"x06", "floor_friction", {0.25}, 0.05},
        Expected{"x07", "floor_tilt", {0.04, 0}, 0.008}}) {
    const BodyCase c = floorExample(one.name);
    const FloorSelection answer = identifyFloor(c, baselineOf(c), {}, 66);
    ASSERT_THAT(answer.found, testing::SizeIs(1)) << one.name;
    EXPECT_EQ(answer.found.front().placed.effect->id, one.id);
    EXPECT_THAT(answer.found.front().placed.values, testing::Pointwise(testing::DoubleNear(one.within), one.values));
  }
}

}  // namespace
}  // namespace darwinop::gap
