#include "twin/body/clamp.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "twin/body/ground.hpp"
#include "twin/body/mujoco_guard.hpp"
#include "twin/body/placing.hpp"

namespace darwinop::twin {
namespace {

constexpr double kHeight = 1;         // m: no limb reaches the floor
constexpr double kImmovable = 1e6;    // kg and kg m2: 30 N move it by 1e-11 m in a step
constexpr double kShortestUp = 1e-3;  // a direction needs a length
constexpr const char* kVariable = "DARWINOP_TWIN_CLAMP";

}  // namespace

std::optional<ClampedUp> clampFromEnvironment() {
  const char* const value = std::getenv(kVariable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  std::istringstream text{value};
  ClampedUp up{};
  std::string rest;
  const bool is_complete = (text >> up[0] >> up[1] >> up[2]) && !(text >> rest);
  const double length = std::hypot(up[0], up[1], up[2]);
  if (!is_complete || !(length > kShortestUp) || !std::isfinite(length))
    throw std::runtime_error(std::string{kVariable} + " = " + value +
                             ": must be three numbers, the upward direction in the trunk's frame (left, up, forward), "
                             "as in 0 1 0");
  for (double& component : up) component /= length;
  return up;
}

void clampTrunk(mjModel& m, const BodyMap& map) {
  if (m.opt.gravity[0] != 0 || m.opt.gravity[1] != 0) levelFloor(m);  // a slope of the floor
  // Armature, not mass: it has no weight. The solver ends when its cost falls below a share of the mean inertia; with
  // the trunk's in it, friction would end early and resting joints would creep by 5 mrad.
  const mjtNum mean_inertia = m.stat.meaninertia;
  for (int i = 0; i < 6; ++i) m.dof_armature[map.trunk_dof + i] += kImmovable;
  const MjDataPtr data = dataFor(m, "the clamped body");
  orThrow("the clamped body", [&] { mj_setConst(&m, data.get()); });
  m.stat.meaninertia = mean_inertia;
}

void holdInStand(mjData& d, const BodyMap& map, const ClampedUp& up) noexcept {
  mju_zero(d.qvel + map.trunk_dof, 6);
  mjtNum* const pose = d.qpos + map.trunk_qpos;
  pose[0] = pose[1] = 0;
  pose[2] = kHeight;
  mjtNum from_up[4];
  mju_quatZ2Vec(from_up, up.data());
  mju_negQuat(pose + 3, from_up);
}

void placeInStand(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad,
                  const ClampedUp& up) {
  bringToRest(m, d, map, angles_rad);
  holdInStand(d, map, up);
  mj_kinematics(&m, &d);
}

}  // namespace darwinop::twin
