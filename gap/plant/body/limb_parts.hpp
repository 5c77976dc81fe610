// Parts of a simulated limb under a hypothesis: servos, links, noise.
#pragma once

#include <memory>

#include "core/random.hpp"
#include "core/registers.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/body/limb_roll_out.hpp"
#include "twin/servo/servo.hpp"

namespace darwinop::gap {

/// s; longest step with an elastic transmission, as twin/body/robot_body_parts.cpp.
inline constexpr double kElasticStep = 0.00025;
inline constexpr double kPRegisterPerKp = 1 / find(kMx28, "p_gain").scale;

/// `is_exact`: an encoder without steps, so that the result is a smooth function of the hypothesis. `surroundings`:
/// acts before all effects; may be null.
twin::Servo servoOf(const BodyHypothesis& hypothesis, Joint joint, bool is_exact,
                    std::unique_ptr<twin::Effect> surroundings = nullptr);
/// What a row writes to a joint's servo; the gain stays where the row has none. The supply is the caller's.
void takeRow(const Trajectory& rows, std::size_t row, ServoDrive& drive);
/// The limb as the hypothesis has it, but for the servos.
Limb linksOf(const Limb& limb, const BodyHypothesis& hypothesis);

/// Noise of one joint, in every period of the firmware.
struct JointNoise {
  GaussMarkov torque_nm, supply_v;
  Rng encoder;
  double encoder_rad;

  JointNoise(const Disturbance& of, std::uint64_t seed, double period_s, double tick_rad)
      : torque_nm{of.torque_nm, of.torque_time_s, period_s, splitMix(seed)},
        supply_v{of.supply_v, of.supply_time_s, period_s, splitMix(seed + kSplitMixStep)},
        encoder{splitMix(seed + 2 * kSplitMixStep)},
        encoder_rad{of.encoder_ticks * tick_rad} {}
};

}  // namespace darwinop::gap
