// Twins with hidden zero offsets: they are found by the load under gravity.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "apps/calibrate/joints/joint_procedure.hpp"
#include "apps/calibrate/joints/offset_fit.hpp"
#include "apps/calibrate/twin_bench.hpp"
#include "core/random.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::calibrate {
namespace {

const std::atomic<bool> kRunning{false};

/// Up to 3 deg in every joint.
JointValues hiddenBy(std::uint64_t seed) {
  Rng random{seed};
  JointValues out{};
  for (double& offset : out) offset = random.between(-3, 3) * kRadPerDegree;
  return out;
}

twin::Model modelOf(const JointValues& offsets) {
  twin::Model model = shippedModel();
  for (std::size_t i = 0; i < kJoints; ++i)
    model.effects.push_back({twin::findEffect("encoder_offset"), {offsets[i]}, static_cast<Joint>(i)});
  return model;
}

safety::Config heldRobot() {
  safety::Config config;
  config.start = safety::StartMove::kHold;
  config.on_exit = safety::OnExit::kLimp;
  return config;
}

struct HiddenOffsets : testing::TestWithParam<std::uint64_t> {};

TEST_P(HiddenOffsets, AreFoundWithinAFifthOfADegree) {
  const JointValues truth = hiddenBy(GetParam());
  TwinBench bench{modelOf(truth), GetParam(), {}, heldRobot()};
  std::ostringstream log;
  const auto points = sweepJoints(std::move(bench.link), *bench.stand, {}, kRunning, log);
  GravityModel gravity{shippedModel()};
  const std::vector<JointOffset> found = fitOffsets(points, gravity);
  ASSERT_EQ(found.size(), kJoints);
  for (const JointOffset& one : found) {
    const double error_deg = (one.offset_rad - truth[index(one.joint)]) / kRadPerDegree;
    std::printf("%-10s %6.2f error %6.3f sd %5.3f\n", std::string{row(one.joint).name}.c_str(),
                truth[index(one.joint)] / kRadPerDegree, error_deg, one.sigma_rad / kRadPerDegree);
    EXPECT_TRUE(one.observed) << row(one.joint).name;
    EXPECT_LT(std::abs(error_deg), 0.2) << row(one.joint).name;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, HiddenOffsets, DARWINOP_SEEDS);

}  // namespace
}  // namespace darwinop::calibrate
