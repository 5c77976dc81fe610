// Logs begin and end of each fault.
#include "runtime/fault_announcer.hpp"

#include <ostream>

namespace darwinop::runtime {
namespace {

std::string nameOf(const FaultRow& fault) {
  return "darwinop: fault " + std::to_string(static_cast<int>(fault.fault)) + " " + std::string{fault.name};
}

/// The joint is known for the worst fault only.
std::string jointOf(const FaultRow& fault, const SafetyReport& safety) {
  if (fault.fault != safety.worst || safety.worst_joint < 1 || safety.worst_joint > kJoints) return {};
  return " (" + std::string{kJointTable[safety.worst_joint - 1U].name} + ", id " + std::to_string(safety.worst_joint) +
         ")";
}

std::string times(std::uint32_t count) {
  return std::to_string(count) + (count == 1 ? " time" : " times");
}

}  // namespace

void FaultAnnouncer::update(const Sensors& seen) {
  if (seen.cycle == 0) return;
  for (std::size_t i = 0; i < kFaults; ++i) {
    const std::string line = change(memory_[i], i, seen);
    if (!line.empty()) out_ << line << std::flush;  // one write: other threads use the same stream
  }
}

/// With on_fall = limp the limbs fall: that no setup expects.
std::string_view FaultAnnouncer::remedyOf(const FaultRow& fault, const SafetyReport& safety) const {
  const bool is_expected = trunk_is_held_ && fault.fault == Fault::kFell && safety.reaction != Reaction::kLimp;
  return is_expected ? kExpected : fault.remedy;
}

std::string FaultAnnouncer::change(Memory& memory, std::size_t fault, const Sensors& seen) const {
  const FaultRow& row = kFaultTable[fault];
  const bool active = seen.safety.active[fault];
  const bool begins = active && !memory.active;
  memory.active = active;
  if (memory.reported) {
    memory.reported = active;
    return active ? "" : nameOf(row) + kIsOver;
  }
  if (memory.ever && seen.time_ns - memory.reported_ns < kQuietNs) {
    if (begins) ++memory.left_out;
    return {};
  }
  // A fault that began within kQuietNs and is still active is reported now, not counted as omitted.
  if (active && !begins && memory.left_out > 0) --memory.left_out;
  std::string line;
  if (memory.left_out > 0) line = nameOf(row) + kCameAndWent + times(memory.left_out) + " more\n";
  memory.left_out = 0;
  if (!active) return line;
  memory.reported = memory.ever = true;
  memory.reported_ns = seen.time_ns;
  return line + nameOf(row) + jointOf(row, seen.safety) + ": " + std::string{row.meaning} + "; " +
         std::string{remedyOf(row, seen.safety)} + "\n";
}

}  // namespace darwinop::runtime
