#include "connect/start_pose_findings.hpp"

#include <sstream>

#include "core/sensors.hpp"
#include "safety/start_pose.hpp"

namespace darwinop::connect {

cm730::Findings startPoseFindings(const cm730::RobotFacts& facts, const safety::Config& safety) {
  Sensors seen;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!facts.servo[i].readable) continue;
    seen.joint[i].motion.received();
    seen.joint[i].position = facts.servo[i].position;
  }
  if (facts.board.readable) {
    seen.board.motion.received();
    seen.board.accelerometer = facts.board.accelerometer;
  }
  seen.board.absent = facts.board.absent;
  const safety::StartPoseCheck check = safety::checkStartPose(seen, safety::startPose(safety));
  cm730::Findings rows;
  std::istringstream lines{safety::describe(check)};
  for (std::string line; std::getline(lines, line);)
    rows.push_back(check.secure() ? cm730::Finding::ok(line) : cm730::Finding::of(cm730::Kind::kStartPose, line, {}));
  if (!check.secure())
    rows.back().remedy =
        "sit the robot down upright before a controller starts, or hold it while it moves there slowly";
  return rows;
}

}  // namespace darwinop::connect
