#include "gap/plant/body/model_with.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "twin/body/ground.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {
namespace {

using TwinAxes = std::array<double, 3>;

TwinAxes asAxes(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Eigen::Vector3d asVector(const TwinAxes& axes) {
  return {axes[0], axes[1], axes[2]};
}

double massOf(const twin::Model& model, std::size_t link) {
  const twin::MjModelPtr compiled = twin::loadBody(model, false);
  const twin::BodyMap map = twin::mapBody(*compiled, model.body.xml);
  return compiled->body_mass[link == twin::kTrunkLink ? map.trunk : map.link[link]];
}

/// Two masses in one link become one between them, with their weight. It has their moment as well where both have one
/// sign; what they differ by moves the centre of mass, so that masses that cancel keep their moment. The inertia of
/// their distance is lost.
void changeLink(twin::Model& model, std::size_t link, double mass_kg, const Eigen::Vector3d& from_com_m,
                const Eigen::Vector3d& com_shift_m) {
  twin::LinkSettings& into = model.links[link];
  if (const double was_kg = into.mass_kg; mass_kg != 0 && was_kg != 0) {
    const double both_kg = massOf(model, link);
    const Eigen::Vector3d first_m = asVector(into.mass_from_com_m);
    const Eigen::Vector3d second_m = from_com_m + was_kg / both_kg * first_m;  // the first moved the centre of mass
    const double first = std::abs(was_kg), second = std::abs(mass_kg);
    const Eigen::Vector3d between_m = (first * first_m + second * second_m) / (first + second);
    into.mass_kg += mass_kg;
    const Eigen::Vector3d left_kg_m = was_kg * first_m + mass_kg * second_m - into.mass_kg * between_m;
    const Eigen::Vector3d moved_m = left_kg_m / (both_kg - was_kg);
    into.com_shift_m = asAxes(asVector(into.com_shift_m) + moved_m);
    into.mass_from_com_m = asAxes(between_m - moved_m);
  } else if (mass_kg != 0) {
    into.mass_kg = mass_kg, into.mass_from_com_m = asAxes(from_com_m);
  }
  into.com_shift_m = asAxes(asVector(into.com_shift_m) + com_shift_m);
}

/// Axes of a sensor whose readings go through `map`.
TwinAxes mapped(const TwinAxes& axes, const Eigen::Matrix3d& map) {
  TwinAxes out = axes;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      if (map(i, k) != 0) out[static_cast<std::size_t>(i)] = map(i, k) * axes[static_cast<std::size_t>(k)];
  return out;
}

/// Rotation vector of a board turned by `first`, then by `second`.
TwinAxes turned(const TwinAxes& first, const Eigen::Vector3d& second) {
  const Eigen::Vector3d was = asVector(first);
  if (second.isZero()) return first;
  if (was.isZero()) return asAxes(second);
  const Eigen::AngleAxisd both{Eigen::AngleAxisd{second.norm(), second.normalized()} *
                               Eigen::AngleAxisd{was.norm(), was.normalized()}};
  return asAxes(both.angle() * both.axis());
}

void changeImu(ModelWith& into, const ImuDeviation& by) {
  twin::ImuSettings& imu = into.model.imu;
  imu.gyro_axes = mapped(imu.gyro_axes, by.gyro.map);
  imu.gyro_bias_rad_s = asAxes(asVector(imu.gyro_bias_rad_s) + by.gyro.bias);
  imu.accel_bias_m_s2 = asAxes(asVector(imu.accel_bias_m_s2) + by.accel.bias);
  imu.gyro_scale = asAxes(asVector(imu.gyro_scale).cwiseProduct(by.gyro.scale));
  imu.accel_scale = asAxes(asVector(imu.accel_scale).cwiseProduct(by.accel.scale));
  imu.accel_axes = mapped(imu.accel_axes, by.accel.map);
  imu.mounting_rad = turned(imu.mounting_rad, by.accel.rotation);
  imu.gyro_range_rad_s = std::min(imu.gyro_range_rad_s, by.range_rad_s);
  imu.delay_s += by.delay_s;
  if (by.lowpass_s > 0 && imu.gyro_lowpass_s > 0)
    into.conflicts.emplace_back(
        "gyro_lowpass: [imu] gyro_lowpass of the model is set already, and two filters are not one of first order; "
        "replace its time by hand");
  else
    imu.gyro_lowpass_s += by.lowpass_s;
}

}  // namespace

ModelWith modelWith(const twin::Model& base, const FloorHypothesis& hypothesis, const ImuDeviation& imu) {
  ModelWith out{base, {}};
  twin::Model& model = out.model;
  model.servo = hypothesis.robot.servos.servo;
  model.effects.clear();
  for (const PlacedEffect& effect : hypothesis.robot.servos.effects) {
    model.effects.push_back(effect);
    model.effects.back().joint = findJoint(effect.place.name);
  }
  for (const LinkChange& of : hypothesis.robot.links)
    changeLink(model, static_cast<std::size_t>(of.link), of.mass_kg, of.from_com_m, of.com_shift_m);
  const FloorChange& floor = hypothesis.floor;
  changeLink(model, twin::kTrunkLink, floor.trunk_mass_kg, floor.trunk_from_com_m, floor.trunk_com_shift_m);
  model.body.floor_friction *= floor.friction_factor;
  model.body.contact_time_s *= floor.contact_time_factor;
  model.body.sole_size *= floor.sole_scale;
  if (floor.tilt_rad != std::array<double, 2>{}) {
    const twin::FloorTilt was{model.body.floor_tilt_x_rad, model.body.floor_tilt_y_rad};
    const twin::FloorTilt now = twin::joined(was, {floor.tilt_rad[0], floor.tilt_rad[1]});
    model.body.floor_tilt_x_rad = now.about_x_rad, model.body.floor_tilt_y_rad = now.about_y_rad;
  }
  changeImu(out, imu);
  return out;
}

}  // namespace darwinop::gap
