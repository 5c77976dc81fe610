#include "gap/plant/body/floor_parts.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <mutex>

#include "gap/plant/body/limb_parts.hpp"
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

Eigen::Map<Eigen::Vector3d> axesAt(mjtNum* values) {
  return Eigen::Map<Eigen::Vector3d>{values};
}

Eigen::Matrix3d turnOf(const mjtNum* quat) {
  return Eigen::Quaterniond{quat[0], quat[1], quat[2], quat[3]}.normalized().toRotationMatrix();
}

void setQuat(mjtNum* quat, const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q{rotation};
  quat[0] = q.w(), quat[1] = q.x(), quat[2] = q.y(), quat[3] = q.z();
}

/// Mass, centre and inertia of one body.
Link inertialOf(mjModel& m, int body) {
  Link out;
  out.mass_kg = m.body_mass[body];
  out.com_m = axesAt(m.body_ipos + 3 * body);
  const Eigen::Matrix3d axes = turnOf(m.body_iquat + 4 * body);
  out.inertia_kgm2 = axes * axesAt(m.body_inertia + 3 * body).asDiagonal() * axes.transpose();
  return out;
}

void setInertial(mjModel& m, int body, const Link& link) {
  m.body_mass[body] = link.mass_kg;
  axesAt(m.body_ipos + 3 * body) = link.com_m;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal{link.inertia_kgm2};
  axesAt(m.body_inertia + 3 * body) = principal.eigenvalues();
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  setQuat(m.body_iquat + 4 * body, axes);
  m.body_sameframe[body] = 0;
}

void change(mjModel& m, int body, double mass_kg, const Eigen::Vector3d& from_com_m, const Eigen::Vector3d& shift_m) {
  Link link = inertialOf(m, body);
  link.com_m += shift_m;
  link.add(mass_kg, link.com_m + from_com_m);
  setInertial(m, body, link);
}

void scaleSoles(mjModel& m, const twin::BodyMap& map, double scale) {
  for (const Joint joint : {Joint::kFootR, Joint::kFootL})
    for (int g = 0; g < m.ngeom; ++g) {
      if (m.geom_bodyid[g] != map.link[static_cast<std::size_t>(joint)] || m.geom_contype[g] == 0) continue;
      mjtNum* const size = m.geom_size + 3 * g;
      for (int axis = 0; axis < 3; ++axis)
        if (axis != kUpOfFoot) size[axis] *= scale;
      m.geom_rbound[g] = mju_norm3(size);
    }
}

void setEngine(mjModel& m, const twin::BodyMap& map, const PhysicsEngine& engine) {
  if (engine.pyramidal_friction) m.opt.cone = mjCONE_PYRAMIDAL;
  m.opt.timestep /= engine.steps_per_cycle;
  for (int p = 0; p < m.npair; ++p) {
    if (m.pair_geom1[p] != map.floor && m.pair_geom2[p] != map.floor) continue;
    for (int i = 0; i < 2; ++i)
      m.pair_solimp[mjNIMP * p + i] = 1 - engine.impedance * (1 - m.pair_solimp[mjNIMP * p + i]);
  }
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
    change(m, map.link[static_cast<std::size_t>(of.link)], of.mass_kg, of.from_com_m, of.com_shift_m);
  if (floor.trunk_mass_kg != 0 || !floor.trunk_com_shift_m.isZero())
    change(m, map.trunk, floor.trunk_mass_kg, floor.trunk_from_com_m, floor.trunk_com_shift_m);
  if (floor.sole_scale != 1) scaleSoles(m, map, floor.sole_scale);
  // Not the floor is turned but gravity: a roll-out has no other reference.
  const Eigen::Matrix3d turned = (Eigen::AngleAxisd{floor.tilt_rad[1], Eigen::Vector3d::UnitY()} *
                                  Eigen::AngleAxisd{floor.tilt_rad[0], Eigen::Vector3d::UnitX()})
                                     .toRotationMatrix();
  axesAt(m.opt.gravity) = turned.transpose() * Eigen::Vector3d{axesAt(m.opt.gravity)};
  setEngine(m, map, hypothesis.engine);
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
    const double angle = lies_on == "front" ? kPi / 2 : -kPi / 2;
    const Eigen::Vector3d about = lies_on == "side" ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    setQuat(quat, Eigen::AngleAxisd{angle, about}.toRotationMatrix() * turnOf(quat));
  }
  mj_kinematics(&m, &d);
  d.qpos[map.trunk_qpos + 2] -= twin::lowestPoint(m, d, map.trunk);
  mj_kinematics(&m, &d);
}

}  // namespace darwinop::gap
