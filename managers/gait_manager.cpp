// The upstream gait manager on top of the walking engine: what it says, and which joints get what it computes.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <webots/Gyro.hpp>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "DARwInOPGaitManager.hpp"
#include "managers/gait/walk.hpp"
#include "managers/gait/walking_config.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace managers {

using darwinop::facade::warnOnce;
namespace gait = darwinop::gait;

namespace {

constexpr int kTick = static_cast<int>(gait::kTickMs);
constexpr int kLongestStep = 10'000;  // ms, as that of Robot::step() in config.ini
constexpr double kRegisterPerKp = 8;
// A joint further than this from its goal is held by something, or limp: rad.
constexpr double kSag = 0.1;

void warn(const std::string& what) {
  warnOnce("GaitManager: " + what);
}

/// Where the robot thinks this joint is.
double whereIs(const webots::Motor& motor) {
  const double goal = motor.getTargetPosition(), measured = motor.getPosition();
  return std::isfinite(goal) && !(std::abs(goal - measured) > kSag) ? goal : measured;
}

void takeAmplitude(double& amplitude, double wanted, const char* call) {
  if (std::isnan(wanted)) return warn(std::string{call} + "(NaN) is ignored");
  amplitude = std::clamp(wanted, -1.0, 1.0);
}

}  // namespace

struct DARwInOPGaitManager::Walker {
  webots::Robot* robot = nullptr;                 // null: it cannot walk
  darwinop::facade::RobotImpl* inside = nullptr;  // of that robot
  std::array<webots::Motor*, gait::kWalkingJoints> motors{};
  webots::Gyro* gyro = nullptr;
  gait::Walk walk{gait::Parameters{}};
  gait::Wish wish;
  bool balance = true;
  bool wanted = false;    // between start() and stop()
  bool stopping = false;  // inside stop(): a Robot::step() of the user may call us
  bool lifted = false;    // the motors' limits
  int carried_ms = 0;
  std::array<double, gait::kWalkingJoints> speed{}, acceleration{};  // of the motors, while they are lifted

  Walker() = default;
  /// The same robot and wishes, at rest.
  Walker(const Walker& other)
      : robot{other.robot},
        inside{other.inside},
        motors{other.motors},
        gyro{other.gyro},
        walk{other.walk.parameters()},
        wish{other.wish},
        balance{other.balance} {}
  Walker& operator=(const Walker&) = delete;
  ~Walker() { giveMotorsBack(); }

  void prepare(webots::Robot& with, const std::string& ini) {
    gait::WalkingConfig config = gait::readWalkingConfig(ini);
    for (const std::string& warning : config.warnings) warn(warning);
    walk = gait::Walk{config.parameters};
    for (std::size_t i = 0; i < motors.size(); ++i) {
      motors[i] = with.getMotor(std::string{darwinop::kJointTable[i].name});
      if (motors[i] == nullptr) throw std::runtime_error("a joint is missing");
    }
    gyro = with.getGyro("Gyro");
    if (gyro != nullptr) gyro->enable(static_cast<int>(with.getBasicTimeStep()));
    robot = &with;
    inside = darwinop::facade::currentRobot();
  }

  /// False: the robot has gone, and its motors with it.
  [[nodiscard]] bool canWalk() const { return robot != nullptr && darwinop::facade::currentRobot() == inside; }
  [[nodiscard]] const void* jointsTakenBy() const { return inside != nullptr ? inside->joints_taken_by : this; }

  /// From where the joints are now.
  void begin() {
    gait::Pose from{};
    std::ranges::transform(motors, from.begin(), [](const webots::Motor* motor) { return whereIs(*motor); });
    if (!walk.resting()) walk.abandon();  // a page was played in the middle of a step
    walk.start(from);
    carried_ms = 0;
    takeMotors();
  }

  /// Walking needs what the servos can give: a speed limit of the controller's would make it fall.
  void takeMotors() {
    if (inside != nullptr) inside->joints_taken_by = this;
    for (std::size_t i = 0; i < motors.size(); ++i) {
      webots::Motor& motor = *motors[i];
      if (!lifted) speed[i] = motor.getVelocity(), acceleration[i] = motor.getAcceleration();
      if (acceleration[i] > 0) motor.setAcceleration(-1);
      if (std::abs(speed[i]) < motor.getMaxVelocity()) motor.setVelocity(motor.getMaxVelocity());
      lendGain(i, gait::pGain(static_cast<darwinop::Joint>(i), walk.parameters()) / kRegisterPerKp);
    }
    lifted = true;
  }

  void giveMotorsBack() {
    if (!lifted || !canWalk()) return;
    lifted = false;
    const bool ours = jointsTakenBy() == this;  // else their gains are a page's
    for (std::size_t i = 0; i < motors.size(); ++i) {
      webots::Motor& motor = *motors[i];
      if (motor.getVelocity() != speed[i]) motor.setVelocity(speed[i]);
      if (acceleration[i] > 0) motor.setAcceleration(acceleration[i]);
      if (ours) lendGain(i, {});
    }
    if (ours && inside != nullptr) inside->joints_taken_by = nullptr;
  }

  void lendGain(std::size_t joint, std::optional<double> kp) {
    if (inside != nullptr) inside->lendGain(static_cast<darwinop::Joint>(joint), kp);
  }

  void advance(int ms) {
    const void* const taken_by = jointsTakenBy();
    if (wanted && taken_by != nullptr && taken_by != this) return;  // until the page has ended
    if (wanted && (walk.resting() || taken_by == nullptr)) begin();
    const bool walked = walk.walking();
    const double* const counts = gyro != nullptr ? gyro->getValues() : nullptr;
    const gait::GyroCounts seen =
        counts != nullptr ? gait::GyroCounts{counts[0], counts[1]} : gait::GyroCounts{std::nan(""), std::nan("")};
    carried_ms += ms;
    const bool moves = !walk.resting();
    for (; carried_ms >= kTick; carried_ms -= kTick) walk.tick(wish, balance, seen);
    if (!moves) return;
    for (std::size_t i = 0; i < motors.size(); ++i) motors[i]->setPosition(walk.pose()[i]);
    if (!walked && walk.walking() && balance && !walk.knowsBalance())
      warn(
          "the robot was moved, or its gyroscope is silent, so that balance cannot be calibrated; it walks without. "
          "Let it stand still for a second before start()");
    if (walk.resting()) giveMotorsBack();
  }

  void stop() {
    if (!canWalk() || stopping) return;
    wanted = false;
    if (walk.resting()) return;
    if (jointsTakenBy() != this) {  // there is no step to end
      walk.abandon();
      return giveMotorsBack();
    }
    walk.stop();
    stopping = true;
    const struct Stopped {  // also when the user's Robot::step() throws
      bool& stopping;
      ~Stopped() { stopping = false; }
    } stopped{stopping};
    const int basic = std::max(1, static_cast<int>(robot->getBasicTimeStep()));
    double left_ms = walk.approachMs() + 2 * walk.parameters().period_time;
    while (!walk.resting() && left_ms > -basic) {
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
  if (walker_->canWalk() && !walker_->stopping) walker_->wanted = true;
}

void DARwInOPGaitManager::step(int ms) {
  if (!walker_->canWalk() || walker_->stopping) return;
  if (ms < kTick)
    return warn("step(" + std::to_string(ms) + ") is too short and does nothing; give 8 ms or more, best a multiple");
  walker_->advance(std::min(ms, kLongestStep));
}

void DARwInOPGaitManager::stop() {
  walker_->stop();
}

}  // namespace managers
