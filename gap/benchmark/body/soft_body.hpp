// A robot whose contacts, dry friction and stops are bounded springs and dampers: servos of the twin, on masses and
// geometry of its body. One log of a case, row by row.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "gap/benchmark/body/body_physics.hpp"
#include "gap/benchmark/body/soft_contacts.hpp"
#include "gap/plant/body/floor_parts.hpp"
#include "gap/plant/body/limb_parts.hpp"
#include "hal/body.hpp"
#include "twin/body/imu.hpp"
#include "twin/body/mujoco_guard.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::gap {

inline constexpr double kHeldClamped = 1.0, kHeldFree = 1.5;  // s with the goals of row 0 before it

class SoftBody {
 public:
  SoftBody(BodyCase& plan, std::size_t log, const BodyTruth& truth, const Disturbance* noise);
  bool run();

 private:
  void place();
  void writeRow(std::size_t row);
  void cycle();
  void act();
  void step(double time_s);
  void addFriction(std::vector<SoftRow>& rows);
  void addStops(std::vector<SoftRow>& rows);
  [[nodiscard]] Eigen::Index of(int dof) const { return dof - first_; }
  [[nodiscard]] bool isClamped() const { return log_.setup == BodySetup::kClamped; }
  [[nodiscard]] Trajectory& rowsOf(std::size_t joint) { return plan_.joints.logs[log_index_ * kJoints + joint]; }

  BodyCase& plan_;
  std::size_t log_index_;
  BodyLog& log_;
  const BodyTruth& truth_;
  const Disturbance* noise_;
  double period_, ambient_c_, dt_;
  std::vector<JointNoise> joint_noise_;
  std::vector<twin::Servo> servos_;
  std::array<twin::Transmission, kJoints> gears_;
  std::array<bool, kJoints> soft_{};
  std::array<double, kJoints> bend_{}, outside_nm_{}, supply_v_{};
  std::array<twin::Actuation, kJoints> acts_{};
  twin::MjModelPtr model_;
  twin::BodyMap map_;
  SoftContacts contacts_;
  twin::MjDataPtr data_;
  std::unique_ptr<twin::Imu> imu_;
  twin::Imu::Axes accel_m_s2_{};
  Drives drives_{};
  int first_ = 0;  // degree of freedom that moves
  ContactNumbers contact_{};
  double time_s_ = 0;
};

}  // namespace darwinop::gap
