#include "twin/body/ground.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace darwinop::twin {
namespace {

constexpr int kUpOfFoot = 1;  // y of its link

Eigen::Matrix3d turnedBy(const FloorTilt& tilt) {
  return (Eigen::AngleAxisd{tilt.about_y_rad, Eigen::Vector3d::UnitY()} *
          Eigen::AngleAxisd{tilt.about_x_rad, Eigen::Vector3d::UnitX()})
      .toRotationMatrix();
}

}  // namespace

void scaleSoles(mjModel& m, const BodyMap& map, double scale) {
  for (const Joint joint : {Joint::kFootR, Joint::kFootL})
    for (int g = 0; g < m.ngeom; ++g) {
      if (m.geom_bodyid[g] != map.link[static_cast<std::size_t>(joint)] || m.geom_contype[g] == 0) continue;
      mjtNum* const size = m.geom_size + 3 * g;
      for (int axis = 0; axis < 3; ++axis)
        if (axis != kUpOfFoot) size[axis] *= scale;
      m.geom_rbound[g] = mju_norm3(size);
    }
}

void tiltFloor(mjModel& m, double about_x_rad, double about_y_rad) {
  Eigen::Map<Eigen::Vector3d> gravity{m.opt.gravity};
  gravity = turnedBy({about_x_rad, about_y_rad}).transpose() * Eigen::Vector3d{gravity};
}

void levelFloor(mjModel& m) {
  const mjtNum length = mju_norm3(m.opt.gravity);
  mju_zero3(m.opt.gravity);
  m.opt.gravity[2] = -length;
}

FloorTilt joined(const FloorTilt& first, const FloorTilt& second) {
  // The vertical in the axes of the second floor: the last row of Ry(y) Rx(x).
  const Eigen::Vector3d up = turnedBy(second).transpose() * turnedBy(first).transpose() * Eigen::Vector3d::UnitZ();
  return {.about_x_rad = std::atan2(up.y(), up.z()), .about_y_rad = -std::asin(up.x())};
}

}  // namespace darwinop::twin
