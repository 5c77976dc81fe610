#include "gap/benchmark/body/body_registers.hpp"

#include <cmath>

#include "core/random.hpp"

namespace darwinop::gap {
namespace {

constexpr double kGyroStep = 27.925 / 512, kAccelStep = 39.24 / 512;  // rad/s, m/s2: registers of these cases

void roundTo(double unit, std::vector<double>& column) {
  for (double& value : column) value = std::round(value / unit) * unit;
}

}  // namespace

void readSensors(BodyCase& plan, std::size_t index, const FloorTrace& trace, const ImuDeviation& deviation,
                 const Disturbance* noise) {
  BodyLog& log = plan.logs[index];
  const MovingImu imu{plan.joints.model};
  const MovingImu::Readings sensed = imu.of(trace, deviation);
  Rng rng{splitMix(noise == nullptr ? 1 : noise->seed + 1)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto column = static_cast<Eigen::Index>(axis);
    std::vector<double>&gyro = log.gyro_rad_s[axis], &accel = log.accel_m_s2[axis];
    gyro.assign(sensed.gyro_rad_s.col(column).begin(), sensed.gyro_rad_s.col(column).end());
    accel.assign(sensed.accel_m_s2.col(column).begin(), sensed.accel_m_s2.col(column).end());
    if (noise == nullptr) continue;
    for (double& value : gyro) value += kGyroStep / 2 * rng.normal();
    for (double& value : accel) value += kAccelStep / 2 * rng.normal();
    roundTo(kGyroStep, gyro);
    roundTo(kAccelStep, accel);
  }
  if (noise == nullptr) return;
  roundTo(0.1, log.board_v);
  for (std::size_t i = 0; i < kJoints; ++i) {
    roundTo(1. / 1023, plan.joints.logs[index * kJoints + i].load);
    roundTo(0.1, plan.joints.logs[index * kJoints + i].volt_v);
    roundTo(1, plan.joints.logs[index * kJoints + i].temp_c);
  }
}

}  // namespace darwinop::gap
