// The single-joint bench in simulated seconds per second of one core, against a loop written by hand for one case, and
// against MuJoCo's own hinge.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "twin/bench/bench.hpp"
#include "twin/effects/catalogue.hpp"
#ifdef DARWINOP_BENCH_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace {

using namespace darwinop;
using namespace darwinop::twin;

constexpr int kPeriods = 200000;  // 200 s
constexpr int kStepsPerPeriod = 2;
constexpr double kCoulomb = 0.025, kViscous = 0.002, kKp = 4;
constexpr Pendulum kPendulum{.payload_kg = 0.3, .arm_mass_kg = 0.05, .length_m = 0.12};

// A goal that jumps twice a second, so that the joint moves all the time.
double goalAt(int period) {
  return (period / 500) % 2 == 0 ? 0.8 : -0.8;
}

/// Simulated seconds per second of CPU time, best of five: whatever else runs on the machine only makes it slower.
template <class Run>
double rate(Run&& run) {
  double best = std::numeric_limits<double>::infinity();
  double moved = 0;
  for (int i = 0; i < 5; ++i) {
    const std::clock_t begin = std::clock();
    moved = run();
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  if (!(moved > 100)) std::fprintf(stderr, "the joint did not move\n");
  return kPeriods * 0.001 / best;
}

std::vector<std::unique_ptr<Effect>> effects(std::initializer_list<std::string_view> more) {
  std::vector<std::unique_ptr<Effect>> made;
  const auto add = [&](std::string_view id, double first) {
    const EffectInfo* info = findEffect(id);
    std::vector<double> values;
    for (const Parameter& parameter : info->parameters) values.push_back(parameter.typical);
    if (!std::isnan(first)) values[0] = first;
    made.push_back(info->make(values));
  };
  add("coulomb", kCoulomb);
  add("viscous", kViscous);
  for (const std::string_view id : more) add(id, std::numeric_limits<double>::quiet_NaN());
  return made;
}

double ours(std::vector<std::unique_ptr<Effect>> made) {
  Bench bench{ServoParameters{}, std::move(made), kPendulum};
  return rate([&] {
    bench.reset({.steps_per_period = kStepsPerPeriod});
    ServoDrive drive{.torque_on = true, .speed_limit_rad_s = INFINITY, .torque_limit = 1, .p_gain = kKp};
    double way = 0;
    for (int i = 0; i < kPeriods; ++i) {
      drive.goal_rad = goalAt(i);
      bench.step(drive);
      way += std::abs(bench.velocity_rad_s()) * 0.001;
    }
    return way;
  });
}

// The same servo, friction and pendulum and nothing else: explicit Euler, all numbers in registers. No heat, no
// profile, no load limit, no reported speed.
double handWritten() {
  return rate([] {
    const ServoParameters p;
    const double arm = kPendulum.arm_mass_kg, m = kPendulum.payload_kg, l = kPendulum.length_m, h = 0.001 / 2;
    const double inertia = m * l * l + arm * l * l / 3 + p.armature_kgm2;
    const double weight = (m * l + arm * l / 2) * kPendulum.gravity_m_s2;
    double q = 0, w = 0, way = 0;
    for (int i = 0; i < kPeriods; ++i) {
      const double measured = std::nearbyint(q * 4096 / (2 * kPi)) * (2 * kPi / 4096);
      const double duty = std::clamp(p.duty_per_kp_per_rad * 8 * kKp * (goalAt(i) - measured), -1.0, 1.0);
      for (int k = 0; k < kStepsPerPeriod; ++k) {
        const double motor = p.kt_nm_a * (duty * 12 - p.back_emf_vs_rad * w) / p.resistance_ohm;
        const double torque = motor - weight * std::sin(q);
        const double stop = -w * inertia / h - torque, most = kCoulomb + kViscous * std::abs(w);
        w += (torque + std::clamp(stop, -most, most)) / inertia * h;
        q += w * h;
      }
      way += std::abs(w) * 0.001;
    }
    return way;
  });
}

#ifdef DARWINOP_BENCH_MUJOCO
// One hinge with friction loss and damping; duty, encoder and back EMF from outside, as the whole body does it.
double mujoco() {
  constexpr char kFile[] = "hinge.xml";
  constexpr char kXml[] =
      "<mujoco><compiler angle='radian'/><option timestep='0.0005' gravity='0 0 -9.80665'/><worldbody><body>"
      "<joint name='j' type='hinge' axis='0 1 0' armature='0.003' damping='0.374' frictionloss='0.025'/>"
      "<inertial pos='0 0 -0.11' mass='0.35' diaginertia='0.0004 0.0004 0.0001'/></body></worldbody></mujoco>";
  mjVFS vfs;
  mj_defaultVFS(&vfs);
  mj_makeEmptyFileVFS(&vfs, kFile, sizeof kXml - 1);
  std::copy(std::begin(kXml), std::end(kXml) - 1, static_cast<char*>(vfs.filedata[0]));
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(kFile, &vfs, error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(&vfs);
  if (model == nullptr) {
    std::fprintf(stderr, "MuJoCo: %s\n", error.data());
    return 0;
  }
  mjData* data = mj_makeData(model);
  const ServoParameters p;
  const double result = rate([&] {
    mj_resetData(model, data);
    double way = 0;
    for (int i = 0; i < kPeriods; ++i) {
      const double measured = std::nearbyint(data->qpos[0] * 4096 / (2 * kPi)) * (2 * kPi / 4096);
      const double duty = std::clamp(p.duty_per_kp_per_rad * 8 * kKp * (goalAt(i) - measured), -1.0, 1.0);
      data->qfrc_applied[0] = p.kt_nm_a * duty * 12 / p.resistance_ohm;
      for (int k = 0; k < kStepsPerPeriod; ++k) mj_step(model, data);
      way += std::abs(data->qvel[0]) * 0.001;
    }
    return way;
  });
  mj_deleteData(data);
  mj_deleteModel(model);
  return result;
}
#endif

void print(const char* name, double mine, double peer) {
  std::printf("bench: %s ours=%.0f peer=%.0f ratio=%.3f unit=s/s\n", name, mine, peer, mine / peer);
}

}  // namespace

int main() {
  const double limit = handWritten();
  const double plain = ours(effects({}));
  print("twin_bench_two_effects", plain, limit);
  print("twin_bench_six_effects",
        ours(effects({"stribeck", "load_dependent_friction", "supply_sag", "transport_delay"})), limit);
  print("twin_bench_soft_gear", ours(effects({"joint_flex"})), limit);
#ifdef DARWINOP_BENCH_MUJOCO
  print("twin_bench_against_mujoco", plain, mujoco());
#endif
}
