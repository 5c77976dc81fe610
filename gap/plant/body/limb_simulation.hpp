// Servos and links of one limb that hangs from a clamped trunk, period by period of the firmware.
#pragma once

#include <cstddef>
#include <vector>

#include "core/conversions.hpp"
#include "gap/case/body/body_case.hpp"
#include "gap/plant/body/dry_friction.hpp"
#include "gap/plant/body/limb_parts.hpp"
#include "gap/plant/trace.hpp"
#include "twin/servo/servo.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::gap {

class LimbSimulation {
 public:
  static constexpr double kHeldBefore = 1.0;  // s with the goals of row 0 before it, from rest in that pose

  /// At rest kHeldBefore ahead of row 0: at its goals, or where a recording of the runtime has measured the joints.
  /// `noise`: null: the run is exact.
  LimbSimulation(const BodyCase& given, std::size_t log, const Limb& limb, const BodyHypothesis& hypothesis,
                 const Disturbance* noise);

  /// What a servo does from the next cycle on; joints count within the limb.
  [[nodiscard]] ServoDrive& drive(Eigen::Index joint) { return drives_[static_cast<std::size_t>(joint)]; }
  /// One period of the firmware.
  void cycle();

  [[nodiscard]] const twin::Signals& signals(Eigen::Index joint) const {
    return servos_[static_cast<std::size_t>(joint)].signals();
  }
  /// False: it has diverged.
  [[nodiscard]] bool isFinite() const;
  [[nodiscard]] double period_s() const { return period_; }

 private:
  void settleGears(const LimbVector& readings);
  void mechanicalStep(double dt);

  Limb links_;
  Eigen::Index n_;
  double period_;
  Eigen::Vector3d gravity_;
  std::vector<JointNoise> noise_;  // none: the run is exact
  LimbVector noise_nm_;
  std::vector<twin::Servo> servos_;
  std::vector<twin::Transmission> gears_;
  std::vector<ServoDrive> drives_;
  std::vector<bool> soft_;
  int steps_ = 1;  // in a period of the firmware
  // True angles of the arm side, and what the encoder adds to them.
  LimbVector position_, velocity_, offset_, armature_, outside_;
  JointImpulses impulses_;
};

}  // namespace darwinop::gap
