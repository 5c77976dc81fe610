// Overrides speed limits and P gains for the duration of a walk.
#include "managers/borrowed_motors.hpp"

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
    impl_->lendFullSpeed(static_cast<Joint>(i), true);
    impl_->lendGain(static_cast<Joint>(i), player.pGain(static_cast<Joint>(i)));
  }
  taken_ = true;
}

void BorrowedMotors::giveBack() {
  if (!taken_ || !exist()) return;
  taken_ = false;
  for (std::size_t i = 0; i < motors_.size(); ++i) impl_->lendFullSpeed(static_cast<Joint>(i), false);
  if (!areOurs()) return;  // the gains are another manager's, and setGoals() takes full speed back
  for (std::size_t i = 0; i < motors_.size(); ++i) impl_->lendGain(static_cast<Joint>(i), {});
  impl_->joints_taken_by = nullptr;
}

std::uint64_t BorrowedMotors::cycleOfReading() const {
  const darwinop::Sensors& sensors = impl_->session().sensors();
  return sensors.cycle - sensors.board.motion.age;
}

darwinop::body_player::Pose BorrowedMotors::present() const {
  return presentPose(*robot_, *impl_);
}

darwinop::State BorrowedMotors::state() const {
  return impl_->session().sensors().safety.state;
}

void BorrowedMotors::setGoals(const darwinop::body_player::WalkPlayer& player) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const auto joint = static_cast<Joint>(i);
    motors_[i]->setPosition(player.goal(joint));
    if (!areOurs()) continue;
    impl_->lendGain(joint, player.pGain(joint));
    impl_->lendFullSpeed(joint, true);
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
