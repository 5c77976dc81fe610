#include "gap/benchmark/body/body_physics.hpp"

#include <cmath>

#include "gap/benchmark/body/body_registers.hpp"
#include "gap/benchmark/body/soft_body.hpp"

namespace darwinop::gap {
namespace {

constexpr double kFallen = 0.6;  // cosine between the trunk's axis and the vertical

using MapR = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

}  // namespace

bool SoftBody::run() {
  const std::vector<double>& time = log_.time_s;
  const auto rows = static_cast<Eigen::Index>(time.size());
  const auto cycle_at = [&](double time_s) { return static_cast<Eigen::Index>(std::ceil(time_s / period_ - 1e-6)); };
  const double held_s = isClamped() ? kHeldClamped : kHeldFree;
  const Eigen::Index held = cycle_at(held_s), cycles = held + cycle_at(time.back());
  FloorTrace trace{.position_rad = Eigen::MatrixXd::Zero(rows, kJoints),
                   .gyro_rad_s = Eigen::MatrixX3d::Zero(cycles, 3),
                   .accel_m_s2 = Eigen::MatrixX3d::Zero(cycles, 3),
                   .cycle_of_row = {}};
  for (const double at : time) trace.cycle_of_row.push_back(held + cycle_at(at) - 1);
  time_s_ = -held_s;
  writeRow(0);
  log_.board_v.assign(log_.rows(), log_.battery_v);
  Rng board{splitMix(noise_ == nullptr ? 0 : noise_->seed)};
  bool fell = false;
  Eigen::Index next = 0;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    twin::orThrow(plan_.joints.model.body.xml, [&] {
      for (; next < trace.cycle_of_row[r] + 1; ++next) {
        cycle();
        const twin::Imu::Axes gyro = imu_->gyro(*data_, 0);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
          trace.gyro_rad_s(next, axis) = gyro[static_cast<std::size_t>(axis)];
          trace.accel_m_s2(next, axis) = accel_m_s2_[static_cast<std::size_t>(axis)];
        }
      }
    });
    double drawn_a = 0;
    for (std::size_t i = 0; i < kJoints; ++i) {
      const twin::Signals& s = servos_[i].signals();
      Trajectory& rows_of = rowsOf(i);
      rows_of.position_rad[r] = trace.position_rad(row, static_cast<Eigen::Index>(i)) = s.measured_rad;
      rows_of.load[r] = s.torque_on ? s.duty : 0;
      rows_of.volt_v[r] = supply_v_[i];
      rows_of.temp_c[r] = ambient_c_;
      drawn_a += s.duty * s.current_a;
    }
    log_.board_v[r] = log_.battery_v - truth_.battery_ohm * drawn_a + (noise_ == nullptr ? 0 : 0.01 * board.normal());
    const double upright = MapR{data_->xmat + 9 * map_.trunk}(2, 1);
    fell = fell || (log_.setup == BodySetup::kFloor && upright < kFallen);
    writeRow(r);
  }
  readSensors(plan_, log_index_, trace, truth_.model.imu, noise_);
  return fell;
}

bool measureBody(BodyCase& plan, std::size_t log, const BodyTruth& truth, const Disturbance* noise) {
  return SoftBody{plan, log, truth, noise}.run();
}

}  // namespace darwinop::gap
