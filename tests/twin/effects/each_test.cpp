// Properties of all effects in the catalogue.
#include <gtest/gtest.h>

#include <cmath>

#include "support/allocation_probe.hpp"
#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

/// Servo state and arm position, as seen by a controller and an external observer.
struct Seen {
  double arm_rad, arm_rad_s, position_rad, speed_rad_s, load, supply_v, temperature_c;
  bool operator==(const Seen&) const = default;
};

/// Saturating steps, a smooth part, a hold under load, a release: 2.6 s that excite every effect.
ServoDrive commandAt(double t) {
  if (t < 0.1) return driveTo(0);
  if (t < 0.8) return driveTo(1);
  if (t < 1.4) return driveTo(-0.6);
  ServoDrive drive = driveTo(-0.6 + 0.5 * (1 - std::cos(12 * (t - 1.4))));
  drive.torque_on = t < 2;
  return drive;
}

std::vector<Seen> run(Bench& bench) {
  std::vector<Seen> seen;
  seen.reserve(2600);
  while (bench.time_s() < 2.6) {
    bench.step(commandAt(bench.time_s()));
    const JointMotion motion = bench.servo().report();
    seen.push_back({bench.position_rad(), bench.velocity_rad_s(), motion.position_rad, motion.velocity_rad_s,
                    motion.load, motion.supply_v, motion.temperature_c});
  }
  return seen;
}

/// A warm servo with friction, so that scaling effects have a base value.
Bench benchWith(Law law, const EffectInfo* tested, const std::vector<double>& values) {
  ServoParameters parameters;
  parameters.law = law;
  parameters.ambient_c = 45;
  Effects effects;
  for (const EffectInfo* info : catalogue()) {
    if (info->id == "coulomb") effects.push_back(info->make(valuesOf(*info, {"coulomb", {{"friction", 0.025}}})));
    if (info->id == "viscous") effects.push_back(info->make(valuesOf(*info, {"viscous", {{"damping", 0.002}}})));
    if (info == tested) effects.push_back(info->make(values));
  }
  return {parameters, std::move(effects), kArm};
}

std::vector<Seen> runWith(Law law, const EffectInfo* tested, const std::vector<double>& values) {
  Bench bench = benchWith(law, tested, values);
  return run(bench);
}

const std::vector<Seen>& runWithout(Law law) {
  static const std::vector<Seen> kVoltage = runWith(Law::kVoltageP, nullptr, {});
  static const std::vector<Seen> kSpeed = runWith(Law::kSpeedP, nullptr, {});
  return law == Law::kVoltageP ? kVoltage : kSpeed;
}

double rmsDifference(const std::vector<Seen>& a, const std::vector<Seen>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(a[i].arm_rad - b[i].arm_rad, 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

class EachEffect : public testing::TestWithParam<const EffectInfo*> {
 protected:
  const EffectInfo& info() const { return *GetParam(); }
  std::vector<double> typical() const { return valuesOf(info(), &Parameter::typical); }
};

TEST_P(EachEffect, ChangesTheMotionAtItsTypicalValues) {
  double most = 0;
  for (const Law law : {Law::kVoltageP, Law::kSpeedP})
    most = std::max(most, rmsDifference(runWith(law, &info(), typical()), runWithout(law)));
  // A tenth of the encoder resolution: less is not observable in any log.
  EXPECT_GT(most, 0.00015) << "rad rms";
  EXPECT_LT(most, 1) << "rad rms: not typical for the servo";
  RecordProperty("mrad_rms", std::to_string(1000 * most));
}

// What has no equation under a law is refused in a model file of that law.
TEST_P(EachEffect, ChangesTheMotionByEachParameterOfTheLaw) {
  for (const Law law : {Law::kVoltageP, Law::kSpeedP})
    for (std::size_t i = 0; i < info().parameters.size(); ++i) {
      const Parameter& parameter = info().parameters[i];
      const Laws missing = law == Law::kVoltageP ? Laws::kReplacesSpeedP : Laws::kVoltageP;
      std::vector<double> low = typical();  // of the others; their neutral values could hide this one
      for (std::size_t k = 0; k < low.size(); ++k)
        if (low[k] == info().parameters[k].neutral) low[k] = info().parameters[k].high;
      std::vector<double> high = low;
      low[i] = parameter.low;
      high[i] = parameter.high;
      const double moved = rmsDifference(runWith(law, &info(), low), runWith(law, &info(), high));
      EXPECT_EQ(moved == 0, lawsOf(info(), parameter) == missing)
          << parameter.key << (law == Law::kVoltageP ? ", voltage_p" : ", speed_p");
    }
}

TEST_P(EachEffect, DoesNothingAtItsNeutralValues) {
  for (const Law law : {Law::kVoltageP, Law::kSpeedP})
    EXPECT_TRUE(runWith(law, &info(), valuesOf(info(), &Parameter::neutral)) == runWithout(law)) << "not bitwise equal";
}

// The neutral value of a secondary parameter must not disable the effect in a first search.
TEST_P(EachEffect, StillActsWhenOnlyItsFirstParametersAreTypical) {
  std::vector<double> values = valuesOf(info(), &Parameter::neutral);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!info().parameters[i].secondary) values[i] = info().parameters[i].typical;
  if (std::ranges::all_of(info().parameters, &Parameter::secondary)) return;  // a switch: on or off, nothing between
  double most = 0;
  for (const Law law : {Law::kVoltageP, Law::kSpeedP})
    most = std::max(most, rmsDifference(runWith(law, &info(), values), runWithout(law)));
  EXPECT_GT(most, 0.00015);
}

TEST_P(EachEffect, ClearsAllHistoryOnReset) {
  for (const Law law : {Law::kVoltageP, Law::kSpeedP}) {
    Bench bench = benchWith(law, &info(), typical());
    const std::vector<Seen> first = run(bench);
    bench.reset({});
    EXPECT_TRUE(run(bench) == first) << "the second run differs from the first";
  }
}

TEST_P(EachEffect, KeepsTheArmInBoundsAtTheEndsOfItsRanges) {
  for (std::size_t i = 0; i < info().parameters.size(); ++i) {
    for (const double end : {info().parameters[i].low, info().parameters[i].high}) {
      std::vector<double> values = typical();
      values[i] = end;
      for (const Law law : {Law::kVoltageP, Law::kSpeedP}) {
        const std::vector<Seen> seen = runWith(law, &info(), values);
        // Goals are within 1 rad and the servo has twice the required torque: the arm does not turn over.
        EXPECT_TRUE(std::ranges::all_of(seen, [](const Seen& now) { return std::abs(now.arm_rad) < 3; }))
            << info().parameters[i].key << " = " << end;
      }
    }
  }
}

TEST_P(EachEffect, AllocatesNothingWhileItRuns) {
  Bench bench = benchWith(Law::kVoltageP, &info(), typical());
  const long before = allocationsOfThisThread();
  while (bench.time_s() < 0.5) bench.step(commandAt(bench.time_s()));
  EXPECT_EQ(allocationsOfThisThread(), before);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EachEffect, testing::ValuesIn(catalogue().begin(), catalogue().end()),
                         [](const auto& row) { return std::string{row.param->id}; });

}  // namespace
}  // namespace darwinop::twin
