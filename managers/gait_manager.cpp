// Implements the upstream gait manager API with the walking engine.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <webots/Gyro.hpp>
#include <webots/Robot.hpp>

#include "DARwInOPGaitManager.hpp"
#include "managers/body_player/walk_player.hpp"
#include "managers/borrowed_motors.hpp"
#include "managers/gait/walking_config.hpp"
#include "managers/messages.hpp"
#include "webots/notices.hpp"

namespace managers {

using darwinop::webots_api::warnOnce;
namespace gait = darwinop::gait;

namespace {

constexpr int kTick = static_cast<int>(gait::kTickMs);
constexpr int kMaxStep = 10'000;    // ms, as for Robot::step() in config.ini
constexpr double kCatchUpMs = 600;  // for speed-limited goals to catch up: half a turn takes 256 ms

void warn(const std::string& what) {
  warnOnce("GaitManager: " + what);
}

void setAmplitude(double& amplitude, double value, const char* call) {
  if (std::isnan(value)) return warn(std::string{call} + "(NaN) is ignored");
  amplitude = std::clamp(value, -1.0, 1.0);
}

}  // namespace

struct DARwInOPGaitManager::Walker {
  webots::Robot* robot = nullptr;  // null: not initialized
  BorrowedMotors motors;
  webots::Gyro* gyro = nullptr;
  darwinop::body_player::WalkPlayer player{gait::Parameters{}};
  gait::WalkCommand command;
  bool balance = true;
  bool requested = false;  // between start() and stop()
  bool stopping = false;   // inside stop(), to reject calls from an overridden Robot::step()

  Walker() = default;
  /// The same robot and commands, at rest.
  Walker(const Walker& other)
      : robot{other.robot},
        motors{other.motors},
        gyro{other.gyro},
        player{other.walk().parameters()},
        command{other.command},
        balance{other.balance} {}
  Walker& operator=(const Walker&) = delete;

  void prepare(webots::Robot& with, const std::string& ini) {
    gait::WalkingConfig config = gait::readWalkingConfig(ini);
    for (const std::string& warning : config.warnings) warn(warning);
    player = darwinop::body_player::WalkPlayer{config.parameters};
    motors = BorrowedMotors{with};
    gyro = with.getGyro("Gyro");
    if (gyro != nullptr) gyro->enable(static_cast<int>(with.getBasicTimeStep()));
    robot = &with;
  }

  [[nodiscard]] const gait::Walk& walk() const { return player.walk(); }
  [[nodiscard]] bool canWalk() const { return robot != nullptr && motors.exist() && !stopping; }

  /// Starts at the present joint positions.
  void begin() {
    if (!walk().resting()) player.abandon();  // a motion page interrupted a step
    player.start(motors.present());
    motors.take(player);
  }

  [[nodiscard]] darwinop::body_player::GyroReading gyroReading() const {
    const double* const counts = gyro != nullptr ? gyro->getValues() : nullptr;
    if (counts == nullptr) return {std::nan(""), std::nan(""), 0};
    return {counts[0], counts[1], motors.cycleOfReading()};
  }

  void advance(int ms) {
    if (requested && motors.areAnothers()) return;  // a motion page is playing
    if (requested && !motors.areOurs()) begin();
    const bool walked = walk().walking();
    if (!player.advance(ms, command, balance, gyroReading())) return;
    motors.setGoals(player);
    if (!walked && walk().walking() && balance && !walk().isBalanceCalibrated()) warn(messages::kWalksWithoutBalance);
    if (walk().resting()) motors.giveBack();
  }

  void stop() {
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
    double remaining_ms = walk().approachMs() + 2 * walk().parameters().period_time + kCatchUpMs;
    while (!walk().resting() && remaining_ms > -basic) {
      if (!motors.areOurs()) {  // a motion page has moved the joints: there is no step to complete
        player.abandon();
        return motors.giveBack();
      }
      advance(basic);
      if (robot->step(basic) == -1) break;
      remaining_ms -= basic;
    }
  }
};

DARwInOPGaitManager::DARwInOPGaitManager(webots::Robot* robot, const std::string& ini_filename) : walker_{new Walker} {
  try {
    if (robot == nullptr) throw std::runtime_error(messages::kRobotIsNull);
    walker_->prepare(*robot, ini_filename);
  } catch (const std::exception& why) {
    warn(std::string{why.what()} + "; the gait manager is disabled");
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
  setAmplitude(walker_->command.x, x, "setXAmplitude");
}

void DARwInOPGaitManager::setYAmplitude(double y) {
  setAmplitude(walker_->command.y, y, "setYAmplitude");
}

void DARwInOPGaitManager::setAAmplitude(double a) {
  setAmplitude(walker_->command.a, a, "setAAmplitude");
}

void DARwInOPGaitManager::setMoveAimOn(bool on) {
  walker_->command.aim = on;
}

void DARwInOPGaitManager::setBalanceEnable(bool on) {
  walker_->balance = on;
}

void DARwInOPGaitManager::start() {
  if (walker_->canWalk()) walker_->requested = true;
}

void DARwInOPGaitManager::step(int ms) {
  if (!walker_->canWalk()) return;
  if (ms < kTick)
    return warn("step(" + std::to_string(ms) + ") has no effect; pass 8 ms or more, preferably a multiple of 8");
  walker_->advance(std::min(ms, kMaxStep));
}

void DARwInOPGaitManager::stop() {
  walker_->stop();
}

}  // namespace managers
