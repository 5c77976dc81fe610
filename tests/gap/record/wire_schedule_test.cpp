// When the runtime reads a servo within a cycle, from the bytes of a recording.
#include "gap/case/wire_schedule.hpp"

#include <gtest/gtest.h>

#include "core/packet.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "gap/case/body/row_law.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::gap {
namespace {

TEST(WireSchedule, KnowsTheFramesOfTheBus) {
  EXPECT_EQ(wire::kOfBoard, cm730::kBoardWindow.frameBytes());
  EXPECT_EQ(wire::kOfServo, cm730::kServoWindow.frameBytes());
  EXPECT_EQ(wire::kOfPolled, cm730::kServoPoll.frameBytes());
  EXPECT_DOUBLE_EQ(wire::kByte, std::chrono::duration<double>(cm730::kByteTime).count());
  EXPECT_EQ(wire::kOfRequest + kJoints * wire::kOfRequestEach, kFrameOverhead + 1 + 3 * (kJoints + 1));
}

/// Three rows; the second servo is polled in the last.
std::vector<Trajectory> joints() {
  std::vector<Trajectory> all(kJoints);
  for (Trajectory& joint : all) {
    joint.position_rad.assign(3, 0.1);
    joint.volt_v.assign(3, std::nan(""));
  }
  all[1].volt_v[2] = 12;
  return all;
}

logs::Log recordingWith(const std::string& total_ms) {
  return logs::parseLog("time_s,cycle,bus.wire [ms]\n0,1," + total_ms + "\n0.016,2,5.08\n0.032,3,4.28\n", "robot.csv");
}

TEST(WireSchedule, AServoIsReadAfterTheGoalsTheRequestAndTheRepliesBeforeIt) {
  std::vector<Trajectory> all = joints();
  fillWireSchedule(recordingWith("4.14"), all);  // goals only: 68 bytes; request 70, board 36, twenty times 12
  EXPECT_NEAR(all[0].written_s[0], 0.68e-3, 1e-9);
  EXPECT_NEAR(all[0].read_s[0], (0.68 + 0.70 + 0.36) * 1e-3, 1e-9);
  EXPECT_NEAR(all[19].read_s[0], (0.68 + 0.70 + 0.36 + 19 * 0.12) * 1e-3, 1e-9);
  EXPECT_NEAR(all[0].written_s[1], 1.62e-3, 1e-9) << "settings went along";
  EXPECT_NEAR(all[2].read_s[2] - all[1].read_s[2], 0.26e-3, 1e-9) << "a poll takes longer";
}

TEST(WireSchedule, WithoutAReplyTheFrameOfGoalsIsTakenAsUsual) {
  std::vector<Trajectory> all = joints();
  all[5].position_rad[0] = std::nan("");
  fillWireSchedule(recordingWith("9.9"), all);
  EXPECT_NEAR(all[0].written_s[0], 0.68e-3, 1e-9);
}

TEST(WireSchedule, AJointWithoutAServoIsNotAskedFor) {
  std::vector<Trajectory> all = joints();
  all[19].position_rad.assign(3, std::nan(""));
  fillWireSchedule(recordingWith("4.16"), all);  // goals with settings: 85 bytes; request 67, board 36, 19 times 12
  EXPECT_NEAR(all[0].written_s[0], 0.85e-3, 1e-9);
  EXPECT_NEAR(all[18].read_s[0], (0.85 + 0.67 + 0.36 + 18 * 0.12) * 1e-3, 1e-9);
}

TEST(WireSchedule, ARecordingWithoutBytesIsReadBeforeItsGoalsAreWritten) {
  std::vector<Trajectory> all = joints();
  fillWireSchedule(logs::parseLog("time_s,cycle\n0,1\n0.016,2\n0.032,3\n", "other.csv"), all);
  EXPECT_FALSE(all[0].isReadAfterWrite());
}

TEST(WireSchedule, ALoadIsThatOfTheGoalWhichItsServoHasWhenItIsRead) {
  BodyCase given = BodyTexts{}.read();
  Trajectory& joint = given.joints.logs.front();
  const double before = lawAt(given, joint, 5, joint.goal_rad[4] - 0.01);
  joint.read_s.assign(joint.rows(), 2e-3), joint.written_s.assign(joint.rows(), 1e-3);
  const double after = lawAt(given, joint, 5, joint.goal_rad[5] - 0.01);
  EXPECT_NEAR(before, after, 1e-9);
  EXPECT_NE(joint.goal_rad[4], joint.goal_rad[5]);
}

TEST(WireSchedule, ALoadThatIsReadRightAfterItsGoalCountsLess) {
  BodyCase given = BodyTexts{}.read();
  Trajectory& joint = given.joints.logs.front();
  joint.written_s.assign(joint.rows(), 0.5e-3);
  const auto sigmas = [&](double read_s) {
    joint.read_s.assign(joint.rows(), read_s);
    return jointResiduals(Block::kController, given, joint, bodyBaselineOf(given)).sigma;
  };
  const Eigen::VectorXd soon = sigmas(1.5e-3), late = sigmas(12.5e-3);
  EXPECT_GT(soon[20], 1.5 * late[20]);
}

}  // namespace
}  // namespace darwinop::gap
