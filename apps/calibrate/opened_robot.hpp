// The robot that is calibrated, with its robot.ini and with what holds its trunk.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/calibrate/stand.hpp"
#include "connect/robot_file.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::calibrate {

struct OpenedRobot {
  std::unique_ptr<runtime::RobotLink> link;
  std::unique_ptr<Stand> stand;
  connect::RobotFile file;  // that corrects what `link` reads; its path is empty without a file
  bool is_twin = false;
};

/// `setting` as --robot. `file`: of robot.ini; empty: the one that programs read. A twin reads the named file only.
/// `unattended`: no person holds the robot, so it has to be simulated. Throws std::runtime_error with what to do.
OpenedRobot openRobot(const std::string& setting, const std::string& file, bool unattended);

/// Before anything is measured. Throws std::runtime_error if `file` cannot be replaced.
void requireReplaceable(const std::string& file);

/// The file that a calibration of this robot is written to; empty: none, because a twin has no robot.ini.
std::string fileToWrite(const OpenedRobot& robot, const std::string& file);

}  // namespace darwinop::calibrate
