// Runs an experiment on a robot in this process, in simulated time, and records every cycle.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "connect/connect.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/run/runner.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::experiments {

class VirtualRun {
 public:
  /// Commands and sensor values, one entry per step.
  struct Row {
    std::string phase;
    Commands asked;
    Sensors seen;
  };

  /// `robot`: "virtual", "twin" or "twin:MODEL".
  explicit VirtualRun(Experiment experiment, const std::string& robot = "virtual")
      : experiment_{std::move(experiment)} {
    connect::ConnectRequest request;
    request.setting = robot;
    auto spy = std::make_unique<Spy>(connect::connect(request), *this);
    auto impl = std::make_unique<webots_api::RobotImpl>(std::move(spy), webots_api::ControllerConfig{}, api_stop_);
    EXPECT_EQ(impl->begin(), "");
    robot_ = std::make_unique<OwnRobot>(impl.release());
  }

  RunOutcome run() {
    const auto forward = [this](const std::string& phase, double seconds) {
      phase_ = phase;
      if (on_step) on_step(phase, seconds);
    };
    return Runner{*robot_, experiment_, stop, forward}.run();
  }

  /// Like a second Ctrl-C, or a lost robot.
  void end() { api_stop_ = true; }
  [[nodiscard]] webots::Motor& motor(const std::string& name) { return *robot_->getMotor(name); }
  [[nodiscard]] double position(Joint joint) const { return rows.back().seen.joint[index(joint)].position.value; }
  [[nodiscard]] const auto& limitHits() const { return rows.back().seen.safety.limit_hits; }
  [[nodiscard]] static double secondsOf(const std::vector<Row>& some) {
    return static_cast<double>(some.size()) * 0.016;
  }
  /// The rows of phases with this name in all rounds.
  [[nodiscard]] std::vector<Row> rowsOf(const std::string& phase) const {
    std::vector<Row> found;
    for (const Row& row : rows)
      if (row.phase.ends_with(phase)) found.push_back(row);
    return found;
  }

  std::atomic<bool> stop{false};
  std::function<void(const std::string&, double)> on_step;
  std::function<void(Sensors&)> bend;  // modifies what the experiment receives
  std::vector<Row> rows;

 private:
  class OwnRobot : public webots::Robot {
   public:
    explicit OwnRobot(webots_api::RobotImpl* impl) : Robot(impl) {}
  };

  /// Forwards and records everything.
  class Spy final : public runtime::RobotLink {
   public:
    Spy(std::unique_ptr<RobotLink> link, VirtualRun& run) : link_{std::move(link)}, run_{run} {}
    [[nodiscard]] Nanos period() const override { return link_->period(); }
    [[nodiscard]] Nanos now() const override { return link_->now(); }
    [[nodiscard]] bool realTime() const override { return false; }
    void publish(Commands commands) override {
      asked_ = commands;
      link_->publish(commands);
    }
    [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& given_up) override {
      const bool reached = link_->waitForCycle(cycle, given_up);
      run_.rows.push_back({run_.phase_, asked_, link_->sensors()});
      return reached;
    }
    [[nodiscard]] Sensors sensors() const override {
      Sensors bent = link_->sensors();
      if (run_.bend) run_.bend(bent);
      return bent;
    }
    [[nodiscard]] std::string whyEnded() const override { return link_->whyEnded(); }

   private:
    std::unique_ptr<RobotLink> link_;
    VirtualRun& run_;
    Commands asked_{};
  };

  Experiment experiment_;
  std::atomic<bool> api_stop_{false};
  std::string phase_;
  std::unique_ptr<OwnRobot> robot_;
};

}  // namespace darwinop::experiments
