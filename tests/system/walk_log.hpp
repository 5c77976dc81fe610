// How a walk ended, in the robot's recording: goals before the kneel, their greatest change, and when the kneel began.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/faults.hpp"
#include "core/joints.hpp"
#include "managers/gait/goals.hpp"
#include "system/recording.hpp"

namespace darwinop {

class WalkLog {
 public:
  explicit WalkLog(const std::string& file) : log_{file} {
    for (std::size_t row = 0; row < log_.rows(); ++row)
      if (isIn(State::kDriven, row)) {
        if (!first_) first_ = row;
        last_ = row;
      }
    if (!first_) throw std::runtime_error("no controller drove the robot of " + file);
    stood_since_ = last_;
    while (stood_since_ > *first_ && stands(stood_since_ - 1)) --stood_since_;
  }

  /// Of the first and the last row in which the controller drove.
  [[nodiscard]] double firstCycle() const { return cycle(*first_); }
  [[nodiscard]] double lastCycle() const { return cycle(last_); }
  [[nodiscard]] bool kneelsThen() const { return last_ + 1 < log_.rows() && isIn(State::kKneeling, last_ + 1); }
  /// Cycles in the stance before that; 0: not in the stance.
  [[nodiscard]] double stood() const { return stands(last_) ? cycle(last_) - cycle(stood_since_) + 1 : 0; }

  /// Goals of the controller, or those that were sent to the servos, after safety.
  enum class Goals { kAsked, kCommanded };
  /// Greatest change of a goal from row to row, rad, after cycle `from` and up to cycle `to`.
  [[nodiscard]] double greatestChange(Goals goals, double from, double to = INFINITY) const {
    double change = 0;
    for (std::size_t row = 1; row < log_.rows(); ++row)
      if (cycle(row) > from && cycle(row) <= to)
        for (std::size_t i = 0; i < gait::kWalkingJoints; ++i) {
          const double moved = std::abs(goal(goals, row, i) - goal(goals, row - 1, i));
          if (moved > change) change = moved;  // NaN without a goal
        }
    return change;
  }
  [[nodiscard]] bool hasFault(Fault fault) const {
    for (std::size_t row = 0; row < log_.rows(); ++row)
      if (log_.at(row, "safety.fault") == static_cast<double>(fault)) return true;
    return false;
  }
  /// Of the trunk against the vertical in the last row, rad.
  [[nodiscard]] double lastTilt() const {
    const std::size_t row = log_.rows() - 1;
    const auto accel = [&](const char* axis) { return log_.at(row, std::string{"accelerometer."} + axis + " [m/s2]"); };
    return std::atan2(std::hypot(accel("x"), accel("y")), accel("z"));
  }

 private:
  [[nodiscard]] bool isIn(State state, std::size_t row) const {
    return log_.at(row, "safety.state") == static_cast<double>(state);
  }
  [[nodiscard]] double cycle(std::size_t row) const { return log_.at(row, "cycle"); }
  [[nodiscard]] double goal(Goals goals, std::size_t row, std::size_t joint) const {
    const char* const column = goals == Goals::kAsked ? ".asked [rad]" : ".commanded [rad]";
    return log_.at(row, std::string{kJointTable[joint].name} + column);
  }
  [[nodiscard]] bool stands(std::size_t row) const {
    constexpr double kHalfATick = 0.0008;  // rad
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      if (!(std::abs(goal(Goals::kCommanded, row, i) - gait::kStanding.rad(i)) < kHalfATick)) return false;
    return true;
  }

  Recording log_;
  std::optional<std::size_t> first_;
  std::size_t last_ = 0, stood_since_ = 0;
};

}  // namespace darwinop
