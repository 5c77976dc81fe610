// The numbers of a case.json and what they are called here: one row each, for reading and for writing.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"
#include "twin/model/number.hpp"

namespace darwinop::gap {

/// A number of the servo.
struct ServoKey {
  std::string_view json;  // "kt_Nm_A", of baseline.params
  std::string_view key;   // "kt", of [servo]; its range is the model file's
  double twin::ServoParameters::*member;
  bool of_voltage_p, of_speed_p;  // the law that needs it
};
std::span<const ServoKey> servoKeys();
[[nodiscard]] twin::NumberRule ruleOf(const ServoKey& key);
/// `servo_datasheet` has the keys of one law alone.
[[nodiscard]] constexpr bool isOfDatasheet(const ServoKey& key) {
  return key.of_voltage_p != key.of_speed_p;
}

/// A baseline's friction is an effect of the model; a value of 0 is none.
struct FrictionKey {
  std::string_view json;           // "coulomb_Nm"
  const twin::EffectInfo* effect;  // it has one parameter
  std::string_view prior;          // "coulomb.friction"
};
/// Of the effects that a baseline may have, in the order of the catalogue.
std::vector<FrictionKey> frictionKeys();

/// What swings. `member` of a log's payload is null; `of_log` is what a log may have of its own instead of `member`.
struct ArmKey {
  std::string_view json;   // "length_m"
  std::string_view prior;  // "length"
  double twin::Pendulum::*member;
  std::optional<double> Trajectory::*of_log;
  twin::NumberRule rule;
};
std::span<const ArmKey> armKeys();

}  // namespace darwinop::gap
