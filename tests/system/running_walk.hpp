// The example that walks, on a robot of its own with daemon and recording, ended by a signal at a moment of its gait.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "managers/gait/goals.hpp"
#include "runtime/environment.hpp"
#include "runtime/exchange.hpp"
#include "runtime/names.hpp"
#include "runtime/operator.hpp"
#include "system/program.hpp"

namespace darwinop {

class RunningWalk {
 public:
  enum class Link { kDaemon, kTcp };
  enum class Part { kController, kServer, kDaemon };
  struct Plan {
    Link link;
    Part ends;
    int signal;
    std::uint64_t moment;  // cycles after the start of a gait period
  };

  /// `folder` is created.
  RunningWalk(const Plan& plan, std::string folder) : plan_{plan}, folder_{std::move(folder)} {
    std::filesystem::create_directory(folder_);
  }

  /// Starts all, ends each walk at its moment, and ends the robots.
  static void runAll(const std::vector<std::unique_ptr<RunningWalk>>& walks) {
    for (const auto& walk : walks) walk->startRobot();
    for (const auto& walk : walks) walk->startDaemon();
    for (const auto& walk : walks) walk->startWalk();
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds{40};
    for (bool all = false; !all && std::chrono::steady_clock::now() < give_up;) {
      all = true;
      for (const auto& walk : walks) all = walk->isSignalled() && all;
      std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
    for (const auto& walk : walks) walk->awaitEnd();
  }

  /// Controller and daemon have ended in time, by themselves.
  [[nodiscard]] bool ended() const { return ended_; }
  /// In which the signal was sent.
  [[nodiscard]] double endCycle() const { return static_cast<double>(end_cycle_); }
  [[nodiscard]] std::string recording() const { return file("log.csv"); }
  [[nodiscard]] std::string outputs() const {
    std::string all;
    for (const auto* program : {&robot_, &daemon_, &server_, &walk_})
      if (*program) all += (*program)->output();
    return all;
  }

 private:
  using Running = std::unique_ptr<Program>;

  [[nodiscard]] std::string file(const std::string& name) const { return folder_ + "/" + name; }
  [[nodiscard]] static std::string program(const std::string& name) { return DARWINOP_BIN "/" + name; }
  [[nodiscard]] Running start(const std::vector<std::string>& command, const std::string& output) const {
    const runtime::Environment name{"DARWINOP_RUNTIME_NAME", file("runtime")};
    return std::make_unique<Program>(command, file(output));
  }

  void startRobot() {
    robot_ = start({program("darwinop-virtual-robot"), "--link", file("port")}, "robot.txt");
    ASSERT_TRUE(robot_->says("link:", std::chrono::seconds{20})) << robot_->output();
  }
  void startDaemon() {
    daemon_ =
        start({program("darwinop-runtime"), "--wait", "--robot", file("port"), "--record", recording()}, "daemon.txt");
    ASSERT_TRUE(daemon_->says("ready:", std::chrono::seconds{20})) << daemon_->output();
    observer_ = runtime::attachToDaemon(runtime::RuntimeFiles{file("runtime")});
  }
  void startWalk() {
    std::string setting = "runtime";
    if (plan_.link == Link::kTcp) {
      server_ = start({program("darwinop-remote"), "--robot", "runtime", "--port", "0"}, "server.txt");
      const std::string ready = "ready: ";
      ASSERT_TRUE(server_->says("\n", std::chrono::seconds{20})) << server_->output();
      const std::string said = server_->output();
      const std::size_t at = said.find(ready) + ready.size();
      setting = "tcp://" + said.substr(at, said.find('\n', at) - at);
    }
    const runtime::Environment robot{"DARWINOP_ROBOT", setting};
    walk_ = start({DARWINOP_WALK, "--seconds", "60"}, "walk.txt");
  }

  /// True once its walk has been at its moment.
  [[nodiscard]] bool isSignalled() {
    if (end_cycle_ != 0 || !observer_) return true;
    (void)observer_->block().sensors.read(seen_);
    const bool stands = isInTheStance();
    stood_ = stood_ || stands;
    if (first_step_ == 0 && stood_ && !stands) first_step_ = seen_.cycle;
    if (first_step_ == 0 || seen_.cycle < first_step_ + kSteps + plan_.moment) return false;
    end_cycle_ = seen_.cycle;
    (plan_.ends == Part::kController ? walk_ : plan_.ends == Part::kServer ? server_ : daemon_)->kill(plan_.signal);
    return true;
  }
  [[nodiscard]] bool isInTheStance() const {
    if (seen_.safety.state != State::kDriven) return false;
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      if (!(std::abs(seen_.joint[i].commanded.value - gait::kStanding.rad(i)) < 1e-4)) return false;
    return true;
  }

  void awaitEnd() {
    if (end_cycle_ == 0) return;
    const bool over = walk_->wait(std::chrono::seconds{20}).has_value();
    if (server_ && plan_.ends != Part::kServer) server_->kill(SIGTERM);
    if (plan_.ends != Part::kDaemon) daemon_->kill(SIGTERM);
    ended_ = over && daemon_->wait(std::chrono::seconds{20}) == 0;
  }

  static constexpr std::uint64_t kSteps = 75;  // cycles: two periods

  Plan plan_;
  std::string folder_;
  Running robot_, daemon_, server_, walk_;
  std::optional<runtime::Exchange> observer_;
  Sensors seen_{};
  bool stood_ = false, ended_ = false;
  std::uint64_t first_step_ = 0, end_cycle_ = 0;
};

}  // namespace darwinop
