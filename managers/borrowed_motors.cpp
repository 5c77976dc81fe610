// Saves and restores motor settings for the duration of a walk.
#include "managers/borrowed_motors.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

#include "core/joints.hpp"
#include "managers/present_pose.hpp"
#include "webots/robot_impl.hpp"

namespace managers {

using darwinop::Joint;

BorrowedMotors::BorrowedMotors(webots::Robot& robot) : robot_{&robot}, impl_{darwinop::webots_api::currentRobot()} {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i] = robot.getMotor(std::string{darwinop::kJointTable[i].name});
    if (motors_[i] == nullptr) throw std::runtime_error("a joint is missing");
  }
}

BorrowedMotors& BorrowedMotors::operator=(const BorrowedMotors& other) {
  if (this == &other) return *this;
  giveBack();
  robot_ = other.robot_;
  impl_ = other.impl_;
  motors_ = other.motors_;
  return *this;
}

bool BorrowedMotors::exist() const {
  return impl_ != nullptr && darwinop::webots_api::currentRobot() == impl_;
}

const void* BorrowedMotors::takenBy() const {
  return exist() ? impl_->joints_taken_by : nullptr;
}

void BorrowedMotors::take(const darwinop::body_player::WalkPlayer& player) {
  impl_->joints_taken_by = this;
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    webots::Motor& motor = *motors_[i];
    if (!taken_) speed_[i] = motor.getVelocity(), acceleration_[i] = motor.getAcceleration();
    if (acceleration_[i] > 0) motor.setAcceleration(-1);
    if (std::abs(speed_[i]) < motor.getMaxVelocity()) motor.setVelocity(motor.getMaxVelocity());
    impl_->lendGain(static_cast<Joint>(i), player.pGain(static_cast<Joint>(i)));
  }
  taken_ = true;
}

void BorrowedMotors::giveBack() {
  if (!taken_ || !exist()) return;
  taken_ = false;
  const bool ours = areOurs();  // otherwise the gains belong to another manager
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    webots::Motor& motor = *motors_[i];
    if (motor.getVelocity() != speed_[i]) motor.setVelocity(speed_[i]);
    if (acceleration_[i] > 0) motor.setAcceleration(acceleration_[i]);
    if (ours) impl_->lendGain(static_cast<Joint>(i), {});
  }
  if (ours) impl_->joints_taken_by = nullptr;
}

std::uint64_t BorrowedMotors::cycleOfReading() const {
  const darwinop::Sensors& sensors = impl_->session().sensors();
  return sensors.cycle - sensors.board.motion.age;
}

darwinop::body_player::Pose BorrowedMotors::present() const {
  return presentPose(*robot_, *impl_);
}

void BorrowedMotors::setGoals(const darwinop::body_player::WalkPlayer& player) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const auto joint = static_cast<Joint>(i);
    motors_[i]->setPosition(player.goal(joint));
    if (areOurs()) impl_->lendGain(joint, player.pGain(joint));
  }
}

double BorrowedMotors::robotMs() const {
  return impl_->session().robotMs();
}

double BorrowedMotors::periodMs() const {
  return impl_->session().periodMs();
}

bool BorrowedMotors::carryOn(int ms) {
  return exist() && impl_->carryOn(ms);
}

}  // namespace managers
