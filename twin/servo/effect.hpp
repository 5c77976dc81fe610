// Effect: a deviation of a real servo from the ideal one. One file in twin/effects defines an effect for simulation,
// identification, documentation and export.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "twin/servo/facets.hpp"
#include "twin/servo/signals.hpp"

namespace darwinop::twin {

/// Block of the control loop in which an effect acts, and in which `darwinop gap` looks for it.
enum class LoopPart : std::uint8_t { kCommand, kController, kSupply, kMotor, kFriction, kTransmission, kLoad, kSensor };
std::string_view name(LoopPart part);

struct Parameter {
  std::string_view key;      // in the model file: "friction"
  std::string_view unit;     // "N m"; empty: dimensionless
  std::string_view meaning;  // "torque that holds a resting joint"
  double low, high;          // allowed range in a model file, finite
  double neutral;            // no effect at this value (with all other parameters neutral)
  double typical;            // of this servo family; start value of a search
  bool logarithmic = false;  // scale parameter: searched in its logarithm
  bool secondary = false;    // refinement: held at its typical value in a first search
  bool fixed = false;        // never free in a fit: a switch, a seed, or what another parameter says as well
  ParameterRole role = ParameterRole::kNone;
  ErrorScale error_scale = ErrorScale::kRelative;
  Laws laws = Laws::kBoth;  // fewer than the effect's: under which this parameter has an equation
};

class Effect;

template <template <class> class Field>
struct EffectFields {
  Field<std::string_view> id;     // "coulomb": section [effect coulomb] of a model file
  Field<std::string_view> title;  // "dry friction"
  Field<LoopPart> part;
  Field<std::string_view> equation;                        // symbols: docs/twin/effects.md
  Field<std::string_view> signature;                       // appearance in logs
  Field<std::string_view> separated_by;                    // experiment that distinguishes it from confounded effects
  Field<std::string_view> source;                          // of equation and range
  Field<std::span<const std::string_view>> confused_with;  // ids
  Field<std::span<const Parameter>> parameters;
  Field<Laws> laws;
  Field<Visibility> visibility;
  Field<std::span<const LogFeature>> revealed_by;
  Field<Prevalence> prevalence;
  Field<std::span<const BaselineAlias>> aliases;
  Field<StepDemand> step_demand;
  Field<Synthetic> synthetic;
  Field<Exports> exports;
  Field<std::span<const OtherName>> other_names;
  /// `values`: one per parameter, in their order.
  Field<std::unique_ptr<Effect> (*)(std::span<const double> values)> make;
};

/// A reference must be initialised: an effect without one of the fields does not compile.
template <class T>
using Required = const T&;
using EffectRow = EffectFields<Required>;

constexpr EffectFields<std::type_identity_t> copied(const EffectRow& row) {
  const auto& [id, title, part, equation, signature, separated_by, source, confused_with, parameters, laws, visibility,
               revealed_by, prevalence, aliases, step_demand, synthetic, exports, other_names, make] = row;
  return {id,         title,       part,       equation,    signature,  separated_by, source,      confused_with,
          parameters, laws,        visibility, revealed_by, prevalence, aliases,      step_demand, synthetic,
          exports,    other_names, make};
}

/// `const EffectInfo kCoulomb{{.id = "coulomb", ...}};`
struct EffectInfo : EffectFields<std::type_identity_t> {
  constexpr explicit EffectInfo(const EffectRow& row) : EffectFields{copied(row)} {}
};

/// Index of the parameter that has this role; nothing if the effect has none.
constexpr std::optional<std::size_t> indexOf(const EffectInfo& effect, ParameterRole role) {
  for (std::size_t i = 0; i < effect.parameters.size(); ++i)
    if (effect.parameters[i].role == role) return i;
  return std::nullopt;
}

constexpr Laws lawsOf(const EffectInfo& effect, const Parameter& parameter) {
  return parameter.laws == Laws::kBoth ? effect.laws : parameter.laws;
}

/// With these values the effect turns law speed_p into voltage_p.
inline bool replacesLaw(const EffectInfo& effect, std::span<const double> values) {
  return effect.laws == Laws::kReplacesSpeedP && values[0] >= 0.5;
}

/// An effect in one servo. Hooks run in the order below, each for all effects in catalogue order; an effect implements
/// the hooks that it lists in hooks(). They neither allocate nor throw.
class Effect {
 public:
  enum Hook : std::uint8_t {
    kCommandHook = 1,
    kSensorHook = 2,
    kControllerHook = 4,
    kMotorHook = 8,
    kMechanicsHook = 16,
    kLoadHook = 32,
  };

  virtual ~Effect() = default;
  [[nodiscard]] virtual const EffectInfo& info() const noexcept = 0;
  [[nodiscard]] virtual std::uint8_t hooks() const noexcept = 0;

  /// Clears all history. `now` is the initial state, at rest.
  virtual void reset(const Signals& /*now*/) noexcept {}
  /// Every firmware period: may change goal_rad and the profile limits.
  virtual void command(Signals&, double /*dt_s*/) noexcept {}
  /// Every firmware period: changes measured_rad from the true position to the encoder reading.
  virtual void sensor(Signals&, double /*dt_s*/) noexcept {}
  /// Every firmware period, before the duty is computed: may change error, gains, offset and limit.
  virtual void controller(Signals&, double /*dt_s*/) noexcept {}
  /// Every firmware period, after the duty is computed: may change supply, kt, resistance, back EMF, torque limit.
  virtual void motor(Signals&, double /*dt_s*/) noexcept {}
  /// Every mechanical step, at the present position, velocity and torques (or their mid-step predictions): adds
  /// friction, damping and extra torque, and sets play and spring of the transmission.
  virtual void mechanics(Signals&) noexcept {}
  /// Once before a run.
  virtual void load(LoadChange&) noexcept {}
};

/// Base class of the effect `kInfo` with N parameters. `values_` are in the order of the parameter table:
/// `const auto& [friction] = values_;`.
template <const EffectInfo& kInfo, std::size_t N>
class EffectOf : public Effect {
 public:
  explicit EffectOf(std::span<const double> values) {
    for (std::size_t i = 0; i < N; ++i) values_[i] = values[i];
  }
  [[nodiscard]] const EffectInfo& info() const noexcept override { return kInfo; }

 protected:
  std::array<double, N> values_{};
};

/// For EffectInfo::make.
template <class E>
std::unique_ptr<Effect> makeEffect(std::span<const double> values) {
  return std::make_unique<E>(values);
}

}  // namespace darwinop::twin
