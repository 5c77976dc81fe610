#include "gap/plant/body/limb_parts.hpp"

#include <cmath>
#include <limits>

#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
twin::Servo servoOf(const BodyHypothesis& hypothesis, Joint joint, bool is_exact,
                    std::unique_ptr<twin::Effect> surroundings) {
  const Hypothesis alone = atJoint(hypothesis.servos, joint);
  twin::ServoParameters parameters = alone.servo;
  if (is_exact) parameters.ticks_per_rev *= 1024;  // as good as not rounded
  std::vector<std::unique_ptr<twin::Effect>> effects;
  if (surroundings != nullptr) effects.push_back(std::move(surroundings));
  for (const twin::EffectSetting& effect : alone.effects) effects.push_back(effect.info->make(effect.values));
  return twin::Servo{parameters, std::move(effects)};
}

void takeRow(const Trajectory& rows, std::size_t row, ServoDrive& drive) {
  drive.torque_on = rows.torque_on[row] != 0;
  drive.goal_rad = rows.goal_rad[row];
  drive.speed_limit_rad_s =
      rows.speed_limit_rad_s > 0 ? rows.speed_limit_rad_s : std::numeric_limits<double>::infinity();
  drive.torque_limit = 1;
  if (const double p = rows.pRegisterAt(row); !std::isnan(p)) drive.p_gain = p / kPRegisterPerKp;
}

Limb linksOf(const Limb& limb, const BodyHypothesis& hypothesis) {
  Limb out = limb;
  for (Link& link : out)
    for (const LinkChange& change : hypothesis.links) {
      if (change.link != link.joint) continue;
      link.change(change.mass_kg, change.from_com_m, change.com_shift_m);
    }
  return out;
}

}  // namespace darwinop::gap
