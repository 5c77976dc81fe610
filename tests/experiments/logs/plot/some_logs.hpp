// Small logs for tests.
#pragma once

#include <string>

#include "experiments/logs/read_log.hpp"

namespace darwinop::plot {

/// Three rows, one second apart: the neck moves and is silent in the last row, the head rests.
inline logs::Log twoJoints(const std::string& file, int start = 0, const std::string& model = "virtual") {
  const auto time = [&](int row) { return std::to_string(start + row); };
  return logs::parseLog(
      "# robot: Darwin 7\n# model: " + model +
          "\ntime_s,gyro.x [rad/s],gyro.y [rad/s],gyro.z [rad/s],Neck.asked [rad],Neck.position [rad],Neck.load,"
          "Head.asked [rad],Head.position [rad],Head.load\n" +
          time(0) + ",0.1,0,0,1,0,0.25,0,0,0.5\n" + time(1) + ",0.2,1,0,1,0.5,0.125,0,0.002,0.5\n" + time(2) +
          ",0.3,2,0,1,,,0,,\n",
      file);
}

}  // namespace darwinop::plot
