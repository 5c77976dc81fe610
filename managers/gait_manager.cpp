// The upstream gait manager on top of the walking engine: what it says, and which joints get what it computes.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <webots/Gyro.hpp>
#include <webots/Robot.hpp>

#include "DARwInOPGaitManager.hpp"
#include "managers/borrowed_motors.hpp"
#include "managers/gait/walk.hpp"
#include "managers/gait/walking_config.hpp"
#include "webots/notices.hpp"

namespace managers {

using darwinop::facade::warnOnce;
namespace gait = darwinop::gait;

namespace {

constexpr int kTick = static_cast<int>(gait::kTickMs);
constexpr int kLongestStep = 10'000;  // ms, as that of Robot::step() in config.ini
constexpr double kCatchUpMs = 600;    // of goals that are as fast as servos: half a turn takes 256 ms

void warn(const std::string& what) {
  warnOnce("GaitManager: " + what);
}

void takeAmplitude(double& amplitude, double wanted, const char* call) {
  if (std::isnan(wanted)) return warn(std::string{call} + "(NaN) is ignored");
  amplitude = std::clamp(wanted, -1.0, 1.0);
}

}  // namespace

struct DARwInOPGaitManager::Walker {
  webots::Robot* robot = nullptr;  // null: it cannot walk
  BorrowedMotors motors;
  webots::Gyro* gyro = nullptr;
  gait::Walk walk{gait::Parameters{}};
  gait::Wish wish;
  bool balance = true;
  bool wanted = false;    // between start() and stop()
  bool stopping = false;  // inside stop(): a Robot::step() of the user may call us
  int carried_ms = 0;
  std::uint64_t reading = 0;  // cycle of the newest one that was looked at

  Walker() = default;
  /// The same robot and wishes, at rest.
  Walker(const Walker& other)
      : robot{other.robot},
        motors{other.motors},
        gyro{other.gyro},
        walk{other.walk.parameters()},
        wish{other.wish},
        balance{other.balance} {}
  Walker& operator=(const Walker&) = delete;

  void prepare(webots::Robot& with, const std::string& ini) {
    gait::WalkingConfig config = gait::readWalkingConfig(ini);
    for (const std::string& warning : config.warnings) warn(warning);
    walk = gait::Walk{config.parameters};
    motors = BorrowedMotors{with};
    gyro = with.getGyro("Gyro");
    if (gyro != nullptr) gyro->enable(static_cast<int>(with.getBasicTimeStep()));
    robot = &with;
  }

  [[nodiscard]] bool canWalk() const { return robot != nullptr && motors.exist() && !stopping; }

  /// From where the joints are now.
  void begin() {
    const gait::Pose from = motors.present();
    if (!walk.resting()) walk.abandon();  // a page was played in the middle of a step
    walk.start(from);
    carried_ms = 0;
    motors.take(walk.parameters());
  }

  /// Fresh when the board has answered since the last look, or does not answer any more.
  gait::GyroCounts gyroCounts() {
    const double* const counts = gyro != nullptr ? gyro->getValues() : nullptr;
    if (counts == nullptr || std::isnan(counts[0])) return {std::nan(""), std::nan("")};
    const std::uint64_t before = std::exchange(reading, motors.cycleOfReading());
    return {counts[0], counts[1], reading != before};
  }

  void advance(int ms) {
    if (wanted && motors.areAnothers()) return;  // until the page has ended
    if (wanted && !motors.areOurs()) begin();
    const bool walked = walk.walking(), moves = !walk.resting();
    gait::GyroCounts seen = gyroCounts();
    carried_ms += ms;
    for (; carried_ms >= kTick; carried_ms -= kTick) {
      walk.tick(wish, balance, seen);
      seen.fresh = false;
    }
    if (!moves) return;
    motors.setGoals(walk.pose());
    if (!walked && walk.walking() && balance && !walk.knowsBalance())
      warn(
          "the robot was moved, or its gyroscope is silent, so that balance cannot be calibrated; it walks without. "
          "Let it stand still for a second before start()");
    if (walk.resting()) motors.giveBack();
  }

  void stop() {
    if (!canWalk()) return;
    wanted = false;
    if (walk.resting()) return;
    walk.stop();
    stopping = true;
    const struct Stopped {  // also when the user's Robot::step() throws
      bool& stopping;
      ~Stopped() { stopping = false; }
    } stopped{stopping};
    const int basic = std::max(1, static_cast<int>(robot->getBasicTimeStep()));
    double left_ms = walk.approachMs() + 2 * walk.parameters().period_time + kCatchUpMs;
    while (!walk.resting() && left_ms > -basic) {
      if (!motors.areOurs()) {  // a page has moved them, before or inside of the user's Robot::step(): no step to end
        walk.abandon();
        return motors.giveBack();
      }
      advance(basic);
      if (robot->step(basic) == -1) break;
      left_ms -= basic;
    }
  }
};

DARwInOPGaitManager::DARwInOPGaitManager(webots::Robot* robot, const std::string& ini_filename) : walker_{new Walker} {
  try {
    if (robot == nullptr) throw std::runtime_error("it was given no robot");
    walker_->prepare(*robot, ini_filename);
  } catch (const std::exception& why) {
    warn(std::string{why.what()} + "; the robot will not walk");
  }
}

DARwInOPGaitManager::DARwInOPGaitManager(const DARwInOPGaitManager& other) : walker_{new Walker{*other.walker_}} {}

DARwInOPGaitManager& DARwInOPGaitManager::operator=(const DARwInOPGaitManager& other) {
  if (this == &other) return *this;
  Walker* const copy = new Walker{*other.walker_};
  delete walker_;
  walker_ = copy;
  return *this;
}

DARwInOPGaitManager::~DARwInOPGaitManager() {
  delete walker_;
}

bool DARwInOPGaitManager::isCorrectlyInitialized() {
  return walker_->robot != nullptr;
}

void DARwInOPGaitManager::setXAmplitude(double x) {
  takeAmplitude(walker_->wish.x, x, "setXAmplitude");
}

void DARwInOPGaitManager::setYAmplitude(double y) {
  takeAmplitude(walker_->wish.y, y, "setYAmplitude");
}

void DARwInOPGaitManager::setAAmplitude(double a) {
  takeAmplitude(walker_->wish.a, a, "setAAmplitude");
}

void DARwInOPGaitManager::setMoveAimOn(bool on) {
  walker_->wish.aim = on;
}

void DARwInOPGaitManager::setBalanceEnable(bool on) {
  walker_->balance = on;
}

void DARwInOPGaitManager::start() {
  if (walker_->canWalk()) walker_->wanted = true;
}

void DARwInOPGaitManager::step(int ms) {
  if (!walker_->canWalk()) return;
  if (ms < kTick)
    return warn("step(" + std::to_string(ms) + ") is too short and does nothing; give 8 ms or more, best a multiple");
  walker_->advance(std::min(ms, kLongestStep));
}

void DARwInOPGaitManager::stop() {
  walker_->stop();
}

}  // namespace managers
