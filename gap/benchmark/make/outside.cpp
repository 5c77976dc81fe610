#include "gap/benchmark/make/outside.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gap/plant/bench/internal_effect.hpp"

namespace darwinop::gap {
namespace {

using Values = std::span<const double>;

const twin::EffectInfo kOutsideInfo =
    internalEffect("outside", "something that no catalogue has", twin::LoopPart::kLoad);

class Outside : public twin::Effect {
 public:
  [[nodiscard]] const twin::EffectInfo& info() const noexcept override { return kOutsideInfo; }
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
};

// Pulls back beyond an angle, until it snaps.
class String final : public Outside {
 public:
  String(Values v, const twin::Pendulum& /*arm*/) : stiffness_{v[0]}, from_rad_{v[1]}, snaps_s_{v[2]} {}
  void mechanics(twin::Signals& s) noexcept override {
    if (s.session_time_s < snaps_s_) s.extra_torque_nm -= stiffness_ * std::max(0.0, s.position_rad - from_rad_);
  }

 private:
  double stiffness_, from_rad_, snaps_s_;
};

// A liquid beside the payload: a second pendulum of the same length, held to the arm by a spring and a damper.
class Slosh final : public Outside {
 public:
  Slosh(Values v, const twin::Pendulum& arm)
      : inertia_{v[0] * arm.length_m * arm.length_m},
        weight_nm_{v[0] * arm.length_m * arm.gravity_m_s2},
        frequency_{v[1]},
        damping_{v[2]} {}
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook | kMechanicsHook; }
  void reset(const twin::Signals& now) noexcept override {
    angle_ = now.position_rad;
    speed_ = 0;
  }
  // At 9 rad/s a firmware period is short enough.
  void command(twin::Signals& s, double dt_s) noexcept override {
    const double pull = spring(s) - weight_nm_ * std::sin(angle_);
    speed_ += pull / inertia_ * dt_s;
    angle_ += speed_ * dt_s;
  }
  void mechanics(twin::Signals& s) noexcept override { s.extra_torque_nm -= spring(s); }

 private:
  [[nodiscard]] double spring(const twin::Signals& s) const noexcept {
    return inertia_ * frequency_ *
           (frequency_ * (s.position_rad - angle_) + 2 * damping_ * (s.velocity_rad_s - speed_));
  }

  double inertia_, weight_nm_, frequency_, damping_;
  double angle_ = 0, speed_ = 0;
};

// Gets stiff fast once it is taut, on one side.
class Cable final : public Outside {
 public:
  Cable(Values v, const twin::Pendulum& /*arm*/) : stiffness_{v[0]}, from_rad_{v[1]} {}
  void mechanics(twin::Signals& s) noexcept override {
    const double beyond = std::max(0.0, s.position_rad - from_rad_);
    s.extra_torque_nm -= stiffness_ * beyond * beyond * beyond;
  }

 private:
  double stiffness_, from_rad_;
};

// Somebody pushes, once.
class Bump final : public Outside {
 public:
  Bump(Values v, const twin::Pendulum& /*arm*/) : torque_nm_{v[0]}, at_s_{v[1]}, for_s_{v[2]} {}
  void mechanics(twin::Signals& s) noexcept override {
    const double share = (s.session_time_s - at_s_) / for_s_;
    if (share > 0 && share < 1) s.extra_torque_nm += torque_nm_ * std::sin(kPi * share);
  }

 private:
  double torque_nm_, at_s_, for_s_;
};

// The horn turns on its shaft, once: from then on the arm hangs at another reading.
class SlippedHorn final : public Outside {
 public:
  SlippedHorn(Values v, const twin::Pendulum& arm)
      : slip_rad_{v[0]},
        at_s_{v[1]},
        weight_nm_{(arm.payload_kg + arm.arm_mass_kg / 2) * arm.length_m * arm.gravity_m_s2} {}
  void mechanics(twin::Signals& s) noexcept override {
    if (s.session_time_s < at_s_) return;
    s.extra_torque_nm += weight_nm_ * (std::sin(s.position_rad) - std::sin(s.position_rad - slip_rad_));
  }

 private:
  double slip_rad_, at_s_, weight_nm_;
};

// Something touches the arm over a few degrees of its way.
class Rub final : public Outside {
 public:
  Rub(Values v, const twin::Pendulum& /*arm*/) : friction_nm_{v[0]}, at_rad_{v[1]}, half_rad_{v[2]} {}
  void mechanics(twin::Signals& s) noexcept override {
    if (std::abs(s.position_rad - at_rad_) < half_rad_) s.dry_friction_nm += friction_nm_;
  }

 private:
  double friction_nm_, at_rad_, half_rad_;
};

template <class E>
std::unique_ptr<twin::Effect> made(Values values, const twin::Pendulum& arm) {
  return std::make_unique<E>(values, arm);
}

constexpr auto kString = std::to_array<OutsideParameter>(
    {{"stiffness", "N m/rad", 0.8, 2}, {"from", "rad", 0.15, 0.4}, {"snaps", "s", 23, 50}});
constexpr auto kSlosh = std::to_array<OutsideParameter>(
    {{"mass", "kg", 0.08, 0.15}, {"frequency", "rad/s", 7, 11}, {"damping", "", 0.03, 0.06}});
constexpr auto kCable = std::to_array<OutsideParameter>({{"stiffness", "N m/rad3", 5, 12}, {"from", "rad", 0.25, 0.4}});
// Within the first of two equal logs.
constexpr auto kBump = std::to_array<OutsideParameter>(
    {{"torque", "N m", 1.5, 3}, {"at", "s", 21.5, 24.5}, {"duration", "s", 0.06, 0.15}});
constexpr auto kSlip = std::to_array<OutsideParameter>({{"slip", "rad", 0.05, 0.12}, {"at", "s", 26, 44}});
constexpr auto kRub = std::to_array<OutsideParameter>(
    {{"friction", "N m", 0.12, 0.25}, {"at", "rad", 0.2, 0.5}, {"half", "rad", 0.06, 0.12}});

constexpr auto kAll = std::to_array<OutsideInfo>({
    {"u_string", "string that snaps", kString, made<String>},
    {"u_slosh", "liquid that sloshes", kSlosh, made<Slosh>},
    {"u_cable", "cable that gets taut on one side", kCable, made<Cable>},
    {"u_bump", "push", kBump, made<Bump>},
    {"u_slip", "horn that slips once", kSlip, made<SlippedHorn>},
    {"u_rub", "spot where something rubs", kRub, made<Rub>},
});

}  // namespace

std::span<const OutsideInfo> outsideCatalogue() {
  return kAll;
}

const OutsideInfo* findOutside(std::string_view id) {
  const auto found = std::ranges::find(kAll, id, &OutsideInfo::id);
  return found == kAll.end() ? nullptr : &*found;
}

OutsideSetting drawnOutside(const OutsideInfo& info, Rng& rng) {
  OutsideSetting setting{&info, {}};
  for (const OutsideParameter& parameter : info.parameters)
    setting.values.push_back(rng.between(parameter.low, parameter.high));
  return setting;
}

}  // namespace darwinop::gap
