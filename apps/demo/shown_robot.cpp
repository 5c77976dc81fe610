// Runs a webots::Robot on the twin in lockstep and draws it.
#include "apps/demo/shown_robot.hpp"

#include <array>
#include <cstdio>
#include <thread>
#include <utility>

#include "connect/lockstep_robot.hpp"
#include "twin/model/model.hpp"
#include "twin/view/named_poses.hpp"
#include "webots/robot_impl.hpp"
#include "webots/stop_signals.hpp"
#include "webots/tool_robot.hpp"

namespace darwinop::demo {

namespace {

constexpr std::array<double, 3> kPush{10, 0, 0};  // N, forward; may make a walking robot fall
constexpr std::chrono::milliseconds kPushTime{100};

}  // namespace

struct ShownRobot::Parts {
  explicit Parts(const twin::ShowOptions& options) {
    auto body = std::make_unique<twin::RobotBody>(twin::readModel(twin::findModel(options.model)),
                                                  twin::RobotBodyOptions{.ball = twin::Ball::kNone});
    twin::RobotBody* const robot_body = body.get();
    twin::ShowOptions look = options;
    look.seconds = 0;  // the screen's clock starts before the takeover ends
    screen = twin::makeScreen(look, *body->mujocoModel(),
                              {[robot_body] { robot_body->push(kPush, kPushTime); },
                               [robot_body] { robot_body->place(twin::startAngles()); }});
    auto seen = std::make_unique<twin::WatchedBody>(std::move(body), screen->posesPerSecond());
    watched = seen.get();
    webots_api::installStopSignals();
    runtime::LoopConfig loop;
    loop.port = "twin:" + options.model;
    robot = std::make_unique<webots_api::RobotImpl>(connect::lockstepRobot(loop, std::move(seen)),
                                                    webots_api::ControllerConfig{}, webots_api::stopRequested());
    if (const std::string error = robot->begin(); !error.empty()) throw webots_api::EndedBeforeReady(error);
    for (twin::Pose takeover; watched->poses().pop(takeover);) {
    }
  }

  std::unique_ptr<twin::ViewOutput> screen;
  twin::WatchedBody* watched = nullptr;
  std::unique_ptr<webots_api::RobotImpl> robot;
};

ShownRobot::ShownRobot(const twin::ShowOptions& options) : ShownRobot{options, Parts{options}} {}

ShownRobot::ShownRobot(const twin::ShowOptions& options, Parts parts)
    : Robot{parts.robot.release()},
      watched_{parts.watched},
      screen_{std::move(parts.screen)},
      film_{!options.record.empty()},
      seconds_{options.seconds},
      begin_{std::chrono::steady_clock::now()} {}

int ShownRobot::step(int ms) {
  const int late = Robot::step(ms);
  if (late == -1) return -1;
  draw();
  const bool time_is_up = seconds_ > 0 && getTime() >= seconds_ - 1e-9;
  return time_is_up || screen_->isFinished() ? -1 : late;
}

void ShownRobot::draw() {
  std::array<char, 40> line{};
  std::snprintf(line.data(), line.size(), "%.1f s  H: help", getTime());
  while (screen_->draw(watched_->poses(), line.data())) {
  }
  if (!film_) std::this_thread::sleep_until(begin_ + std::chrono::duration<double>(getTime()));
}

void ShownRobot::finish() {
  screen_->finish(watched_->poses(), [] { return false; });
}

}  // namespace darwinop::demo
