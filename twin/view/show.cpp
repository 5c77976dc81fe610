// Runs `darwinop twin view`: virtual robot, controller process, screen, signals.
#include "twin/view/show.hpp"

#include <signal.h>
#include <time.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "hal/signals.hpp"
#include "hil-mocks/pty_host.hpp"
#include "twin/model/model.hpp"
#include "twin/view/controller_process.hpp"
#include "twin/view/named_poses.hpp"
#include "twin/view/screen.hpp"
#include "twin/view/watched_body.hpp"

namespace darwinop::twin {
namespace {

using std::chrono::steady_clock;

constexpr std::array<double, 3> kPush{15, 0, 0};  // N, forward
constexpr Nanos kPushTime{100'000'000};
constexpr std::chrono::seconds kEndTimeout{10};  // for a controller after SIGINT: it moves to the start pose first
constexpr long kPollNs = 4'000'000;              // period of polling signals and poses

/// Blocks kEndSignals, to be fetched with wait(). Must be constructed before the first thread.
class Signals {
 public:
  /// Waits up to `ns`; empty if no signal arrived. True if only this process received it: a signal from the terminal
  /// also reaches the controller.
  std::optional<bool> wait(long ns) const {
    const timespec time{0, ns};
    siginfo_t info{};
    if (sigtimedwait(&set_, &info, &time) < 0) return std::nullopt;
    return info.si_code <= 0;
  }

 private:
  sigset_t set_ = blockEndSignals();
};

class Show {
 public:
  explicit Show(const ShowOptions& options) : options_{options} {
    auto body = std::make_unique<RobotBody>(readModel(findModel(options.model)));
    // Before anything is started, because opening the screen may fail.
    RobotBody& robot = *body;
    screen_ = makeScreen(options, *robot.mujocoModel(), {[this] { push(); }, [this] { reset(); }});
    auto watched = std::make_unique<WatchedBody>(std::move(body), screen_->posesPerSecond());
    watched_ = watched.get();
    hil::BoardOptions board;
    board.body_step = hil::kPhysicsStep;
    robot_ = std::make_unique<hil::VirtualRobot>(board, 1, std::move(watched));
    robot_->advance(hil::kSettlesIn);
    host_ = std::make_unique<hil::PtyHost>(*robot_);
    std::cout << "port: " << host_->path() << std::endl;
    if (!options.controller.empty()) controller_.emplace(options.controller, host_->path());
  }

  int run() {
    while (!over()) {
      takeSignals(kPollNs);
      screen_->draw(watched_->poses(), line());
      if (screen_->isFinished()) requestEnd(true);
    }
    const std::optional<int> status = controller_ && !stopping_ ? controller_->ended() : std::nullopt;
    controller_.reset();
    host_.reset();  // stops the robot
    screen_->finish(watched_->poses(), [this] {
      takeSignals(0);
      return hurry_;
    });
    return status.value_or(0);
  }

 private:
  [[nodiscard]] bool over() {
    if (hurry_) return true;
    const bool driven = controller_ && !controller_->ended();
    if (stopping_) return !driven || steady_clock::now() > end_deadline_;
    if (controller_ && !driven) reportEnd();
    return controller_ && !driven && !options_.record.empty();  // a window stays until it is closed
  }

  void takeSignals(long ns) {
    if (const std::optional<bool> only_we = signals_.wait(ns)) {
      hurry_ = stopping_ && asked_by_signal_;
      asked_by_signal_ = true;
      requestEnd(*only_we);
    }
  }

  void requestEnd(bool signal_controller) {
    if (stopping_) return;
    stopping_ = true;
    end_deadline_ = steady_clock::now() + kEndTimeout;
    if (controller_ && signal_controller) controller_->signal(SIGINT);
  }

  void reportEnd() {
    if (end_reported_) return;
    end_reported_ = true;
    std::cout << "the controller ended with status " << *controller_->ended() << std::endl;
  }

  [[nodiscard]] std::string line() {
    std::array<char, 160> text{};
    const char* const driver = !controller_           ? "no controller"
                               : controller_->ended() ? "the controller has ended"
                               : stopping_            ? "waiting for the controller to end"
                                                      : "driven by the controller";
    std::snprintf(text.data(), text.size(), "%.1f s  %s  %s  H: help",
                  std::chrono::duration<double>(host_->now()).count(), host_->path().c_str(), driver);
    return text.data();
  }

  void push() {
    host_->withRobot([this](hil::VirtualRobot&) { watched_->robot().push(kPush, kPushTime); });
  }
  void reset() {
    host_->withRobot([this](hil::VirtualRobot&) { watched_->robot().place(startAngles()); });
  }

  const ShowOptions& options_;
  Signals signals_;
  std::unique_ptr<ViewOutput> screen_;
  WatchedBody* watched_ = nullptr;  // robot_ owns it
  std::unique_ptr<hil::VirtualRobot> robot_;
  std::unique_ptr<hil::PtyHost> host_;
  std::optional<ControllerProcess> controller_;
  bool stopping_ = false, asked_by_signal_ = false, hurry_ = false, end_reported_ = false;
  steady_clock::time_point end_deadline_;
};

}  // namespace

int show(const ShowOptions& options) {
  return Show{options}.run();
}

}  // namespace darwinop::twin
