// A controller's robot on top of the fake link.
#pragma once

#include <gtest/gtest.h>

#include <webots/Robot.hpp>

#include "fake_link.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::facade {

/// As controllers do it: a class that derives from webots::Robot.
class TestRobot : public webots::Robot {
 public:
  explicit TestRobot(RobotImpl* impl) : Robot(impl) {}
};

class Facade : public testing::Test {
 protected:
  Facade() { forgetWarnings(); }

  /// The robot, made at first use, so that a test may prepare `fake` and `config` before.
  webots::Robot& robot() {
    if (!robot_) {
      auto impl = std::make_unique<RobotImpl>(std::make_unique<FakeLink>(fake), config, stop);
      why_not = impl->begin();
      robot_ = std::make_unique<TestRobot>(impl.release());
    }
    return *robot_;
  }

  /// Ends this robot; robot() makes another one.
  void end() { robot_.reset(); }

  /// One step, and what the robot was told about this joint.
  JointCommand told(Joint joint) {
    EXPECT_EQ(robot().step(16), 0);
    return fake.last().joint[index(joint)];
  }

  FakeRobot fake;
  ControllerConfig config;
  std::atomic<bool> stop{false};
  std::string why_not;

 private:
  std::unique_ptr<TestRobot> robot_;
};

}  // namespace darwinop::facade
