#include "twin/body/imu_axes.hpp"

#include <mujoco/mujoco.h>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {
namespace {

MountingMatrix mountingOf(const mjModel& m, int site) {
  mjtNum columns[9];  // row-major, its columns are the site's axes
  mju_quat2Mat(columns, m.site_quat + 4 * site);
  MountingMatrix rows{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 3; ++k) rows[axis][k] = columns[3 * k + axis];
  return rows;
}

}  // namespace

ImuAxes imuAxesOf(const Model& model) {
  const MjModelPtr body = loadBody(model, /*ball=*/false);
  const BodyMap map = mapBody(*body, model.body.xml);
  return {.gyro = mountingOf(*body, map.gyro),
          .accelerometer = mountingOf(*body, map.accelerometer),
          .gravity_m_s2 = mju_norm3(body->opt.gravity)};
}

}  // namespace darwinop::twin
