// Parts of darwinop-calibrate.
#pragma once

#include <string>
#include <vector>

#include "apps/calibrate/ini_edit.hpp"
#include "apps/calibrate/opened_robot.hpp"

namespace darwinop::calibrate {

struct CalibrateOptions {
  std::string robot, file, model = "darwin-op";
  std::vector<std::string> joints;
  double seconds = 5, level_deg = 0.5;
  bool yes = false, dry_run = false;
};

inline constexpr int kExitDone = 0, kExitNothing = 1, kExitWrong = 2;

/// Of now, as strftime().
std::string timeText(const char* format);

/// openRobot(); throws std::runtime_error also if the result could not be written.
OpenedRobot openToWrite(const CalibrateOptions& given, bool unattended);

/// Asks first, and shows where the old file is.
int keep(const CalibrateOptions& given, const std::string& file, const std::string& section,
         const std::vector<IniValue>& values);

/// Zero offsets; on a PC only, where the masses of the links are.
int calibrateJoints(const CalibrateOptions& given);

}  // namespace darwinop::calibrate
