// What the tests of exports share: a servo of the data sheet that swings an arm, with effects by name.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gap/export/fields.hpp"
#include "gap/export/joints.hpp"
#include "gap/export/targets.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {

/// Arm of 40 g and 17 cm. Effects begin at their neutral values.
class Believed {
 public:
  Believed() {
    hypothesis_.pendulum = {.payload_kg = 0, .arm_mass_kg = 0.04, .length_m = 0.17, .gravity_m_s2 = 9.80665};
  }
  Believed& with(std::string_view effect, std::string_view key, double value) {
    const twin::EffectInfo* const info = twin::findEffect(effect);
    if (info == nullptr) throw std::runtime_error("no effect " + std::string{effect});
    valueOf(hypothesis_.with(*info), key) = value;
    return *this;
  }
  Believed& bySpeed() {
    hypothesis_.servo.law = twin::Law::kSpeedP;
    return *this;
  }
  Believed& friction() { return with("coulomb", "friction", 0.06).with("viscous", "damping", 0.01); }
  [[nodiscard]] const Hypothesis& get() const { return hypothesis_; }

 private:
  Hypothesis hypothesis_;
};

inline ExportSettings forArm(double payload_kg = 0.3) {
  ExportSettings settings;
  settings.joint = "ArmUpperR";
  settings.payload_kg = payload_kg;
  return settings;
}

inline std::unique_ptr<TargetJoint> jointFor(Target target, const Hypothesis& h, const ExportSettings& settings) {
  return jointOf(target, numbersOf(h, settings.conditions()), armOf(h, settings.payload_kg), settings.stepOf(target));
}

}  // namespace darwinop::gap
