#include "gap/benchmark/score/parameter_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

struct OtherName {
  std::string_view effect, name, key;
  double zero = 0;
};
constexpr auto kOtherNames = std::to_array<OtherName>({
    {"accel_limit", "a_lim", "accel"},
    {"speed_limit", "v_lim", "speed"},
    {"torque_limit", "dmax", "duty"},
    {"torque_limit", "duty_max", "duty"},
    {"torque_limit", "u_max", "duty"},
    {"torque_limit", "T", "torque"},
    {"torque_limit", "T_lim", "torque"},
    {"torque_limit", "tau_max", "torque"},
    {"coulomb", "Fc", "friction"},  // of all dry friction, the baseline's too, as ours
    {"viscous", "kv", "damping"},
    {"stribeck", "Fs", "friction"},
    {"stribeck", "ws", "speed"},
    {"stribeck", "a", "exponent"},
    {"load_dependent_friction", "Kl", "share"},
    {"load_dependent_friction", "kl", "share"},
    {"load_dependent_friction", "K_load", "share"},
    {"directional_load_friction", "Km", "motor"},
    {"directional_load_friction", "Ke", "load"},
    {"directional_load_friction", "K_motor", "motor"},
    {"directional_load_friction", "K_ext", "load"},
    {"quadratic_load_friction", "Kq", "motor"},
    {"quadratic_load_friction", "K", "motor"},
    {"backlash", "backlash", "play"},
    {"backlash", "b", "play"},
    {"deadband", "deadband", "width"},
    {"deadband", "d", "width"},
    {"deadband", "u0", "punch"},
    {"supply_sag", "Rs", "resistance"},
    {"transport_delay", "d", "delay"},
    {"encoder_offset", "zero_off", "offset"},
    {"encoder_offset", "o", "offset"},
    {"gear_scale", "gear_scale", "scale"},
    {"gear_scale", "s", "scale"},
    {"kp_scale", "kp_fac", "scale"},
    {"com_mass", "m_fac", "mass", 1},
    {"com_mass", "com_shift", "shift"},
    {"joint_flex", "flex_k", "stiffness"},
    {"joint_flex", "k", "stiffness"},
    {"joint_flex", "flex_c", "damping"},
    {"joint_flex", "c", "damping"},
    {"temp_drift", "temp_beta", "rate"},
    {"temp_drift", "b", "rate"},
    {"cogging", "cog_A", "amplitude"},
    {"cogging", "cog_N", "count"},
    {"cogging", "cog_phi", "phase"},
    {"kt_error", "kt_fac", "change", 1},
    {"resistance_error", "R_fac", "change", 1},
});

/// "friction_Nm": the key, and a unit.
bool isWithUnit(std::string_view name, std::string_view word) {
  return name == word || (name.starts_with(word) && name.substr(word.size()).starts_with('_'));
}

}  // namespace

std::optional<NamedParameter> parameterOf(std::string_view effect, std::string_view name) {
  const twin::EffectInfo* const info = twin::findEffect(effect);
  if (info == nullptr || name.empty()) return std::nullopt;
  if (name.starts_with(effect) && name.substr(effect.size()).starts_with('.')) name.remove_prefix(effect.size() + 1);
  for (const OtherName& other : kOtherNames)
    if (other.effect == effect && other.name == name) return NamedParameter{other.key, other.zero};
  // The longest key first: slow_motor before slow.
  const twin::Parameter* found = nullptr;
  for (const twin::Parameter& parameter : info->parameters)
    if (isWithUnit(name, parameter.key) && (found == nullptr || parameter.key.size() > found->key.size()))
      found = &parameter;
  if (found != nullptr) return NamedParameter{found->key};
  // "coulomb_Nm": the effect's own name stands for its first parameter.
  if (isWithUnit(name, effect)) return NamedParameter{info->parameters[0].key};
  return std::nullopt;
}

std::map<std::string, double> inCatalogueNames(std::string_view effect, const std::map<std::string, double>& values) {
  std::map<std::string, double> out;
  for (const auto& [name, value] : values)
    if (const auto parameter = parameterOf(effect, name)) out[std::string{parameter->key}] = value - parameter->zero;
  return out;
}

std::optional<double> relativeError(std::string_view effect, std::string_view key, double told, double truth) {
  if (key == "phase" || key == "seed") return std::nullopt;
  const double one = effect == "gear_scale" || effect == "kp_scale" ? 1 : 0;
  if (truth == one) return std::nullopt;
  return std::abs((told - truth) / (truth - one));
}

}  // namespace darwinop::gap
