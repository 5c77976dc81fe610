#include "gap/plant/body/floor_roll_out.hpp"

#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "gap/plant/body/floor_parts.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "gap/plant/body/limb_parts.hpp"
#include "gap/plant/body/moving_imu.hpp"
#include "hal/body.hpp"
#include "twin/body/imu.hpp"
#include "twin/body/joint_torques.hpp"
#include "twin/body/mujoco_guard.hpp"

namespace darwinop::gap {
namespace {

constexpr double kStoodBefore = 1.5;  // s with the goals of row 0 before it, from rest in that pose

class FloorSimulation {
 public:
  FloorSimulation(const BodyCase& given, std::size_t log, const FloorHypothesis& hypothesis, const Disturbance* noise);
  FloorTrace run();

 private:
  void writeRow(std::size_t row);
  void cycle();
  [[nodiscard]] bool hasFailed() const;
  [[nodiscard]] const Trajectory& rowsOf(std::size_t joint) const { return given_.joint(log_, joint); }

  const BodyCase& given_;
  const BodyHypothesis& robot_;
  std::size_t log_;
  double period_;
  const double ambient_c_;
  std::vector<JointNoise> noise_;  // none: the run is exact
  std::vector<twin::Servo> servos_;
  twin::MjModelPtr model_;
  twin::BodyMap map_;
  std::unique_ptr<twin::JointTorques> torques_;
  twin::MjDataPtr data_;
  std::unique_ptr<twin::Imu> imu_;
  twin::Imu::Axes accel_m_s2_{};  // mean over the last cycle
  Drives drives_{};
  int steps_;  // in a period of the firmware
};

FloorSimulation::FloorSimulation(const BodyCase& given, std::size_t log, const FloorHypothesis& hypothesis,
                                 const Disturbance* noise)
    : given_{given},
      robot_{hypothesis.robot},
      log_{log},
      period_{hypothesis.robot.servos.servo.firmware_period_s},
      ambient_c_{hypothesis.robot.servos.servo.ambient_c},
      model_{bodyOf(given.joints.model, hypothesis)},
      map_{twin::mapBody(*model_, given.joints.model.body.xml)},
      steps_{static_cast<int>(std::lround(period_ / model_->opt.timestep))} {
  bool is_soft = false;
  std::array<double, kJoints> pose{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    Disturbance own = noise == nullptr ? Disturbance{} : *noise;
    own.seed = splitMix(own.seed * kJoints + i);
    if (noise != nullptr)
      noise_.emplace_back(own, own.seed, period_, 2 * kPi / hypothesis.robot.servos.servo.ticks_per_rev);
    servos_.push_back(servoOf(hypothesis.robot, static_cast<Joint>(i), noise == nullptr,
                              std::make_unique<Surroundings>(ambient_c_, noise == nullptr ? nullptr : &own, period_)));
    is_soft = is_soft || servos_[i].softGear();
    pose[i] = rowsOf(i).goal_rad.front();
  }
  if (is_soft) {
    const int finer = static_cast<int>(std::ceil(period_ / (steps_ * kElasticStep) - 1e-9));
    model_->opt.timestep /= finer, steps_ *= finer;
  }
  const std::string& file = given.joints.model.body.xml;
  torques_ = std::make_unique<twin::JointTorques>(*model_, map_, servos_, false);
  data_ = twin::dataFor(*model_, file);
  imu_ = std::make_unique<twin::Imu>(*model_, map_, tracedSensors(given.joints.model.imu), 0);
  twin::orThrow(file, [&] { placeAtRest(*model_, *data_, map_, pose, given_.logs[log_].lies_on); });
  data_->qpos[map_.trunk_qpos + 2] += hypothesis.engine.drop_m;
  for (std::size_t i = 0; i < kJoints; ++i) servos_[i].reset(pose[i], given.logs[log].session_start_s - kStoodBefore);
  torques_->reset(*data_, map_);
  imu_->reset(*model_, *data_);
}

void FloorSimulation::writeRow(std::size_t row) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    takeRow(rowsOf(i), row, drives_[i]);
    drives_[i].supply_v = supplyAt(given_.logs[log_], row, robot_);
  }
}

void FloorSimulation::cycle() {
  mjData& d = *data_;
  for (std::size_t i = 0; i < kJoints; ++i) {
    double seen = torques_->encoderRad(servos_[i], i, d.qpos[map_.qpos[i]]);
    ServoDrive drive = drives_[i];
    if (!noise_.empty()) {
      seen += noise_[i].encoder_rad * noise_[i].encoder.normal();
      drive.supply_v += noise_[i].supply_v.next();
    }
    servos_[i].firmware(drive, seen, d.qvel[map_.dof[i]]);
  }
  accel_m_s2_ = {};
  for (int step = 0; step < steps_; ++step) {
    torques_->step(*model_, d, map_, servos_);
    imu_->update(*model_, d);
    const twin::Imu::Axes now = imu_->accelerometer(*model_, d, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) accel_m_s2_[axis] += now[axis] / steps_;
  }
}

bool FloorSimulation::hasFailed() const {
  for (const mjtWarning kind :
       {mjWARN_INERTIA, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL, mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
    if (data_->warning[kind].number > 0) return true;
  return false;
}

FloorTrace FloorSimulation::run() {
  const std::vector<double>& time = rowsOf(0).time_s;
  const auto rows = static_cast<Eigen::Index>(time.size());
  const auto cycle_at = [&](double time_s) { return static_cast<Eigen::Index>(std::ceil(time_s / period_ - 1e-6)); };
  const Eigen::Index held = cycle_at(kStoodBefore), cycles = held + cycle_at(time.back());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  FloorTrace out{.position_rad = Eigen::MatrixXd::Constant(rows, kJoints, kNone),
                 .gyro_rad_s = Eigen::MatrixX3d::Constant(cycles, 3, kNone),
                 .accel_m_s2 = Eigen::MatrixX3d::Constant(cycles, 3, kNone),
                 .cycle_of_row = {}};
  for (const double at : time) out.cycle_of_row.push_back(held + cycle_at(at) - 1);
  writeRow(0);
  Eigen::Index next = 0;
  const auto simulate = [&](Eigen::Index to) {
    for (; next < to; ++next) {
      cycle();
      const twin::Imu::Axes gyro = imu_->gyro(*data_, 0);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        out.gyro_rad_s(next, axis) = gyro[static_cast<std::size_t>(axis)];
        out.accel_m_s2(next, axis) = accel_m_s2_[static_cast<std::size_t>(axis)];
      }
    }
  };
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    twin::orThrow(given_.joints.model.body.xml, [&] { simulate(out.cycle_of_row[r] + 1); });
    if (hasFailed()) break;
    for (std::size_t i = 0; i < kJoints; ++i)
      out.position_rad(row, static_cast<Eigen::Index>(i)) = servos_[i].signals().measured_rad;
    writeRow(r);
  }
  return out;
}

}  // namespace

FloorTrace rollOut(const BodyCase& given, std::size_t log, const FloorHypothesis& hypothesis,
                   const Disturbance* noise) {
  return FloorSimulation{given, log, hypothesis, noise}.run();
}

}  // namespace darwinop::gap
