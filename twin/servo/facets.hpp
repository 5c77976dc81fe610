// Facets of an effect: what identification, synthetic cases and exports use beside its equation. They stand in the
// effect's own file, so that no other file needs its id.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace darwinop::twin {

/// What a parameter is, where other code reads it, whatever the effect. Most parameters have none.
enum class ParameterRole : std::uint8_t {
  kNone,
  kGoalDelay,         // s
  kGoalFactor,        // of the commanded angle
  kGainFactor,        // of the duty per error
  kEncoderTicks,      // a turn
  kSupplyResistance,  // ohm, of battery and cables
  kDryFriction,       // N m
  kViscousFriction,   // N m s/rad
  kLoadMass,          // relative change: of all that a bench carries, in the body of the link alone
  kLoadShift,         // m, outwards, of the same
  kRippleTorque,      // N m, amplitude of a ripple over the angle; count a turn and phase are the next two parameters
};

/// How an estimate of a parameter is compared with the truth.
enum class ErrorScale : std::uint8_t {
  kRelative,  // error over value
  kFromOne,   // a factor: error over distance from 1
  kNone,      // a phase or a seed
};

/// Control laws of a baseline under which an effect can act.
enum class Laws : std::uint8_t {
  kBoth,
  kVoltageP,        // needs the motor equation: duty, winding, supply
  kReplacesSpeedP,  // turns speed_p into voltage_p; its first parameter is the switch, 1: on
};

enum class Visibility : std::uint8_t {
  kAtHost,
  kFirmwareOnly,  // a host that reads every 16 ms cannot distinguish it from noise
};

enum class Prevalence : std::uint8_t {
  kCommon,  // every servo has some of it
  kRare,
};

/// What a simulation with large steps has to do for the effect.
enum class StepDemand : std::uint8_t {
  kNone,
  kSoftGear,     // more mechanical steps a period, for a spring or a gap between motor and arm
  kEveryPeriod,  // every firmware period by itself: feedback that rings when periods are merged
};

/// Properties of logs that make an effect observable, or distinguish it from others; gap/case/reveals.cpp has the
/// criteria.
enum class LogFeature : std::uint8_t {
  kLoadColumn,
  kVoltageColumn,
  kTorqueOff,
  kPayloads,
  kGains,
  kSlowMotion,
  kFastMotion,
  kSaturation,
  kBothSides,
  kTemperature,
  kLongSession,
  kHostRate,
};

/// A number of the baseline that the effect may stand for, by its name in the priors of a case.
struct BaselineAlias {
  enum class Relation : std::uint8_t {
    kOwnValue,        // the baseline may have the effect: "coulomb.friction" is its parameter
    kFactor,          // number * value
    kRelativeChange,  // number * (1 + value)
    kAdded,           // number + value
  };
  std::string_view number;  // "kt", "payload"
  Relation relation;
  std::size_t parameter = 0;       // index; of kOwnValue: 0
  std::string_view case_key = {};  // of kOwnValue: its name in baseline.params of a case.json
  std::string_view with = {};      // another number of the baseline, which the effect scales alike

  /// `base` is the number without the effect, the result that with it. Not of kOwnValue.
  [[nodiscard]] constexpr double together(double base, double value) const {
    if (relation == Relation::kFactor) return base * value;
    if (relation == Relation::kRelativeChange) return base * (1 + value);
    return base + value;
  }
  /// The effect's value with which `base` becomes `wanted`. Not of kOwnValue.
  [[nodiscard]] constexpr double valueBetween(double base, double wanted) const {
    if (relation == Relation::kFactor) return wanted / base;
    if (relation == Relation::kRelativeChange) return wanted / base - 1;
    return wanted - base;
  }
};

/// A parameter that a synthetic case draws at random.
struct DrawnParameter {
  std::size_t parameter;  // index
  double low, high;
  std::span<const double> choices = {};  // if any: one of these instead
};

/// How synthetic cases hide the effect.
struct Synthetic {
  enum class Growth : std::uint8_t {
    kFirst,           // the first parameter grows with the severity
    kFirstAndSecond,  // the second as well, at a random ratio
    kFirstOrSecond,   // one of the two at random: together they cancel
    kSwitch,          // none: the first parameter is at its typical value
  };
  Growth growth = Growth::kFirst;
  std::span<const DrawnParameter> drawn = {};
  int most_severe = 3;  // of the severities 1 to 3: what the plausible range can open
  int pair_rank =
      0;  // place in the list that cases with two effects draw from, so that a seed keeps its suite; 0: none
};

/// What becomes of an effect in a simulator's file format.
enum class Fate : std::uint8_t { kHeld, kApproximated, kLost };
struct Holding {
  Fate fate;
  std::string_view how;  // "frictionloss"; for what is lost: why, and what to do
};
constexpr Holding held(std::string_view how) {
  return {Fate::kHeld, how};
}
constexpr Holding approximated(std::string_view how) {
  return {Fate::kApproximated, how};
}
constexpr Holding lost(std::string_view why) {
  return {Fate::kLost, why};
}
struct Exports {
  Holding webots, mujoco, urdf;
};
constexpr Exports inAllFormats(Holding one) {
  return {one, one, one};
}

/// Reasons that several effects share.
namespace exports {
inline constexpr std::string_view kInTheBody = "in the body: mass and centre of mass of the link";
inline constexpr std::string_view kInTheLink = "inertia of the link, which then also resists other joints";
inline constexpr std::string_view kNoController =
    "the format has no controller; set it in the program that reads the file";
inline constexpr std::string_view kNoFrictionOfLoad = "its dry friction does not depend on the load";
inline constexpr std::string_view kSpeedMotor = "its P sets a speed, so a loaded joint always arrives";
}  // namespace exports

/// A parameter's name in the answer keys of other suites.
struct OtherName {
  std::string_view name, key;
  double zero = 0;  // of the other scale: 1 where it is a factor and ours is a change
};

}  // namespace darwinop::twin
