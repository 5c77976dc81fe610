// Mass, centre of mass and inertia of a link, and changes of them.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>

#include "twin/model/link.hpp"

namespace darwinop::twin {

/// In the link's frame; the inertia about the centre of mass. SI units.
struct LinkInertia {
  double mass_kg = 0;
  Eigen::Vector3d com_m;
  Eigen::Matrix3d inertia_kgm2;

  /// Attaches a point mass.
  void add(double mass, const Eigen::Vector3d& at);
  /// Moves the centre of mass, then attaches a point mass at this distance from it.
  void change(double added_kg, const Eigen::Vector3d& from_com_m, const Eigen::Vector3d& com_shift_m);
  /// False: no body has such numbers.
  [[nodiscard]] bool isPossible() const;
};

/// Of one body of MuJoCo's model; its constants (mj_setConst) are the caller's.
LinkInertia inertiaOfLink(const mjModel& m, int body);
void setInertia(mjModel& m, int body, const LinkInertia& inertia);

void changeLink(mjModel& m, int body, const LinkSettings& settings);

}  // namespace darwinop::twin
