// Detects a position that stays constant while load, goal or speed show that the joint moves.
//
// A constant position alone is not enough: with dry friction a joint under torque has been measured to keep its
// position to the last step for 3 s, while its goal moved by 0.3 rad and its load by 60 % of full, one way. But
// friction cannot hold a joint against a strong push one way and then the other.
#include <algorithm>
#include <cmath>

#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kStill = 0.3;       // s
constexpr double kReaction = 0.1;    // s, longest delay of a servo; what comes later in a standstill may be its end
constexpr double kStrong = 0.4;      // of full duty, both ways
constexpr double kSameLoad = 0.005;  // 0.1 % is a count
constexpr double kMoving = 0.2;      // rad/s in the speed register: 16 counts
constexpr double kGoals = 0.05;      // rad, of goals that must move a joint somehow

struct Span {
  double low = 0, high = 0;
  bool known = false;
  void add(double value) {
    if (std::isnan(value)) return;
    low = known ? std::min(low, value) : value;
    high = known ? std::max(high, value) : value;
    known = true;
  }
  [[nodiscard]] bool bothWays() const { return low < -kStrong && high > kStrong; }
  [[nodiscard]] double width() const { return high - low; }
};

/// Duty by the control law of the baseline, -1 to 1; law speed_p: speed instead of duty. Shifted by up to
/// a row, which does not matter here.
double wanted(const Trajectory& log, std::size_t row, const Case& c) {
  const twin::ServoParameters& servo = c.model.servo;
  const double error = log.p_register * (log.goal_rad[row] - log.position_rad[row]);
  if (servo.law == twin::Law::kVoltageP) return std::clamp(servo.duty_per_kp_per_rad * error, -1.0, 1.0);
  return std::clamp(servo.speed_gain_per_kp_1_s * error / servo.speed_max_rad_s, -1.0, 1.0);
}

void judge(const Trajectory& log, std::size_t from, std::size_t to, const std::string& file, const Case& c) {
  Span load, duty;
  double speed = 0;
  std::size_t speeds = 0, rows = 0;
  for (std::size_t i = from; i <= to && log.time_s[i] <= log.time_s[to] - kReaction; ++i) {
    ++rows;
    load.add(log.load[i]);
    duty.add(wanted(log, i, c));
    if (std::isnan(log.speed_rad_s[i])) continue;
    speed += std::abs(log.speed_rad_s[i]);
    ++speeds;
  }
  const std::string place = file + ", line " + std::to_string(log.lines[from]) + ": pos stays the same for " +
                            std::to_string(std::lround((log.time_s[to] - log.time_s[from]) * 1000)) + " ms from here, ";
  const std::string advice = "; the sensor is stuck, or old readings were logged again. Measure again";
  if (load.known ? load.bothWays() : duty.bothWays()) throw BadInput(place + messages::kStuckDespiteLoad + advice);
  if (load.known && load.width() < kSameLoad && duty.bothWays())
    throw BadInput(place + messages::kStuckLikeLoad + advice);
  if (speeds > rows / 2 && speed / double(speeds) > kMoving)
    throw BadInput(place + messages::kStuckDespiteSpeed + advice);
}

}  // namespace

void checkSensor(const Trajectory& log, const std::string& file, const Case& c) {
  Span goal, position;
  for (std::size_t i = 0; i < log.rows(); ++i) {
    position.add(log.position_rad[i]);
    if (log.torque_on[i] != 0) goal.add(log.goal_rad[i]);
  }
  if (position.width() == 0 && goal.known && goal.width() > kGoals)
    throw BadInput(file + ", line " + std::to_string(log.lines.front()) +
                   ": pos never changes, though torque is on and the goals move; is the sensor stuck, or is this the "
                   "position of another joint?");
  for (std::size_t from = 0; from < log.rows();) {
    std::size_t to = from;
    while (to + 1 < log.rows() && log.position_rad[to + 1] == log.position_rad[from] &&
           log.torque_on[to + 1] == log.torque_on[from])
      ++to;
    if (log.torque_on[from] != 0 && log.time_s[to] - log.time_s[from] >= kStill) judge(log, from, to, file, c);
    from = to + 1;
  }
}

}  // namespace darwinop::gap
