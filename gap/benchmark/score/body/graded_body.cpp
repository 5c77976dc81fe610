#include "gap/benchmark/score/body/graded_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/text/joined.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kLargestSet = 3;  // names that an honest ambiguity may have
constexpr std::array<std::string_view, 11> kOfSensors{"gyro_bias",    "gyro_scale", "gyro_lowpass", "gyro_range",
                                                      "gyro_axes",    "accel_axes", "accel_bias",   "accel_scale",
                                                      "imu_mounting", "imu_delay",  "imu_axes"};
constexpr std::array<std::string_view, 3> kOfMass{"link_mass", "link_com", "com_mass"};
constexpr std::array<std::string_view, 4> kOfContact{"floor_friction", "contact_time", "floor_tilt", "sole_size"};
constexpr std::string_view kScale = "scale";  // parameter that is 1 where nothing is wrong; others are 0
constexpr std::array<std::string_view, 2> kOfBus{"battery_resistance", "bus_latency"};

template <class List>
bool has(const List& list, std::string_view id) {
  return std::ranges::find(list, id) != list.end();
}

std::string nameOf(const std::string& id, const std::vector<std::string>& at) {
  return id + (at.empty() ? "" : " " + text::joined(at, "+"));
}

template <class List>
std::string namesOf(const List& effects, std::string_view between) {
  std::vector<std::string> names;
  for (const auto& effect : effects) names.push_back(nameOf(effect.id, effect.at));
  return text::joined(names, between);
}

PlacedName nameOf(const BodyKeyEffect& effect) {
  return {effect.id, effect.at};
}

/// The number of the answer by the key's name: friction counts as added or as total.
const std::vector<double>* numberOf(const BodyKeyEffect& effect, std::string name) {
  for (const std::string_view ending : {"_added", "_total"})
    if (name.ends_with(ending)) name.erase(name.size() - ending.size());
  const auto found = effect.values.find(name);
  return found == effect.values.end() ? nullptr : &found->second;
}

/// The share is one of what is hidden, which is the distance from `neutral`.
bool isWithin(const std::vector<double>& truth, const std::vector<double>& answer, double neutral, double share,
              double absolute) {
  if (truth.size() != answer.size()) return false;
  double size = 0;
  for (const double value : truth) size = std::max(size, std::abs(value - neutral));
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (!(std::abs(answer[i] - truth[i]) <= std::max(share * size, absolute))) return false;
  return true;
}

}  // namespace

bool isSameEffect(const BodyKeyEffect& hidden, const PlacedName& name) {
  if (hidden.id == name.id) return true;
  const auto is_bus = [](const std::string& id, const std::vector<std::string>& at) {
    return id == "bus_latency" || (id == "transport_delay" && at == std::vector<std::string>{"all"});
  };
  return is_bus(hidden.id, hidden.at) && is_bus(name.id, name.at);
}

bool isSamePlace(const BodyKeyEffect& hidden, const PlacedName& name) {
  if (hidden.id == "bus_latency" || hidden.id == "battery_resistance") return true;
  std::vector<std::string> a = hidden.at, b = name.at;
  std::ranges::sort(a), std::ranges::sort(b);
  return a == b;
}

BodyKind GradedBody::kind() const {
  if (key.is_outside) return BodyKind::kOutside;
  if (key.effects.empty()) return key.is_exact ? BodyKind::kExact : BodyKind::kWrong;
  if (key.effects.size() > 1) return BodyKind::kTwo;
  const BodyKeyEffect& effect = key.effects.front();
  if (has(kOfSensors, effect.id)) return BodyKind::kSensor;
  if (has(kOfMass, effect.id)) return BodyKind::kMass;
  if (has(kOfContact, effect.id)) return BodyKind::kContact;
  if (has(kOfBus, effect.id)) return BodyKind::kBus;
  return effect.at.size() == 1 && effect.at.front() != "all" ? BodyKind::kOneJoint : BodyKind::kManyJoints;
}

bool GradedBody::names(const BodyKeyEffect& hidden) const {
  return answer != nullptr && std::ranges::any_of(answer->effects, [&](const BodyKeyEffect& one) {
           return isSameEffect(hidden, nameOf(one));
         });
}

bool GradedBody::namesInPlace(const BodyKeyEffect& hidden) const {
  return answer != nullptr && std::ranges::any_of(answer->effects, [&](const BodyKeyEffect& one) {
           return isSameEffect(hidden, nameOf(one)) && isSamePlace(hidden, nameOf(one));
         });
}

bool GradedBody::namesOrDoubts(const BodyKeyEffect& hidden) const {
  if (namesInPlace(hidden)) return true;
  return answer != nullptr && std::ranges::any_of(answer->ambiguity, [&](const std::vector<PlacedName>& set) {
           return set.size() <= kLargestSet && std::ranges::any_of(set, [&](const PlacedName& one) {
                    return isSameEffect(hidden, one) && isSamePlace(hidden, one);
                  });
         });
}

bool GradedBody::placeRight(const BodyKeyEffect& hidden) const {
  return answer != nullptr && std::ranges::any_of(answer->effects, [&](const BodyKeyEffect& one) {
           return isSamePlace(hidden, nameOf(one));
         });
}

bool GradedBody::numbersWithin(const BodyKeyEffect& hidden, double share, double absolute) const {
  if (answer == nullptr) return false;
  for (const BodyKeyEffect& one : answer->effects) {
    if (!isSameEffect(hidden, nameOf(one)) || !isSamePlace(hidden, nameOf(one))) continue;
    std::map<std::string, bool> right;  // by the answer's name: one of its forms is
    for (const auto& [name, truth] : hidden.values)
      if (const std::vector<double>* const value = numberOf(one, name))
        right[name.substr(0, name.rfind('_'))] |= isWithin(truth, *value, name == kScale ? 1 : 0, share, absolute);
    return std::ranges::all_of(right, [](const auto& form) { return form.second; });
  }
  return false;
}

bool GradedBody::firstRight() const {
  return answer != nullptr && !answer->effects.empty() &&
         std::ranges::any_of(key.effects, [&](const BodyKeyEffect& hidden) {
           const PlacedName first = nameOf(answer->effects.front());
           return isSameEffect(hidden, first) && isSamePlace(hidden, first);
         });
}

bool GradedBody::alarm() const {
  return answer == nullptr || (answer->verdict != "none" && answer->verdict != "cannot_tell");
}

bool GradedBody::whereRight() const {
  if (answer == nullptr) return false;
  return std::ranges::any_of(key.where, [&](const std::string& place) {
    return std::ranges::any_of(answer->where, [&](const std::string& signal) {
      const bool is_of_trunk = signal.starts_with("gyro") || signal.starts_with("accelerometer");
      return place == "Body" ? is_of_trunk : signal.starts_with(place + ".");
    });
  });
}

bool GradedBody::right() const {
  if (key.is_outside) return answer != nullptr && answer->effects.empty();
  if (key.effects.empty()) return !alarm();
  return answer != nullptr && answer->effects.size() == key.effects.size() &&
         std::ranges::all_of(key.effects, [&](const BodyKeyEffect& hidden) { return namesOrDoubts(hidden); });
}

std::string GradedBody::truth() const {
  return key.effects.empty() ? "nothing" : namesOf(key.effects, " and ");
}

std::string GradedBody::answered() const {
  if (answer == nullptr) return "no answer in time";
  if (answer->verdict == "none") return "nothing";
  if (answer->verdict == "ambiguous" && !answer->ambiguity.empty())
    return "ambiguous: " + namesOf(answer->ambiguity.front(), " or ");
  return answer->effects.empty() ? answer->verdict : namesOf(answer->effects, " and ");
}

}  // namespace darwinop::gap
