// A walk on a robot.
#include "managers/walker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <webots/Gyro.hpp>
#include <webots/Robot.hpp>

#include "managers/gait/walking_config.hpp"
#include "managers/messages.hpp"
#include "webots/notices.hpp"

namespace managers {

namespace gait = darwinop::gait;

namespace {

constexpr double kCatchUpMs = 600;    // for speed-limited goals to catch up: half a turn takes 256 ms
constexpr int kEndStepMs = 16;        // two calls of the engine
constexpr double kStandMs = 400;      // until the last step has come to rest
constexpr double kEndBoundMs = 2480;  // enough for periods up to 1.6 s; the supervisor kills after 3 s

// What a slow loop can do, measured in the twin: goals of the gyroscope that are held for longer make it fall, and at
// 80 ms a round so do strides of more than 0.75 of the greatest.
constexpr double kBalanceRoundMs = 52, kStrideRoundMs = 68, kSlowStride = 0.7;

/// Longest time from a stop to the stance.
double stopMs(const gait::Parameters& parameters) {
  return 2 * parameters.period_time + kCatchUpMs;
}

}  // namespace

void warnOfGait(const std::string& what) {
  darwinop::webots_api::warnOnce("GaitManager: " + what);
}

void GaitWalker::prepare(webots::Robot& with, const std::string& ini) {
  gait::WalkingConfig config = gait::readWalkingConfig(ini);
  for (const std::string& warning : config.warnings) warnOfGait(warning);
  player = darwinop::body_player::WalkPlayer{config.parameters};
  motors = BorrowedMotors{with};
  gyro = with.getGyro("Gyro");
  if (gyro != nullptr) gyro->enable(static_cast<int>(with.getBasicTimeStep()));
  robot = &with;
}

/// Starts at the present joint positions.
void GaitWalker::begin() {
  if (!walk().resting()) player.abandon();  // a motion page interrupted a step
  player.start(motors.present());
  motors.take(player);
}

darwinop::body_player::GyroReading GaitWalker::gyroReading() const {
  const double* const counts = gyro != nullptr ? gyro->getValues() : nullptr;
  if (counts == nullptr) return {std::nan(""), std::nan(""), 0};
  return {counts[0], counts[1], motors.cycleOfReading()};
}

void GaitWalker::step(int ms) {
  if (requested && motors.areAnothers()) return;  // a motion page is playing
  const bool begins = requested && !motors.areOurs();
  if (begins) clock.restart();
  const double passed_ms = clock.advance(ms, motors.robotMs(), motors.periodMs());
  if (waitsForRobot(passed_ms)) return;
  if (begins) begin();
  advance(passed_ms);
  warnIfSlow(ms);
}

/// True while the robot does not follow. A walk that waited for too long is over; step() begins the next one.
bool GaitWalker::waitsForRobot(double ms) {
  following.update(motors.state(), ms);
  if (following.isLost() && !walk().resting()) {
    warnOfGait(std::string{"the walk"} + messages::kNotFollowed + messages::kWalksAgain);
    player.abandon();
    motors.giveBack();
  }
  return !following.isGiven();
}

void GaitWalker::advance(double ms) {
  // At rest the gyroscope is calibrated in any loop. Servos without a board have none to wait for.
  const bool balances = balance && gyro != nullptr && (!walk().walking() || clock.roundMs() <= kBalanceRoundMs);
  if (!player.advance(ms, pacedCommand(), balances, gyroReading())) return;
  motors.setGoals(player);
  if (walk().walking() && balance && !walk().isBalanceCalibrated())
    warnOfGait(gyro != nullptr ? messages::kWalksWithoutBalance : messages::kNoGyroscope);
  if (walk().resting()) motors.giveBack();
}

gait::WalkCommand GaitWalker::pacedCommand() const {
  if (clock.roundMs() <= kStrideRoundMs) return command;
  gait::WalkCommand shorter = command;
  for (double* const amplitude : {&shorter.x, &shorter.y, &shorter.a}) *amplitude *= kSlowStride;
  return shorter;
}

void GaitWalker::warnIfSlow(int ms) {
  const double round_ms = clock.slowRoundMs();
  if (round_ms == 0 || slow_warned || !walk().walking()) return;
  slow_warned = true;
  warnOfGait(messages::tooSlow(round_ms, ms));
}

void GaitWalker::stop() {
  if (!canWalk()) return;
  requested = false;
  if (walk().resting()) return;
  player.stop();
  stopping = true;
  const struct Stopped {  // resets the flag also if an overridden Robot::step() throws
    bool& stopping;
    ~Stopped() { stopping = false; }
  } stopped{stopping};
  const int basic = std::max(1, static_cast<int>(robot->getBasicTimeStep()));
  double remaining_ms = walk().approachMs() + stopMs(walk().parameters());
  while (!walk().resting() && remaining_ms > -basic) {
    if (!motors.areOurs()) {  // a motion page has moved the joints: there is no step to complete
      player.abandon();
      return motors.giveBack();
    }
    step(basic);
    if (robot->step(basic) == -1) break;
    remaining_ms -= basic;
  }
}

void GaitWalker::finish() {
  requested = false;
  if (robot == nullptr || !motors.exist() || !motors.areOurs() || !walk().walking()) return;
  player.stop();
  double remaining_ms = std::min(stopMs(walk().parameters()), kEndBoundMs);
  for (; !walk().resting() && remaining_ms >= kEndStepMs; remaining_ms -= kEndStepMs) {
    advance(kEndStepMs);
    if (!motors.carryOn(kEndStepMs)) return;
  }
  for (double stood_ms = 0; stood_ms < kStandMs; stood_ms += kEndStepMs)
    if (!motors.carryOn(kEndStepMs)) return;
}

}  // namespace managers
