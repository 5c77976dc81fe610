// Present pose of a robot, from which a walk or a motion page starts.
#pragma once

#include <string>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "managers/body_player/pose.hpp"
#include "webots/robot_impl.hpp"

namespace managers {

inline darwinop::body_player::Pose presentPose(webots::Robot& robot, const darwinop::webots_api::RobotImpl& inside) {
  return darwinop::body_player::presentPose(
      [&](darwinop::Joint joint) -> const darwinop::JointSensors& { return inside.lastKnown(joint); },
      [&](darwinop::Joint joint) { return robot.getMotor(std::string{row(joint).name})->getTargetPosition(); });
}

}  // namespace managers
