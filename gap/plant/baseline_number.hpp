// Numbers of a bench that have a prior, by name: of the servo, and of the load.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// Payload, length or mass of the arm, as a factor of what was weighed or measured.
enum class LoadFactor { kPayload, kLength, kArmMass };
/// A number of the servo, as a factor.
using ServoFactor = double twin::ServoParameters::*;

struct BaselineNumber {
  std::string_view name;  // in the priors of a case
  std::variant<LoadFactor, ServoFactor> what;
};
inline const std::array kBaselineNumbers{
    BaselineNumber{"kt", &twin::ServoParameters::kt_nm_a},
    BaselineNumber{"resistance", &twin::ServoParameters::resistance_ohm},
    BaselineNumber{"armature", &twin::ServoParameters::armature_kgm2},
    BaselineNumber{"supply", &twin::ServoParameters::supply_v},
    BaselineNumber{"duty_per_kp", &twin::ServoParameters::duty_per_kp_per_rad},
    BaselineNumber{"speed_gain_per_kp", &twin::ServoParameters::speed_gain_per_kp_1_s},
    BaselineNumber{"payload", LoadFactor::kPayload},
    BaselineNumber{"length", LoadFactor::kLength},
    BaselineNumber{"arm_mass", LoadFactor::kArmMass},
    BaselineNumber{"back_emf", &twin::ServoParameters::back_emf_vs_rad},
};

/// Present value: in SI units, of the payload its factor. NaN for an unknown name.
double numberIn(const Hypothesis& hypothesis, std::string_view name);

}  // namespace darwinop::gap
