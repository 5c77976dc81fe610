#include "gap/localize/body/stop_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

enum class SinceStop : std::uint8_t { kNotMet, kMet, kCaught };

/// One joint, row by row.
class StopContact {
 public:
  StopContact(const Link& link, const Trajectory& joint) : link_{link}, joint_{joint} {}

  SinceStop at(std::size_t row) {
    const double position = joint_.position_rad[row], time = joint_.time_s[row];
    if (std::isnan(position)) return since_;
    const bool is_limp = joint_.torque_on[row] == 0;
    const bool is_near = std::min(position - link_.low_rad, link_.high_rad - position) < thresholds::kStopMargin;
    if (is_limp && is_near) since_ = SinceStop::kMet;
    const bool is_on_its_way =
        since_ == SinceStop::kMet && std::abs(joint_.goal_rad[row] - position) > thresholds::kStopMargin;
    if (is_limp || is_on_its_way) on_since_s_ = time;
    if (since_ == SinceStop::kMet && time - on_since_s_ > thresholds::kCaught) {
      since_ = SinceStop::kCaught;
      caught_at_rad_ = position;
    }
    if (since_ == SinceStop::kCaught && std::abs(position - caught_at_rad_) > thresholds::kStopMargin)
      since_ = SinceStop::kNotMet;
    return since_;
  }

 private:
  const Link& link_;
  const Trajectory& joint_;
  SinceStop since_ = SinceStop::kNotMet;
  double on_since_s_ = 0, caught_at_rad_ = 0;
};

}  // namespace

std::vector<std::vector<bool>> lostAtStops(const BodyCase& given, std::size_t log, const Limb& limb) {
  std::vector<std::vector<bool>> lost(limb.size(), std::vector<bool>(given.logs[log].rows(), false));
  for (std::size_t i = 0; i < limb.size(); ++i) {
    const Trajectory& joint = given.joint(log, static_cast<std::size_t>(limb[i].joint));
    StopContact contact{limb[i], joint};
    for (std::size_t row = 0; row < joint.rows(); ++row) {
      const SinceStop since = contact.at(row);
      if (since == SinceStop::kMet)
        for (std::vector<bool>& of : lost) of[row] = true;
      if (since == SinceStop::kCaught) lost[i][row] = true;
    }
  }
  return lost;
}

}  // namespace darwinop::gap
