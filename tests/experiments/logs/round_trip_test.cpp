// A recording of a lockstep run read back equals what the controller received.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "connect/connect.hpp"
#include "core/faults.hpp"
#include "experiments/logs/read_log.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop {
namespace {

TEST(RoundTrip, ARecordedRunEqualsTheValuesOfTheController) {
  const TemporaryFolder folder;
  std::vector<Sensors> seen;
  {
    connect::ConnectRequest request;
    request.setting = "virtual";
    request.robot_name = "Darwin 7";
    request.record_path = folder / "run.csv";
    const auto robot = connect::connect(request);
    const std::atomic<bool> stop{false};
    for (int i = 0; i < 200; ++i) {
      Commands commands;
      commands.start_where_it_is = true;
      commands.joint[index(Joint::kNeck)].setGoal(Rad{0.3});
      robot->publish(commands);
      ASSERT_TRUE(robot->waitForCycle(robot->sensors().cycle + 1, stop));
      seen.push_back(robot->sensors());
    }
  }
  const logs::Log log = logs::readLog(folder / "run.csv");
  EXPECT_TRUE(log.recording);
  EXPECT_TRUE(log.complete);
  EXPECT_TRUE(log.warnings.empty());
  EXPECT_EQ(log.headValue("robot"), "Darwin 7");
  ASSERT_GE(log.rows(), seen.size()) << "rows after the last step: the robot comes to rest";
  const auto& cycle = log.column("cycle").values;
  const auto& position = log.column("Neck.position").values;
  const auto& asked = log.column("Neck.asked").values;
  const auto& state = log.column("safety.state").values;
  std::size_t compared = 0;
  for (const Sensors& sensors : seen) {
    const auto row = static_cast<std::size_t>(static_cast<double>(sensors.cycle) - cycle[0]);
    ASSERT_EQ(cycle[row], static_cast<double>(sensors.cycle));
    // File resolution: microseconds and seven digits of an angle.
    EXPECT_NEAR(log.seconds(row), static_cast<double>(sensors.time_ns) * 1e-9, 1e-6);
    EXPECT_EQ(state[row], static_cast<double>(sensors.safety.state));
    EXPECT_NEAR(asked[row], 0.3, 1e-9);
    const JointSensors& neck = sensors.joint[index(Joint::kNeck)];
    EXPECT_EQ(std::isnan(position[row]), !neck.motion.fresh());
    if (!neck.motion.fresh()) continue;
    EXPECT_NEAR(position[row], neck.position.value, 1e-6);
    ++compared;
  }
  EXPECT_GT(compared, 100u);
}

}  // namespace
}  // namespace darwinop
