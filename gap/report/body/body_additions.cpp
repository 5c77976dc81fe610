#include "gap/report/body/body_additions.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gap/report/messages.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;
using Axes3 = std::array<double, 3>;

/// What a person can read; the intervals are wider by far.
double sixDigits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double scale = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

const json& resultOf(const json& all, const std::string& name) {
  if (all.is_object() && all.at("case") == name) return all;
  if (all.is_object()) throw std::runtime_error("is of case " + all.at("case").get<std::string>() + ", not of " + name);
  for (const json& one : all)
    if (one.value("case", "") == name) return one;
  throw std::runtime_error("has no result of case " + name);
}

/// "AnkleR", a list of such, or "all"; empty: all.
std::vector<Joint> jointsOf(const json& places) {
  std::vector<Joint> joints;
  if (places == "all") return joints;
  const json list = places.is_array() ? places : json::array({places});
  for (const json& name : list) {
    const auto joint = findJoint(name.get<std::string>());
    if (!joint) throw std::runtime_error("there is no joint " + name.dump());
    joints.push_back(*joint);
  }
  return joints;
}

AddedEffect servoEffect(const json& from, const std::string& because) {
  AddedEffect effect{.id = from.at("id"), .values = {}, .because = {because}, .joints = jointsOf(from.at("at"))};
  const json intervals = from.value("interval_90", json::object());
  for (const auto& [key, value] : from.at("params").items()) {
    AddedValue added{key, sixDigits(value.get<double>()), std::nan(""), std::nan("")};
    if (intervals.contains(key) && intervals[key].size() == 2 && intervals[key][0].is_number())
      added.low = intervals[key][0], added.high = intervals[key][1];
    effect.values.push_back(added);
  }
  return effect;
}

/// A deviation of the inertial sensor, and the key of [imu] that has it. What is found is on top of the model's own.
struct SensorKey {
  std::string_view id, parameter, key;
  Axes3 twin::ImuSettings::*there;
  enum class Joins : std::uint8_t { kAdds, kScales, kReplaces } joins;
};
constexpr std::array kSensorKeys{
    SensorKey{"gyro_bias", "bias", "gyro_bias", &twin::ImuSettings::gyro_bias_rad_s, SensorKey::Joins::kAdds},
    SensorKey{"accel_bias", "bias", "accel_bias", &twin::ImuSettings::accel_bias_m_s2, SensorKey::Joins::kAdds},
    SensorKey{"gyro_scale", "scale", "gyro_scale", &twin::ImuSettings::gyro_scale, SensorKey::Joins::kScales},
    SensorKey{"accel_scale", "scale", "accel_scale", &twin::ImuSettings::accel_scale, SensorKey::Joins::kScales},
    SensorKey{"imu_mounting", "rotation", "mounting", &twin::ImuSettings::mounting_rad, SensorKey::Joins::kReplaces},
    SensorKey{"accel_axes", "map", "accel_axes", &twin::ImuSettings::accel_axes, SensorKey::Joins::kReplaces}};

/// A number that replaces the model's.
struct NumberKey {
  std::string_view id, parameter, section, key;
};
constexpr std::array kNumberKeys{NumberKey{"floor_friction", "friction", "body", "floor_friction"},
                                 NumberKey{"contact_time", "time", "body", "contact_time"},
                                 NumberKey{"gyro_range", "range", "imu", "gyro_range"}};

void addSensor(const SensorKey& row, const json& from, const twin::Model& model, BodyAdditions& into) {
  const Axes3 found = from.at("params").at(std::string{row.parameter}).get<Axes3>(), was = model.imu.*row.there,
              usual = twin::ImuSettings{}.*row.there;
  if (row.joins == SensorKey::Joins::kReplaces && was != usual) {
    into.left_out.push_back(std::string{row.id} + ": [imu] " + std::string{row.key} +
                            " of the model is set already; combine the two by hand");
    return;
  }
  Axes3 now = found;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (row.joins == SensorKey::Joins::kAdds) now[i] += was[i];
    if (row.joins == SensorKey::Joins::kScales) now[i] *= was[i];
    now[i] = sixDigits(now[i]);
  }
  into.additions.imu.push_back({std::string{row.key}, now});
}

}  // namespace

BodyAdditions bodyAdditionsIn(std::string_view results, const std::string& file, const std::string& name,
                              const twin::Model& model) {
  try {
    const json all = json::parse(results);
    const json& result = resultOf(all, name);
    if (result.at("effects").empty())
      throw std::runtime_error("has the verdict " + result.at("verdict").get<std::string>() + ", which " +
                               messages::kNamesNoEffect + ": there is nothing to add");
    const std::string because =
        "Found by darwinop gap in case " + name + ", verdict " + result.at("verdict").get<std::string>();
    BodyAdditions out;
    for (const json& effect : result.at("effects")) {
      const std::string id = effect.at("id");
      const auto* const sensor = std::ranges::find(kSensorKeys, id, &SensorKey::id);
      if (sensor != kSensorKeys.end())
        addSensor(*sensor, effect, model, out);
      else if (const auto* const number = std::ranges::find(kNumberKeys, id, &NumberKey::id);
               number != kNumberKeys.end())
        out.additions.numbers.push_back(
            {.key = std::string{number->key},
             .value = sixDigits(effect.at("params").at(std::string{number->parameter}).get<double>()),
             .section = std::string{number->section}});
      else if (twin::findEffect(id) != nullptr)
        out.additions.effects.push_back(servoEffect(effect, because));
      else
        out.left_out.push_back(id + " at " + effect.at("at").dump() + ": a model file has no key for it" +
                               (id.starts_with("link_") ? "; change that link in the body's XML" : ""));
    }
    return out;
  } catch (const json::exception& error) {
    throw std::runtime_error(file + ": " + messages::kNotAResult + " (" + error.what() +
                             "); `darwinop gap run` writes report.json");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

}  // namespace darwinop::gap
