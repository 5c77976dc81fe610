#include "gap/plant/body/stance_rates.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "twin/body/imu_axes.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/body/sensor_lag.hpp"

namespace darwinop::gap {
namespace {

constexpr double kLeadIn = 0.5;   // s before row 0, for delays and filters
constexpr double kWindow = 0.12;  // s, farthest sample
constexpr int kForwardOfFoot = 2, kLeftOfFoot = 0;

/// Slope at each time of a cubic through seven samples around it: flat to 5 Hz, where a parabola through five loses a
/// tenth. NaN: too few of them are known, or they are far apart.
std::vector<double> slopesOf(const std::vector<double>& time_s, const std::vector<double>& values) {
  constexpr std::size_t kSamples = 7;
  std::vector<double> out(time_s.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < time_s.size() && time_s.size() >= kSamples; ++row) {
    const std::size_t from = std::min(row < kSamples / 2 ? 0 : row - kSamples / 2, time_s.size() - kSamples);
    std::vector<std::size_t> near;
    for (std::size_t i = from; i < from + kSamples; ++i)
      if (std::abs(time_s[i] - time_s[row]) < kWindow && !std::isnan(values[i])) near.push_back(i);
    if (near.size() + 2 < kSamples) continue;
    Eigen::MatrixX4d powers(std::ssize(near), 4);
    Eigen::VectorXd at(std::ssize(near));
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      const double t = (time_s[near[static_cast<std::size_t>(i)]] - time_s[row]) / kWindow;
      powers.row(i) << 1, t, t * t, t * t * t;
      at[i] = values[near[static_cast<std::size_t>(i)]];
    }
    out[row] = powers.colPivHouseholderQr().solve(at)[1] / kWindow;
  }
  return out;
}

/// Values that are missing, linear between the nearest that are known; 0 where none is.
std::vector<double> interpolated(const std::vector<double>& time_s, std::vector<double> values) {
  std::vector<std::size_t> known;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isnan(values[row])) known.push_back(row);
  std::size_t next = 0;  // in `known`: the first at or after the row
  for (std::size_t row = 0; row < values.size(); ++row) {
    while (next < known.size() && known[next] < row) ++next;
    if (!std::isnan(values[row])) continue;
    if (known.empty()) {
      values[row] = 0;
    } else if (next == 0 || next == known.size()) {
      values[row] = values[next == 0 ? known.front() : known.back()];
    } else {
      const std::size_t before = known[next - 1], after = known[next];
      const double share = (time_s[row] - time_s[before]) / (time_s[after] - time_s[before]);
      values[row] = values[before] + share * (values[after] - values[before]);
    }
  }
  return values;
}

Eigen::Vector3d axisAt(const mjtNum* values) {
  return {values[0], values[1], values[2]};
}

/// Linear between rows, `ahead_s` after the time of each cycle; constant beyond the ends.
Eigen::MatrixX3d atCycles(const Eigen::MatrixX3d& rows, const std::vector<double>& time_s, double ahead_s,
                          double period_s, Eigen::Index lead, Eigen::Index cycles) {
  Eigen::MatrixX3d out(cycles, 3);
  std::size_t next = 0;
  for (Eigen::Index cycle = 0; cycle < cycles; ++cycle) {
    const double at = static_cast<double>(cycle - lead) * period_s + ahead_s;
    while (next < time_s.size() && time_s[next] < at) ++next;
    const auto after = static_cast<Eigen::Index>(std::min(next, time_s.size() - 1));
    if (next == 0 || next == time_s.size()) {
      out.row(cycle) = rows.row(after);
      continue;
    }
    const double share = (at - time_s[next - 1]) / (time_s[next] - time_s[next - 1]);
    out.row(cycle) = rows.row(after - 1) + share * (rows.row(after) - rows.row(after - 1));
  }
  return out;
}

/// As a trace has the rates of each cycle.
void sense(const twin::ImuSettings& imu, double period_s, Eigen::MatrixX3d& rates) {
  twin::SensorLag lag{period_s, imu.gyro_lowpass_s, imu.delay_s};
  for (Eigen::Index cycle = 0; cycle < rates.rows(); ++cycle) {
    const twin::SensorLag::Values rate{rates(cycle, 0), rates(cycle, 1), rates(cycle, 2)};
    if (cycle == 0)
      lag.fill(rate);
    else
      lag.next(rate);
    const twin::SensorLag::Values sensed = lag.now();
    for (std::size_t i = 0; i < sensed.size(); ++i) rates(cycle, static_cast<Eigen::Index>(i)) = sensed[i];
  }
}

}  // namespace

std::array<StanceRates, 2> stanceRates(const BodyCase& given, std::size_t log) {
  const twin::Model& model = given.joints.model;
  const twin::MjModelPtr compiled = twin::loadBody(model, false);
  const mjModel& m = *compiled;
  const twin::BodyMap map = twin::mapBody(m, model.body.xml);
  const twin::MjDataPtr data = twin::dataFor(m, model.body.xml);
  mjData& d = *data;
  const twin::ImuAxes mounted = twin::imuAxesOf(model);
  Eigen::Matrix3d sensor;
  for (Eigen::Index i = 0; i < 3; ++i) sensor.row(i) = axisAt(mounted.gyro[static_cast<std::size_t>(i)].data());
  const std::vector<double>& time = given.logs[log].time_s;
  const auto rows = static_cast<Eigen::Index>(time.size());
  std::array<std::vector<double>, kJoints> speed, angle;
  for (std::size_t i = 0; i < kJoints; ++i) {
    speed[i] = slopesOf(time, given.joint(log, i).position_rad);
    angle[i] = interpolated(time, given.joint(log, i).position_rad);
  }
  std::array<StanceRates, 2> out;
  std::array<Eigen::MatrixX3d, 2> rates;
  for (std::size_t foot = 0; foot < 2; ++foot)
    for (auto* of : {&rates[foot], &out[foot].forward, &out[foot].left}) of->setZero(rows, 3);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    for (std::size_t i = 0; i < kJoints; ++i) d.qpos[map.qpos[i]] = angle[i][r];
    mj_kinematics(&m, &d);
    // Columns: the gyroscope's axes in the world.
    const Eigen::Matrix3d trunk =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{d.xmat + 9 * map.trunk};
    const Eigen::Matrix3d into = sensor * trunk.transpose();
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const int sole = map.link[static_cast<std::size_t>(foot == 0 ? Joint::kFootR : Joint::kFootL)];
      Eigen::Vector3d rate = Eigen::Vector3d::Zero();
      for (int body = sole; body != map.trunk && body > 0; body = m.body_parentid[body])
        for (std::size_t i = 0; i < kJoints; ++i)
          if (map.link[i] == body) rate -= axisAt(d.xaxis + 3 * m.dof_jntid[map.dof[i]]) * speed[i][r];
      const Eigen::Matrix3d turned = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{d.xmat + 9 * sole};
      rates[foot].row(row) = into * rate;
      out[foot].forward.row(row) = into * turned.col(kForwardOfFoot);
      out[foot].left.row(row) = into * turned.col(kLeftOfFoot);
    }
  }
  for (std::size_t foot = 0; foot < 2; ++foot)
    for (Eigen::Index row = 0; row < rows; ++row) {
      out[foot].known.push_back(!rates[foot].row(row).hasNaN());
      if (out[foot].known.back()) continue;
      if (row > 0)
        rates[foot].row(row) = rates[foot].row(row - 1);
      else
        rates[foot].row(row).setZero();
    }
  const double period = model.servo.firmware_period_s;
  const auto lead = static_cast<Eigen::Index>(std::ceil(kLeadIn / period));
  const auto cycles = lead + static_cast<Eigen::Index>(std::lround(time.back() / period)) + 1;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    FloorTrace& trace = out[foot].trace;
    trace.gyro_rad_s = atCycles(rates[foot], time, period, period, lead, cycles);
    sense(model.imu, period, trace.gyro_rad_s);
    trace.accel_m_s2.setZero(cycles, 3);
    for (const double at : time)
      trace.cycle_of_row.push_back(lead + static_cast<Eigen::Index>(std::lround(at / period)));
  }
  return out;
}

}  // namespace darwinop::gap
