#include "gap/identify/body/mechanical_effect.hpp"

#include <algorithm>
#include <cmath>

#include "gap/plant/body/joint_alone.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

// m: a link of this robot is 0.03 to 0.1 m long.
constexpr double kLinkLength = 0.04, kFarthest = 0.15;

bool isSearched(const twin::EffectInfo& info) {
  // Masses have effects of their own here; what drifts with the session needs longer ones than these logs.
  static constexpr std::array<std::string_view, 2> kElsewhere{"com_mass", "temp_drift"};
  return info.visibility == twin::Visibility::kAtHost && info.laws != twin::Laws::kReplacesSpeedP &&
         std::ranges::find(kElsewhere, info.id) == kElsewhere.end();
}

/// Every joint has friction, some more than others: what is hidden in several of them comes on top of each one's own.
bool isAdded(const twin::Parameter& parameter) {
  return parameter.role == twin::ParameterRole::kDryFriction || parameter.role == twin::ParameterRole::kViscousFriction;
}

std::vector<double> valuesOf(const BodyHypothesis& robot, const twin::EffectInfo& info, Joint joint) {
  const Hypothesis alone = atJoint(robot.servos, joint);
  if (const twin::EffectSetting* const there = alone.find(info.id)) return there->values;
  std::vector<double> neutral;
  for (const twin::Parameter& parameter : info.parameters) neutral.push_back(parameter.neutral);
  return neutral;
}

MechanicalEffect ofServo(const twin::EffectInfo& info) {
  MechanicalEffect out{.id = info.id, .is_of_link = false, .numbers = {}, .apply = {}, .values_in = {}};
  for (const twin::Parameter& parameter : info.parameters)
    out.numbers.push_back({.key = parameter.key,
                           .unit = parameter.unit,
                           .low = isAdded(parameter) ? -parameter.high : parameter.low,
                           .high = parameter.high,
                           .neutral = parameter.neutral,
                           .typical = parameter.typical,
                           .prior_sigma = 0,
                           .is_secondary = parameter.secondary || parameter.fixed,
                           .is_logarithmic = parameter.logarithmic && !isAdded(parameter),
                           .is_addition = isAdded(parameter)});
  out.apply = [&info](BodyHypothesis& robot, Joint joint, const std::vector<double>& values) {
    std::vector<double> total = values;
    const std::vector<double> own = valuesOf(robot, info, joint);
    for (std::size_t i = 0; i < total.size(); ++i)
      if (isAdded(info.parameters[i])) total[i] = std::max(info.parameters[i].low, own[i] + values[i]);
    robot.servos.with(info, {.kind = Place::Kind::kJoint, .name = std::string{row(joint).name}}).values = total;
  };
  out.values_in = [&info](const BodyHypothesis& robot, Joint joint) {
    std::vector<double> values = valuesOf(robot, info, joint);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (isAdded(info.parameters[i])) values[i] = 0;
    return values;
  };
  return out;
}

/// Of the three axes of the link's frame.
MechanicalEffect::Number length(std::string_view key, bool is_secondary) {
  return {.key = key,
          .unit = "m",
          .low = -kFarthest,
          .high = kFarthest,
          .neutral = 0,
          .typical = 0,
          .prior_sigma = kLinkLength,
          .is_secondary = is_secondary};
}

std::vector<double> zeros(std::size_t count) {
  return std::vector<double>(count, 0.0);
}

MechanicalEffect linkMass() {
  return {.id = "link_mass",
          .is_of_link = true,
          .numbers =
              {{.key = "mass", .unit = "kg", .low = -0.5, .high = 1, .neutral = 0, .typical = 0.05, .prior_sigma = 0.1},
               length("x", true),
               length("y", true),
               length("z", true)},
          .apply =
              [](BodyHypothesis& robot, Joint joint, const std::vector<double>& values) {
                robot.links.push_back({.link = joint,
                                       .mass_kg = values[0],
                                       .from_com_m = {values[1], values[2], values[3]},
                                       .com_shift_m = Eigen::Vector3d::Zero()});
              },
          .values_in = [](const BodyHypothesis&, Joint) { return zeros(4); }};
}

MechanicalEffect linkCom() {
  return {.id = "link_com",
          .is_of_link = true,
          .numbers = {length("x", false), length("y", false), length("z", false)},
          .apply =
              [](BodyHypothesis& robot, Joint joint, const std::vector<double>& values) {
                robot.links.push_back({.link = joint,
                                       .mass_kg = 0,
                                       .from_com_m = Eigen::Vector3d::Zero(),
                                       .com_shift_m = {values[0], values[1], values[2]}});
              },
          .values_in = [](const BodyHypothesis&, Joint) { return zeros(3); }};
}

}  // namespace

const std::vector<MechanicalEffect>& mechanicalEffects() {
  static const std::vector<MechanicalEffect> kEffects = [] {
    std::vector<MechanicalEffect> out;
    for (const twin::EffectInfo* const info : twin::catalogue())
      if (isSearched(*info)) out.push_back(ofServo(*info));
    out.push_back(linkMass());
    out.push_back(linkCom());
    return out;
  }();
  return kEffects;
}

double ownNumber(const BodyHypothesis& robot, const MechanicalEffect& effect, Joint joint) {
  return valuesOf(robot, *twin::findEffect(effect.id), joint).front();
}

std::size_t freeNumbers(const MechanicalEffect& effect) {
  return static_cast<std::size_t>(std::ranges::count_if(
      effect.numbers, [](const auto& number) { return !number.is_secondary || number.prior_sigma > 0; }));
}

// Right and left of a kind are neighbours in the table of joints.
std::optional<Joint> leftOf(Joint joint) {
  const auto j = static_cast<std::size_t>(joint);
  if (j % 2 != 0 || joint >= Joint::kNeck) return std::nullopt;
  return static_cast<Joint>(j + 1);
}

std::vector<std::vector<double>> startsOf(const MechanicalEffect& effect, const std::vector<double>& now) {
  std::vector<std::vector<double>> starts;
  std::vector<double> base = now;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const MechanicalEffect::Number& number = effect.numbers[i];
    if (number.is_secondary && now[i] == number.neutral) base[i] = number.typical;
  }
  const auto add = [&](std::size_t at, double value) {
    std::vector<double> start = base;
    start[at] = std::clamp(value, effect.numbers[at].low, effect.numbers[at].high);
    if (start != now) starts.push_back(std::move(start));
  };
  if (effect.is_of_link) {
    if (effect.numbers.front().unit == "kg") base[0] = effect.numbers.front().typical, starts.push_back(base);
    for (std::size_t i = 0; i < base.size(); ++i)
      if (effect.numbers[i].unit == "m") add(i, now[i] + kLinkLength / 4);
    return starts;
  }
  for (std::size_t i = 0; i < effect.numbers.size(); ++i) {
    const MechanicalEffect::Number& number = effect.numbers[i];
    if (number.is_secondary) continue;
    const double step = number.typical - number.neutral;
    if (number.is_addition)
      for (const double factor : {-0.5, 0.5, 2.5}) add(i, factor * step);
    else if (step == 0)  // searched together with the others: torque and duty of a limit
      add(i, number.is_logarithmic ? std::sqrt(number.low * number.high) : (number.low + 3 * number.high) / 4);
    else if (number.is_logarithmic)
      for (const double factor : {0.5, 2.5})
        add(i, number.neutral == 0 ? now[i] + factor * number.typical : factor * number.typical);
    else
      for (const double factor : {-1.0, 1.0}) add(i, now[i] + factor * step);
  }
  return starts;
}

}  // namespace darwinop::gap
