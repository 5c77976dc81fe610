#include "gap/benchmark/body/body_motions.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "gap/benchmark/body/motions.hpp"

namespace darwinop::gap {
namespace {

constexpr double kRow = 0.016;            // s
constexpr double kTick = 2 * kPi / 4096;  // rad
constexpr double kFree = 0.12;            // rad from an end of a joint's range
// rad/s of the ankles in a bow: so that the robot tips over within three seconds.
constexpr double kForward = 0.16, kBackward = -0.14;

void add(BodyCase& into, BodySetup setup, int rows, bool held_out, const Motion& motion, Rng& rng) {
  BodyLog log;
  const auto of_role = std::ranges::count(into.logs, held_out, &BodyLog::held_out) + 1;
  log.file = (held_out ? "score_" : "fit_") + std::to_string(of_role) + ".csv";
  log.held_out = held_out, log.setup = setup, log.battery_v = 11.8;
  const double last = into.logs.empty() ? 0 : into.logs.back().session_start_s;
  log.session_start_s = std::round(10 * (last + rng.between(7, 10.5))) / 10;
  for (int row = 0; row < rows; ++row) log.time_s.push_back(kRow * row);
  log.from_s = 0, log.to_s = log.time_s.back();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const auto& limits = kJointTable[joint];
    Trajectory of;
    of.file = log.file, of.kind = name(setup), of.held_out = held_out, of.joint = static_cast<Joint>(joint);
    of.supply_v = log.battery_v, of.session_start_s = log.session_start_s, of.time_s = log.time_s;
    for (const double time : log.time_s) {
      const RowCommands now = motion(time);
      const double goal =
          std::clamp(now.goals[joint], radFromTicks(static_cast<std::uint16_t>(limits.low)).value + kFree,
                     radFromTicks(static_cast<std::uint16_t>(limits.high)).value - kFree);
      of.goal_rad.push_back(std::round(goal / kTick) * kTick);
      of.torque_on.push_back(now.limp[joint] ? 0 : 1);
      of.p_register_of_row.push_back(now.p_register);
    }
    for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c})
      column->assign(log.rows(), std::nan(""));
    into.joints.logs.push_back(std::move(of));
  }
  into.logs.push_back(std::move(log));
}

}  // namespace

BodyCase plannedBody(const std::string& name, std::uint64_t seed, FloorMotions on_floor) {
  Rng rng{seed};
  BodyCase out;
  out.name = name, out.model = "darwin-op";
  out.joints.model = twin::readModel(twin::findModel(out.model));
  constexpr int kLong = 201, kHeldOut = 151, kOnFloor = 191, kShort = 41;
  const auto up = [&](const Axes& axes) { out.logs.back().up = axes; };
  const Motion first = sines(rng);
  for (int i = 0; i < 2; ++i) add(out, BodySetup::kClamped, kLong, false, first, rng), up({0, 1, 0});
  out.logs.back().repeat_of = 0;
  add(out, BodySetup::kClamped, kLong, false, triangles(kRow * kLong, rng), rng), up({rng.sign(), 0, 0});
  add(out, BodySetup::kClamped, kLong, false, released(rng), rng), up({0, 0, rng.sign()});
  const bool bows = on_floor == FloorMotions::kBows;
  add(out, BodySetup::kFloor, kLong, false, bows ? bow(kForward, rng) : squats(rng), rng);
  add(out, BodySetup::kFloor, kLong, false, bows ? bow(kBackward, rng) : walk(rng), rng);
  add(out, BodySetup::kLying, kShort, false, stance(), rng);
  out.logs.back().lies_on = rng.coin() ? "back" : "front";
  const double azimuth = rng.between(-kPi, kPi), down = rng.between(-1, 0.3), level = std::sqrt(1 - down * down);
  add(out, BodySetup::kClamped, kHeldOut, true, steps(rng), rng);
  up({level * std::cos(azimuth), down, level * std::sin(azimuth)});
  add(out, BodySetup::kFloor, kOnFloor, true, bows ? bow(kForward, rng) : sways(rng), rng);
  add(out, BodySetup::kFloor, kOnFloor, true, bows ? bow(kBackward, rng) : walk(rng), rng);
  return out;
}

}  // namespace darwinop::gap
