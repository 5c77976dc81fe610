// Zero offsets of joints by gravity.
#include <iostream>
#include <stdexcept>

#include "apps/calibrate/joints/joint_procedure.hpp"
#include "apps/calibrate/joints/messages.hpp"
#include "apps/calibrate/joints/offset_fit.hpp"
#include "apps/calibrate/joints/offset_text.hpp"
#include "apps/calibrate/opened_robot.hpp"
#include "calibrate_commands.hpp"
#include "hal/signals.hpp"

namespace darwinop::calibrate {

int calibrateJoints(const CalibrateOptions& given) {
  GravityModel gravity{twin::readModel(twin::findModel(given.model))};
  OpenedRobot robot = openToWrite(given, given.yes);
  if (!robot.is_twin)
    std::cout << "Arms, legs and head swing slowly, by up to " << greatestSweepDeg() << " deg to each side, for "
              << sweepMinutes()
              << " minutes in each of three postures.\nClamp the trunk in a stand, so that no limb touches anything or "
                 "anybody. Keep hands away from the joints. Ctrl-C makes them limp.\nHold the limbs while a posture "
                 "ends: they fall then.\n";
  const std::vector<GravityPoint> points =
      sweepJoints(std::move(robot.link), *robot.stand, robot.file.safety.absent, endRequested(), std::cout);
  if (endRequested()) return kExitNothing;
  if (points.empty()) {
    std::cerr << "darwinop calibrate: " << messages::kNothingSwept << '\n';
    return kExitNothing;
  }
  const std::vector<JointOffset> found = fitOffsets(points, gravity);
  std::cout << asText(found, robot.file.offsets);
  return keep(given, fileToWrite(robot, given.file), "Offsets",
              iniValues(found, robot.file.offsets, timeText("%Y-%m-%d")));
}

}  // namespace darwinop::calibrate
