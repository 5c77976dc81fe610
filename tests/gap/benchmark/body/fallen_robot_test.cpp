// A robot that nothing keeps on its feet.
#include <gmock/gmock.h>

#include <cmath>

#include "gap/benchmark/body/body_suite.hpp"

namespace darwinop::gap {
namespace {

TEST(FallenRobot, IsRecordedNevertheless) {
  const HiddenBody made = hiddenBody(
      {.name = "falls", .given = {{.id = "sole_size", .at = {"floor"}, .values = {{"scale", {0.5}}}}}, .tries = 1});
  ASSERT_LT(std::abs(made.given.logs[9].accel_m_s2[2].back()), 5) << "it lies in the end";
  EXPECT_LT(made.key.noise_mrad, 2) << "two falls have nothing in common";
  EXPECT_THAT(made.given.joint(9, 0).position_rad,
              testing::Each(testing::Truly([](double rad) { return rad == rad; })));
}

}  // namespace
}  // namespace darwinop::gap
