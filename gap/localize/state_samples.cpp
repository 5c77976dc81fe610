#include "gap/localize/state_samples.hpp"

#include <cmath>
#include <utility>

#include "gap/localize/regions.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

const std::vector<StateVariable>& stateVariables() {
  static const std::vector<StateVariable> all{
      {"position", "rad", [](const auto& log, auto row, double, double) { return log.position_rad[row]; }},
      {"speed", "rad/s", [](const auto&, auto, double speed, double) { return std::abs(speed); }},
      {"direction", "",
       [](const auto&, auto, double speed, double) {
         return std::abs(speed) < thresholds::kDirectionSpeed ? 0 : std::copysign(1, speed);
       }},
      {"error", "rad",
       [](const auto& log, auto row, double, double) { return std::abs(log.goal_rad[row] - log.position_rad[row]); }},
      {"load", "", [](const auto& log, auto row, double, double) { return log.load[row]; }},
      {"temperature", "degC", [](const auto& log, auto row, double, double) { return log.temp_c[row]; }},
      {kSessionTime, "s",
       [](const auto& log, auto row, double, double) {
         return log.is_session_known ? log.session_start_s + log.time_s[row] - log.time_s[0] : std::nan("");
       }},
      {"time since reversal", "s", [](const auto&, auto, double, double since) { return since; }},
      {"payload", "kg", [](const auto& log, auto, double, double) { return log.payload_kg; }},
      {"P register", "", [](const auto& log, auto, double, double) { return log.p_register; }},
      {"torque", "", [](const auto& log, auto row, double, double) { return log.torque_on[row] != 0 ? 1.0 : 0.0; }},
  };
  return all;
}

void addSamples(const Trajectory& log, const Eigen::VectorXd& z, const std::vector<std::size_t>& rows,
                std::vector<StateSample>& into) {
  double turned_s = log.time_s.front(), direction = 0;
  std::vector<double> speed(log.rows()), since(log.rows());
  for (std::size_t row = 0; row < log.rows(); ++row) {
    speed[row] = stateAt(log, row).speed_rad_s;
    const double now = std::abs(speed[row]) < thresholds::kDirectionSpeed ? direction : std::copysign(1, speed[row]);
    if (now != direction) turned_s = log.time_s[row], direction = now;
    since[row] = log.time_s[row] - turned_s;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    StateSample sample{.z = z[static_cast<Eigen::Index>(i)], .state = {}, .cell = 0};
    for (const StateVariable& variable : stateVariables())
      sample.state.push_back(variable.value(log, rows[i], speed[rows[i]], since[rows[i]]));
    into.push_back(std::move(sample));
  }
}

}  // namespace darwinop::gap
