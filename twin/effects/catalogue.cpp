// Table of all effects, in the order in which they act.
#include "twin/effects/catalogue.hpp"

#include <algorithm>
#include <array>

namespace darwinop::twin {

extern const EffectInfo kLostPackets, kTransportDelay, kGearScale, kSpeedLimit, kAccelLimit;
extern const EffectInfo kEncoderQuantisation, kPOnTorque, kDeadband, kKpScale, kIntegral, kDerivative, kTorqueLimit;
extern const EffectInfo kCoulomb, kViscous, kStribeck, kLoadDependentFriction, kDirectionalLoadFriction,
    kQuadraticLoadFriction, kTempDrift;
extern const EffectInfo kKtError, kResistanceError, kSupplySag, kCogging;
extern const EffectInfo kBacklash, kJointFlex, kComMass, kInertia, kEncoderOffset;

namespace {

std::vector<const EffectInfo*> allEffects() {
  constexpr std::array kTable{
      // command
      &kLostPackets,
      &kTransportDelay,
      &kGearScale,
      &kSpeedLimit,
      &kAccelLimit,
      // sensor and controller
      &kEncoderQuantisation,
      &kPOnTorque,
      &kDeadband,
      &kKpScale,
      &kIntegral,
      &kDerivative,
      &kTorqueLimit,
      // friction; temp_drift scales the friction accumulated above it
      &kCoulomb,
      &kViscous,
      &kStribeck,
      &kLoadDependentFriction,
      &kDirectionalLoadFriction,
      &kQuadraticLoadFriction,
      &kTempDrift,
      // motor, then supply, which depends on the motor
      &kKtError,
      &kResistanceError,
      &kSupplySag,
      &kCogging,
      // transmission and load
      &kBacklash,
      &kJointFlex,
      &kComMass,
      &kInertia,
      &kEncoderOffset,
  };
  std::vector<const EffectInfo*> all{kTable.begin(), kTable.end()};
  all.insert(all.end(), addedEffects().begin(), addedEffects().end());
  return all;
}

}  // namespace

[[gnu::weak]] std::span<const EffectInfo* const> addedEffects() {
  return {};
}

std::span<const EffectInfo* const> catalogue() {
  static const std::vector<const EffectInfo*> kAll = allEffects();
  return kAll;
}

const EffectInfo* findEffect(std::string_view id) {
  const auto table = catalogue();
  const auto found = std::ranges::find(table, id, &EffectInfo::id);
  return found == table.end() ? nullptr : *found;
}

const EffectInfo* effectWith(ParameterRole role) {
  const auto table = catalogue();
  const auto found = std::ranges::find_if(table, [&](const EffectInfo* one) { return indexOf(*one, role) == 0; });
  return found == table.end() ? nullptr : *found;
}

std::vector<const EffectInfo*> doublesOf(const EffectInfo& effect) {
  const auto lists = [](const EffectInfo& a, const EffectInfo& b) {
    return std::ranges::find(a.confused_with, b.id) != a.confused_with.end();
  };
  std::vector<const EffectInfo*> found;
  for (const EffectInfo* other : catalogue())
    if (lists(effect, *other) || lists(*other, effect)) found.push_back(other);
  return found;
}

}  // namespace darwinop::twin
