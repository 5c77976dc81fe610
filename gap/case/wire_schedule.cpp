// A cycle is one write of all goals, one request, and replies one after the other: the board's, then the servos' in the
// order of their ids (hal/cm730/read_list.hpp). A servo's registers are those of the begin of its reply.
#include "gap/case/wire_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace darwinop::gap {
namespace {

constexpr double kBytesPerMs = 100;

/// Of the frame that carries the goals, in a cycle with a usual board reply: 8, and per servo id and goal. Stands in
/// where a reply is missing and the rest of the bytes cannot be assigned.
constexpr double kGoalsOnly = 8 + 20 * 3;

bool everAnswers(const Trajectory& joint) {
  return std::ranges::any_of(joint.position_rad, [](double value) { return !std::isnan(value); });
}

}  // namespace

CycleSchedule cycleSchedule(double total_bytes, std::span<const double> replies) {
  double request = wire::kOfRequest, replied = wire::kOfBoard;
  bool is_complete = true;
  for (const double bytes : replies) {
    request += wire::kOfRequestEach;
    replied += bytes;
    is_complete = is_complete && bytes > 0;
  }
  double written = total_bytes - request - replied;
  if (!is_complete || !(written >= kGoalsOnly)) written = kGoalsOnly;
  CycleSchedule out{written * wire::kByte, (written + request) * wire::kByte, {}};
  out.servo_s.reserve(replies.size());
  // The board's reply is up to kOfTag bytes longer than usual. They count as written: what is read comes after both.
  double at = written + request + wire::kOfBoard;
  for (const double bytes : replies) {
    out.servo_s.push_back(at * wire::kByte);
    at += bytes;
  }
  return out;
}

void fillWireSchedule(const logs::Log& recording, std::span<Trajectory> joints) {
  const logs::Column* const total = recording.find("bus.wire");
  if (total == nullptr || total->unit != "ms") return;
  for (Trajectory& joint : joints) joint.written_s.clear(), joint.read_s.clear();
  std::vector<Trajectory*> present;
  for (Trajectory& joint : joints)
    if (everAnswers(joint)) present.push_back(&joint);
  std::vector<double> replies(present.size());
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    for (std::size_t i = 0; i < present.size(); ++i) {
      const bool is_polled = !std::isnan(present[i]->volt_v[row]);
      replies[i] = std::isnan(present[i]->position_rad[row]) ? 0 : is_polled ? wire::kOfPolled : wire::kOfServo;
    }
    const CycleSchedule cycle = cycleSchedule(total->values[row] * kBytesPerMs, replies);
    for (Trajectory& joint : joints) {
      joint.written_s.push_back(cycle.written_s);
      joint.read_s.push_back(cycle.board_s);  // of one that never answers: it is not read
    }
    for (std::size_t i = 0; i < present.size(); ++i) present[i]->read_s.back() = cycle.servo_s[i];
  }
}

bool isInLockstep(const logs::Log& recording) {
  const std::optional<std::string> model = recording.headValue("model");
  return model && model->find(" in memory") != std::string::npos;
}

}  // namespace darwinop::gap
