// A twin in memory with its clamp, driven as a robot is.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "apps/calibrate/stand.hpp"
#include "connect/lockstep_robot.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::calibrate {

inline twin::Model shippedModel() {
  return twin::readModel(DARWINOP_MODELS "/darwin-op.ini");
}

struct TwinBench {
  explicit TwinBench(const twin::Model& model, std::uint64_t seed = 1, const connect::Calibration& corrected_by = {},
                     const safety::Config& safety = {}) {
    auto body = std::make_unique<twin::RobotBody>(
        model, twin::RobotBodyOptions{.seed = seed, .ball = twin::Ball::kNone, .ball_colour = {}});
    stand = std::make_unique<TwinClamp>(*body);
    runtime::LoopConfig config;
    config.safety = safety;
    link = connect::lockstepRobot(config, std::move(body), corrected_by);
  }

  std::unique_ptr<TwinClamp> stand;
  std::unique_ptr<runtime::RobotLink> link;
};

}  // namespace darwinop::calibrate
