// An effect: something real servos do and an ideal one does not. One file in twin/effects/ holds all of one effect;
// simulation, naming, documentation and exports read it there.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "twin/servo/signals.hpp"

namespace darwinop::twin {

/// Where in the loop an effect acts; also the block in which its traces are looked for.
enum class Place : std::uint8_t { kCommand, kController, kSupply, kMotor, kFriction, kTransmission, kLoad, kSensor };
std::string_view name(Place place);

struct Parameter {
  std::string_view key;      // in the model file: "friction"
  std::string_view unit;     // "N m"; empty: a pure number, written without unit
  std::string_view meaning;  // "torque that holds a resting joint"
  double low, high;          // plausible range; outside it a model file is refused; both finite
  double neutral;            // without effect at this value (given the others' neutral values)
  double typical;            // of this servo family; where a search starts
  bool logarithmic = false;  // a scale parameter: searched in its logarithm
  bool secondary = false;    // refines the effect: a first search leaves it at its typical value
};

class Effect;

struct EffectInfo {
  std::string_view id;     // "coulomb": section [effect coulomb] of a model file
  std::string_view title;  // "dry friction"
  Place place;
  std::string_view equation;                        // in the symbols of docs/twin/effects.md
  std::string_view signature;                       // what it looks like in logs
  std::string_view separated_by;                    // the experiment that tells it from its doubles
  std::string_view source;                          // where equation and range come from
  std::span<const std::string_view> confused_with;  // ids
  std::span<const Parameter> parameters;
  /// `values`: one per parameter, in their order.
  std::unique_ptr<Effect> (*make)(std::span<const double> values);
};

/// One effect at work in one servo. Hooks run in this order, each for all effects in the order of the catalogue;
/// an effect implements those it needs and lists them in hooks(). They neither allocate nor throw.
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

  /// Forgets all history. `now` is the state at rest from which a run starts.
  virtual void reset(const Signals& /*now*/) noexcept {}
  /// Every firmware period: goal_rad and the profile limits have come in and may be changed.
  virtual void command(Signals&, double /*dt_s*/) noexcept {}
  /// Every firmware period: measured_rad holds the true position and becomes what the encoder says.
  virtual void sensor(Signals&, double /*dt_s*/) noexcept {}
  /// Every firmware period: error, gains, offset and limit are set, the duty is not yet made.
  virtual void controller(Signals&, double /*dt_s*/) noexcept {}
  /// Every firmware period, the duty is made: supply, kt, resistance, back EMF, torque limit.
  virtual void motor(Signals&, double /*dt_s*/) noexcept {}
  /// Every mechanical step, at the present position, velocity and torques, or those that a bench foresees in the middle
  /// of the step: adds friction, damping, extra torque, and sets the gear train's play and spring.
  virtual void mechanics(Signals&) noexcept {}
  /// Once before a run.
  virtual void load(LoadChange&) noexcept {}
};

/// What the effect `kInfo` of N parameters is made from. Derive, give hooks, and use the values in the order of their
/// table: `const auto& [friction] = values_;`.
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
