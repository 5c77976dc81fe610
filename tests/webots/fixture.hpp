// A controller's robot on top of the fake link.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>
#include <webots/Robot.hpp>

#include "fake_link.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::webots_api {

/// As controllers do it: a class that derives from webots::Robot.
class TestRobot : public webots::Robot {
 public:
  explicit TestRobot(RobotImpl* impl) : Robot(impl) {}
};

/// Fingers of a test.
class FakeKeys : public KeySource {
 public:
  explicit FakeKeys(const std::vector<Key>& held) : held_{held} {}
  std::vector<Key> take() override { return held_; }

 private:
  const std::vector<Key>& held_;
};

class Facade : public testing::Test {
 protected:
  Facade() { forgetWarnings(); }

  /// The robot, made at first use, so that a test may prepare `fake` and `config` before.
  webots::Robot& robot() {
    if (!robot_) {
      robot_ = std::make_unique<TestRobot>(makeImpl());
    }
    return *robot_;
  }

  /// For a robot class of the test's own, which then owns it.
  RobotImpl* makeImpl() {
    auto impl = std::make_unique<RobotImpl>(std::make_unique<FakeLink>(fake), config, stop);
    impl->open_keys = [this] {
      if (!why_no_keys.empty()) throw std::runtime_error(why_no_keys);
      ++keys_opened;
      return std::make_unique<FakeKeys>(held);
    };
    why_not = impl->begin();
    return impl.release();
  }

  /// Ends this robot; robot() makes another one.
  void end() { robot_.reset(); }

  /// One step, and the command published for this joint.
  JointCommand commanded(Joint joint) {
    EXPECT_EQ(robot().step(16), 0);
    return fake.last().joint[index(joint)];
  }

  FakeRobot fake;
  ControllerConfig config;
  std::atomic<bool> stop{false};
  std::string why_not;
  std::vector<Key> held;    // keys
  std::string why_no_keys;  // what opening them ends with
  int keys_opened = 0;

 private:
  std::unique_ptr<TestRobot> robot_;
};

}  // namespace darwinop::webots_api
