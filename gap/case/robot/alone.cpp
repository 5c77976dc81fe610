#include "gap/case/robot/alone.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace darwinop::gap {
namespace {

constexpr double kShortest = 2;  // s; a log of a case needs as much

using Values = std::vector<double>;

/// Mean over rows; what is not known does not count.
double mean(const Values& values, std::size_t from, std::size_t to) {
  double sum = 0, count = 0;
  for (std::size_t row = from; row < to; ++row)
    if (!std::isnan(values[row])) sum += values[row], ++count;
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / count;
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

class Reader {
 public:
  Reader(const logs::Log& log, Joint joint) : log_{log}, joint_{joint} {
    if (!log.recording)
      throw std::runtime_error(log.file +
                               ": not a recording of the runtime; make one with darwinop experiment run, or "
                               "write a case.json for it, docs/gap/cases.md");
    for (std::size_t i = 0; i < kJoints; ++i) {
      const std::string name{kJointTable[i].name};
      commanded_.push_back(&log.column(name + ".commanded").values);
      position_.push_back(&log.column(name + ".position").values);
    }
    const std::string name{kJointTable[static_cast<std::size_t>(joint)].name};
    p_gain_ = &log.column(name + ".asked_p_gain").values;
    speed_ = &log.column(name + ".asked_speed").values;
    for (std::size_t k = 0; k < 3; ++k) accel_[k] = &log.column(std::string{"accelerometer."} + "xyz"[k]).values;
    supply_ = &log.column("board.voltage").values;
    own_voltage_ = &log.column(name + ".voltage").values;
  }

  std::vector<AlonePart> parts() const {
    std::vector<AlonePart> found;
    std::size_t from = 0;
    for (std::size_t row = 1; row <= log_.rows(); ++row) {
      if (row < log_.rows() && goesOn(row)) continue;
      if (log_.seconds(row - 1) - log_.seconds(from) >= kShortest && moves(from, row)) found.push_back(part(from, row));
      from = row;
    }
    return found;
  }

 private:
  [[nodiscard]] const Values& own() const { return *commanded_[static_cast<std::size_t>(joint_)]; }

  [[nodiscard]] bool goesOn(std::size_t row) const {
    for (std::size_t i = 0; i < kJoints; ++i)
      if (i != static_cast<std::size_t>(joint_) && !same((*commanded_[i])[row], (*commanded_[i])[row - 1]))
        return false;
    return same((*p_gain_)[row], (*p_gain_)[row - 1]) && same((*speed_)[row], (*speed_)[row - 1]);
  }
  /// It is driven at first, and its goal changes later.
  [[nodiscard]] bool moves(std::size_t from, std::size_t to) const {
    if (std::isnan(own()[from])) return false;
    for (std::size_t row = from + 1; row < to; ++row)
      if (!same(own()[row], own()[from])) return true;
    return false;
  }
  [[nodiscard]] AlonePart part(std::size_t from, std::size_t to) const {
    AlonePart out{.from_s = log_.seconds(from),
                  .to_s = log_.seconds(to - 1),
                  .goal_before_rad = from > 0 ? own()[from - 1] : std::numeric_limits<double>::quiet_NaN(),
                  .angles_rad = {},
                  .accel_m_s2 = {},
                  .supply_v = mean(*supply_, from, to)};
    for (std::size_t i = 0; i < kJoints; ++i) out.angles_rad[i] = mean(*position_[i], from, to);
    if (std::isnan(out.supply_v)) out.supply_v = mean(*own_voltage_, from, to);
    for (std::size_t k = 0; k < 3; ++k) out.accel_m_s2[k] = mean(*accel_[k], from, to);
    return out;
  }

  const logs::Log& log_;
  Joint joint_;
  std::vector<const Values*> commanded_, position_;
  const Values *p_gain_, *speed_, *supply_, *own_voltage_;
  std::array<const Values*, 3> accel_;
};

}  // namespace

std::vector<AlonePart> aloneParts(const logs::Log& recording, Joint joint) {
  return Reader{recording, joint}.parts();
}

}  // namespace darwinop::gap
