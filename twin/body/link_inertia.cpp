#include "twin/body/link_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace darwinop::twin {
namespace {

using EigenAxes = Eigen::Map<Eigen::Vector3d>;
using ConstEigenAxes = Eigen::Map<const Eigen::Vector3d>;

/// Inertia of a point mass at this place, about the origin.
Eigen::Matrix3d inertiaOfPoint(double mass, const Eigen::Vector3d& at) {
  return mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
}

}  // namespace

void LinkInertia::add(double mass, const Eigen::Vector3d& at) {
  const double sum = mass_kg + mass;
  const Eigen::Vector3d com = (mass_kg * com_m + mass * at) / sum;
  inertia_kgm2 += inertiaOfPoint(mass_kg, com_m - com) + inertiaOfPoint(mass, at - com);
  mass_kg = sum;
  com_m = com;
}

void LinkInertia::change(double added_kg, const Eigen::Vector3d& from_com_m, const Eigen::Vector3d& com_shift_m) {
  com_m += com_shift_m;
  add(added_kg, com_m + from_com_m);
}

bool LinkInertia::isPossible() const {
  return mass_kg > 0 && Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>{inertia_kgm2}.eigenvalues().minCoeff() > 0;
}

LinkInertia inertiaOfLink(const mjModel& m, int body) {
  LinkInertia out;
  out.mass_kg = m.body_mass[body];
  out.com_m = ConstEigenAxes{m.body_ipos + 3 * body};
  const mjtNum* const quat = m.body_iquat + 4 * body;
  const Eigen::Matrix3d axes = Eigen::Quaterniond{quat[0], quat[1], quat[2], quat[3]}.normalized().toRotationMatrix();
  out.inertia_kgm2 = axes * ConstEigenAxes{m.body_inertia + 3 * body}.asDiagonal() * axes.transpose();
  return out;
}

void setInertia(mjModel& m, int body, const LinkInertia& inertia) {
  m.body_mass[body] = inertia.mass_kg;
  EigenAxes{m.body_ipos + 3 * body} = inertia.com_m;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal{inertia.inertia_kgm2};
  EigenAxes{m.body_inertia + 3 * body} = principal.eigenvalues();
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  const Eigen::Quaterniond q{axes};
  mjtNum* const quat = m.body_iquat + 4 * body;
  quat[0] = q.w(), quat[1] = q.x(), quat[2] = q.y(), quat[3] = q.z();
  m.body_sameframe[body] = 0;
}

void changeLink(mjModel& m, int body, const LinkSettings& settings) {
  LinkInertia link = inertiaOfLink(m, body);
  link.change(settings.mass_kg, ConstEigenAxes{settings.mass_from_com_m.data()},
              ConstEigenAxes{settings.com_shift_m.data()});
  setInertia(m, body, link);
}

}  // namespace darwinop::twin
