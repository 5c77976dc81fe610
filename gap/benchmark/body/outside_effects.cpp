#include "gap/benchmark/body/outside_effects.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace darwinop::gap {

void hideOutside(const std::string& id, const BodyCase& plan, Rng& rng, BodyTruth& truth, BodyKey& key) {
  key.is_outside = true;
  if (id == kCable) {
    constexpr std::array kPulled{Joint::kNeck, Joint::kHead, Joint::kArmLowerR, Joint::kArmLowerL};
    const Joint joint = rng.pick(kPulled);
    const double stiffness = rng.between(1, 2.5), from = rng.between(-0.1, 0.1), sign = rng.sign();
    truth.outside =
        Disturber{.joint = joint,
                  .torque_nm = [=](double angle) { return -sign * stiffness * std::max(0.0, sign * (angle - from)); },
                  .file = {}};
    key.where = {std::string{row(joint).name}};
  } else if (id == kPush) {
    const double from = rng.between(0.8, 2), angle = rng.between(-kPi, kPi), size = rng.between(4, 7);
    truth.outside = Disturber{.joint = {},
                              .torque_nm = {},
                              .file = plan.logs[4].file,
                              .from_s = from,
                              .to_s = from + 0.2,
                              .push_n = {size * std::cos(angle), size * std::sin(angle), 0}};
    key.where = {"Body"};
  } else {
    const Joint joint = rng.coin() ? Joint::kArmLowerR : Joint::kArmLowerL;
    truth.loose = LinkChange{.link = joint, .mass_kg = rng.between(0.05, 0.09)};
    truth.loose_from_s = plan.logs[3].session_start_s;
    key.where = {std::string{row(joint).name}};
  }
  key.effects.push_back({id, key.where, {}});
}

}  // namespace darwinop::gap
