// Spatial vectors about the trunk's origin, in its axes (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 5
// and 6): about a common point, the inertias of links add up.
#include "gap/plant/body/limb_dynamics.hpp"

#include <Eigen/Geometry>

namespace darwinop::gap {
namespace {

using Vector = Eigen::Vector3d;

struct Motion {
  Vector turn, move;  // move: of the point at the origin
};
struct Force {
  Vector moment, force;  // moment: about the origin
};

Motion operator+(const Motion& a, const Motion& b) {
  return {a.turn + b.turn, a.move + b.move};
}
Motion operator*(const Motion& a, double factor) {
  return {a.turn * factor, a.move * factor};
}
double dot(const Motion& a, const Force& b) {
  return a.turn.dot(b.moment) + a.move.dot(b.force);
}
Motion cross(const Motion& a, const Motion& b) {
  return {a.turn.cross(b.turn), a.turn.cross(b.move) + a.move.cross(b.turn)};
}
Force cross(const Motion& a, const Force& b) {
  return {a.turn.cross(b.moment) + a.move.cross(b.force), a.turn.cross(b.force)};
}

struct Inertia {
  double mass = 0;
  Vector moment = Vector::Zero();  // mass times position of the centre
  Eigen::Matrix3d about_origin = Eigen::Matrix3d::Zero();

  [[nodiscard]] Force times(const Motion& a) const {
    return {about_origin * a.turn + moment.cross(a.move), mass * a.move - moment.cross(a.turn)};
  }
  void add(const Inertia& other) { mass += other.mass, moment += other.moment, about_origin += other.about_origin; }
};

Inertia inertiaOf(const Link& link, const Eigen::Matrix3d& rotation, const Vector& origin) {
  const Vector com = origin + rotation * link.com_m;
  Inertia out{.mass = link.mass_kg, .moment = link.mass_kg * com};
  out.about_origin = rotation * link.inertia_kgm2 * rotation.transpose() +
                     link.mass_kg * (com.squaredNorm() * Eigen::Matrix3d::Identity() - com * com.transpose());
  return out;
}

}  // namespace

LimbDynamics::LimbDynamics(const Limb& limb, const LimbVector& angles, const LimbVector& velocities,
                           const Vector& gravity) {
  const auto n = static_cast<Eigen::Index>(limb.size());
  mass = LimbMatrix::Zero(n, n);
  bias = LimbVector::Zero(n);
  std::array<Eigen::Matrix3d, kLimbJoints> rotations;
  std::array<Vector, kLimbJoints> origins;
  std::array<Motion, kLimbJoints> axes, speeds, accelerations;
  std::array<Inertia, kLimbJoints> inertias;
  std::array<Force, kLimbJoints> forces;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Link& link = limb[k];
    const auto parent = static_cast<std::size_t>(link.parent);
    const bool on_trunk = link.parent < 0;
    const Eigen::Matrix3d at_zero = on_trunk ? link.rotation : rotations[parent] * link.rotation;
    rotations[k] = at_zero * Eigen::AngleAxisd{angles[i], link.axis}.toRotationMatrix();
    origins[k] = on_trunk ? link.origin : Vector{origins[parent] + rotations[parent] * link.origin};
    const Vector axis = at_zero * link.axis;
    axes[k] = {axis, origins[k].cross(axis)};
    const Motion own = axes[k] * velocities[i];
    const Motion before = on_trunk ? Motion{Vector::Zero(), Vector::Zero()} : speeds[parent];
    speeds[k] = before + own;
    // Gravity acts as an acceleration of the trunk.
    accelerations[k] = (on_trunk ? Motion{Vector::Zero(), -gravity} : accelerations[parent]) + cross(before, own);
    inertias[k] = inertiaOf(link, rotations[k], origins[k]);
    const Force moved = inertias[k].times(accelerations[k]), turned = cross(speeds[k], inertias[k].times(speeds[k]));
    forces[k] = {moved.moment + turned.moment, moved.force + turned.force};
  }
  for (Eigen::Index j = n - 1; j >= 0; --j) {
    const auto k = static_cast<std::size_t>(j);
    bias[j] = dot(axes[k], forces[k]);
    const Force needed = inertias[k].times(axes[k]);
    for (int i = static_cast<int>(j); i >= 0; i = limb[static_cast<std::size_t>(i)].parent)
      mass(i, j) = mass(j, i) = dot(axes[static_cast<std::size_t>(i)], needed);
    if (limb[k].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(limb[k].parent);
    inertias[parent].add(inertias[k]);
    forces[parent] = {forces[parent].moment + forces[k].moment, forces[parent].force + forces[k].force};
  }
}

}  // namespace darwinop::gap
