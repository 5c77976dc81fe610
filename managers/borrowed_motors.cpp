#include "managers/borrowed_motors.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/present_goal.hpp"
#include "webots/robot_impl.hpp"

namespace managers {

namespace gait = darwinop::gait;
using darwinop::Joint;

namespace {

constexpr double kRegisterPerKp = 8;

}  // namespace

BorrowedMotors::BorrowedMotors(webots::Robot& robot) : inside_{darwinop::facade::currentRobot()} {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i] = robot.getMotor(std::string{darwinop::kJointTable[i].name});
    if (motors_[i] == nullptr) throw std::runtime_error("a joint is missing");
  }
}

BorrowedMotors& BorrowedMotors::operator=(const BorrowedMotors& other) {
  if (this == &other) return *this;
  giveBack();
  inside_ = other.inside_;
  motors_ = other.motors_;
  return *this;
}

bool BorrowedMotors::exist() const {
  return inside_ != nullptr && darwinop::facade::currentRobot() == inside_;
}

const void* BorrowedMotors::takenBy() const {
  return exist() ? inside_->joints_taken_by : nullptr;
}

void BorrowedMotors::take(const gait::Parameters& gains) {
  inside_->joints_taken_by = this;
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    webots::Motor& motor = *motors_[i];
    if (!lifted_) speed_[i] = motor.getVelocity(), acceleration_[i] = motor.getAcceleration();
    if (acceleration_[i] > 0) motor.setAcceleration(-1);
    if (std::abs(speed_[i]) < motor.getMaxVelocity()) motor.setVelocity(motor.getMaxVelocity());
    inside_->lendGain(static_cast<Joint>(i), gait::pGain(static_cast<Joint>(i), gains) / kRegisterPerKp);
  }
  lifted_ = true;
}

void BorrowedMotors::giveBack() {
  if (!lifted_ || !exist()) return;
  lifted_ = false;
  const bool ours = areOurs();  // else their gains are another's
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    webots::Motor& motor = *motors_[i];
    if (motor.getVelocity() != speed_[i]) motor.setVelocity(speed_[i]);
    if (acceleration_[i] > 0) motor.setAcceleration(acceleration_[i]);
    if (ours) inside_->lendGain(static_cast<Joint>(i), {});
  }
  if (ours) inside_->joints_taken_by = nullptr;
}

std::uint64_t BorrowedMotors::cycleOfReading() const {
  const darwinop::Sensors& sensors = inside_->session().sensors();
  return sensors.cycle - sensors.board.motion.age;
}

gait::Pose BorrowedMotors::present() const {
  gait::Pose pose{};
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const auto joint = static_cast<Joint>(i);
    pose[i] = darwinop::presentGoal(joint, inside_->lastKnown(joint), motors_[i]->getTargetPosition());
  }
  return pose;
}

void BorrowedMotors::setGoals(const gait::Pose& goals) {
  for (std::size_t i = 0; i < motors_.size(); ++i) motors_[i]->setPosition(goals[i]);
}

}  // namespace managers
