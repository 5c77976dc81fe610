#include "gap/plant/body/floor_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <mutex>

#include "gap/plant/body/limb_parts.hpp"
#include "twin/body/ground.hpp"
#include "twin/body/link_inertia.hpp"
#include "twin/body/placing.hpp"

namespace darwinop::gap {
namespace {

constexpr int kUpOfFoot = 1;  // y of its link

/// MuJoCo's loader of XML keeps the last model, whatever the thread.
twin::MjModelPtr loaded(const twin::Model& model) {
  static std::mutex loading;
  const std::scoped_lock lock{loading};
  return twin::loadBody(model, false);
}

Eigen::Matrix3d turnOf(const mjtNum* quat) {
  return Eigen::Quaterniond{quat[0], quat[1], quat[2], quat[3]}.normalized().toRotationMatrix();
}

void setQuat(mjtNum* quat, const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q{rotation};
  quat[0] = q.w(), quat[1] = q.x(), quat[2] = q.y(), quat[3] = q.z();
}

/// The step is at most that of the model, and divides the period of the firmware.
void setEngine(mjModel& m, const twin::BodyMap& map, double period_s, const PhysicsEngine& engine) {
  if (engine.pyramidal_friction) m.opt.cone = mjCONE_PYRAMIDAL;
  const double steps = std::max(1.0, std::ceil(period_s / m.opt.timestep - 1e-9));
  m.opt.timestep = period_s / (steps * engine.step_divisor);
  for (int p = 0; p < m.npair; ++p) {
    if (m.pair_geom1[p] != map.floor && m.pair_geom2[p] != map.floor) continue;
    for (int i = 0; i < 2; ++i)
      m.pair_solimp[mjNIMP * p + i] = 1 - engine.impedance * (1 - m.pair_solimp[mjNIMP * p + i]);
  }
}

twin::LinkSettings settingsOf(double mass_kg, const Eigen::Vector3d& from_com_m, const Eigen::Vector3d& com_shift_m) {
  return {.mass_kg = mass_kg,
          .mass_from_com_m = {from_com_m.x(), from_com_m.y(), from_com_m.z()},
          .com_shift_m = {com_shift_m.x(), com_shift_m.y(), com_shift_m.z()}};
}

}  // namespace

twin::MjModelPtr bodyOf(const twin::Model& model, const FloorHypothesis& hypothesis) {
  const FloorChange& floor = hypothesis.floor;
  twin::Model changed = model;
  changed.body.floor_friction *= floor.friction_factor;
  changed.body.contact_time_s *= floor.contact_time_factor;
  twin::MjModelPtr compiled = loaded(changed);
  mjModel& m = *compiled;
  const twin::BodyMap map = twin::mapBody(m, model.body.xml);
  for (const LinkChange& of : hypothesis.robot.links)
    twin::changeLink(m, map.link[static_cast<std::size_t>(of.link)],
                     settingsOf(of.mass_kg, of.from_com_m, of.com_shift_m));
  if (floor.trunk_mass_kg != 0 || !floor.trunk_com_shift_m.isZero())
    twin::changeLink(m, map.trunk, settingsOf(floor.trunk_mass_kg, floor.trunk_from_com_m, floor.trunk_com_shift_m));
  if (floor.sole_scale != 1) twin::scaleSoles(m, map, floor.sole_scale);
  twin::tiltFloor(m, floor.tilt_rad[0], floor.tilt_rad[1]);
  setEngine(m, map, hypothesis.robot.servos.servo.firmware_period_s, hypothesis.engine);
  return compiled;
}

void placeAtRest(const mjModel& m, mjData& d, const twin::BodyMap& map, const std::array<double, kJoints>& angles_rad,
                 std::string_view lies_on) {
  twin::placeOnFloor(m, d, map, angles_rad, 0);
  mjtNum* const quat = d.qpos + map.trunk_qpos + 3;
  if (lies_on.empty()) {
    // Mean direction of the soles' normals, turned to the vertical.
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const Joint joint : {Joint::kFootR, Joint::kFootL})
      normal += turnOf(d.xquat + 4 * map.link[static_cast<std::size_t>(joint)]).col(kUpOfFoot);
    const Eigen::Matrix3d level =
        Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    setQuat(quat, level * turnOf(quat));
  } else {
    const double angle = lies_on == "front" || lies_on == "right" ? kPi / 2 : -kPi / 2;
    const bool is_on_side = lies_on == "left" || lies_on == "right";
    const Eigen::Vector3d about = is_on_side ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    setQuat(quat, Eigen::AngleAxisd{angle, about}.toRotationMatrix() * turnOf(quat));
  }
  mj_kinematics(&m, &d);
  d.qpos[map.trunk_qpos + 2] -= twin::lowestPoint(m, d, map.trunk);
  mj_kinematics(&m, &d);
}

}  // namespace darwinop::gap
