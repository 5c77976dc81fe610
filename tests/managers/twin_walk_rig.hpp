// A walk in the twin whose controller may compute for long, end, or die. The test also has the link of the robot.
#pragma once

#include <RobotisOp2GaitManager.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <webots/Robot.hpp>

#include "connect/lockstep_robot.hpp"
#include "core/units.hpp"
#include "twin/body/robot_body.hpp"
#include "webots/robot_impl.hpp"

namespace managers {

/// Link of the controller. The loop goes on after it, as in a daemon.
class ControllersLink final : public darwinop::runtime::RobotLink {
 public:
  using Nanos = darwinop::Nanos;
  explicit ControllersLink(std::shared_ptr<darwinop::runtime::RobotLink> loop) : loop_{std::move(loop)} {}
  ~ControllersLink() override {
    last_.end_of_session = true;
    loop_->publish(last_);
  }
  [[nodiscard]] Nanos period() const override { return loop_->period(); }
  [[nodiscard]] Nanos now() const override { return loop_->now(); }
  [[nodiscard]] bool realTime() const override { return false; }
  void publish(darwinop::Commands commands) override { loop_->publish(last_ = commands); }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override {
    return loop_->waitForCycle(cycle, stop);
  }
  [[nodiscard]] darwinop::Sensors sensors() const override { return loop_->sensors(); }
  [[nodiscard]] std::string whyEnded() const override { return loop_->whyEnded(); }

 private:
  std::shared_ptr<darwinop::runtime::RobotLink> loop_;
  darwinop::Commands last_{};
};

/// A controller in the style of upstream's walk, on the twin.
class TwinWalk {
 public:
  static constexpr int kStepMs = 16;
  static constexpr double kStance = 4.3;  // s: 2.7 approach, 1.6 calibration

  TwinWalk() {
    namespace twin = darwinop::twin;
    auto body = std::make_unique<twin::RobotBody>(twin::readModel(twin::findModel("darwin-op")),
                                                  twin::RobotBodyOptions{.ball = twin::Ball::kNone});
    body_ = body.get();
    loop_ = darwinop::connect::lockstepRobot(darwinop::runtime::LoopConfig{}, std::move(body));
    auto impl = std::make_unique<darwinop::webots_api::RobotImpl>(std::make_unique<ControllersLink>(loop_),
                                                                  darwinop::webots_api::ControllerConfig{}, stop_);
    if (const std::string why = impl->begin(); !why.empty()) throw std::runtime_error(why);
    robot_ = std::make_unique<Controller>(impl.release());
    gait_ = std::make_unique<RobotisOp2GaitManager>(robot_.get(), "missing.ini");
  }

  [[nodiscard]] webots::Robot& robot() { return *robot_; }
  [[nodiscard]] RobotisOp2GaitManager& gait() { return *gait_; }
  [[nodiscard]] darwinop::twin::RobotBody& body() { return *body_; }
  /// Cosine of the greatest tilt since the last forgetTilt().
  [[nodiscard]] double lowest() const { return lowest_; }
  void forgetTilt() { lowest_ = 1; }

  void start(double x) {
    gait().setXAmplitude(x);
    gait().start();
  }
  /// Rounds of `round_ms`, of which all beyond step(16) is computing.
  void loop(double seconds, int round_ms = kStepMs, bool steps_gait = true) {
    const auto round = std::chrono::milliseconds{round_ms};
    const ControllersLink::Nanos begun = loop_->now();
    for (auto due = begun + round; due - begun <= std::chrono::duration<double>{seconds}; due += round) {
      if (steps_gait) gait().step(kStepMs);
      if (robot().step(kStepMs) == -1) return;
      note();
      while (loop_->now() + loop_->period() <= due) runLoop(1);
    }
  }
  /// Cycles of the loop without the controller.
  void runLoop(int cycles) {
    const std::atomic<bool> go_on{false};
    for (int i = 0; i < cycles; ++i) {
      (void)loop_->waitForCycle(loop_->sensors().cycle + 1, go_on);
      note();
    }
  }
  /// Ctrl-C, until the controller has ended.
  void end() {
    stop_ = true;
    (void)robot().step(kStepMs);
    note();
    gait_.reset();
    robot_.reset();
    note();
  }
  [[nodiscard]] darwinop::State state() const { return loop_->sensors().safety.state; }

 private:
  struct Controller : webots::Robot {
    explicit Controller(darwinop::webots_api::RobotImpl* impl) : Robot(impl) {}
  };
  void note() { lowest_ = std::min(lowest_, body_->upright()); }

  std::atomic<bool> stop_{false};
  std::shared_ptr<darwinop::runtime::RobotLink> loop_;
  darwinop::twin::RobotBody* body_ = nullptr;
  std::unique_ptr<Controller> robot_;
  std::unique_ptr<RobotisOp2GaitManager> gait_;
  double lowest_ = 1;
};

}  // namespace managers
