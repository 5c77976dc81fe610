// Collects tracking errors, loads, faults and counters over a motion.
#include "managers/motion_watch/motion_watch.hpp"

#include <cmath>
#include <cstdio>

#include "core/faults.hpp"
#include "core/units.hpp"

namespace darwinop::motion {

namespace {

std::string peakText(const MotionWatch::Peak& peak, double scale, const char* unit) {
  if (std::isnan(peak.value)) return "not measured";
  char text[60];
  std::snprintf(text, sizeof text, "%5.1f %s at %6.2f s", peak.value * scale, unit, peak.seconds);
  return text;
}

/// "", or a line "title: 3 a, 2 b".
std::string lineOf(const std::string& title, const std::string& counts) {
  return counts.empty() ? "" : title + ": " + counts + '\n';
}

void add(std::string& counts, std::uint32_t before, std::uint32_t now, const std::string& what) {
  if (now > before) counts += (counts.empty() ? "" : ", ") + std::to_string(now - before) + " " + what;
}

}  // namespace

void MotionWatch::raise(Peak& peak, double value, double seconds) {
  if (!std::isnan(value) && !(value <= peak.value))
    peak = {value, seconds};  // a NaN peak is replaced by the first value
}

void MotionWatch::update(const Sensors& sensors, double seconds) {
  if (!first_) first_ = sensors;
  last_ = sensors;
  faults_ |= sensors.safety.active;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = sensors.joint[i];
    if (!joint.motion.fresh()) continue;
    raise(error_[i], std::abs(joint.commanded.value - joint.position.value), seconds);
    raise(load_[i], std::abs(joint.load), seconds);
  }
}

std::string MotionWatch::jointsText() const {
  std::string text;
  for (std::size_t i = 0; i < kJoints; ++i) {
    char name[20];
    std::snprintf(name, sizeof name, "%-11s", std::string{kJointTable[i].name}.c_str());
    text += name + peakText(error_[i], 1 / kRadPerDegree, "deg") + "   load " + peakText(load_[i], 100, "%") + '\n';
  }
  return text;
}

std::string MotionWatch::faultsText() const {
  if (!first_) return "no cycle received\n";
  std::string faults, limits, bus;
  for (std::size_t i = 0; i < kFaults; ++i)
    if (faults_[i]) faults += (faults.empty() ? "" : ", ") + std::string{kFaultTable[i].name};
  for (std::size_t i = 0; i < kLimits; ++i)
    add(limits, first_->safety.limit_hits[i], last_.safety.limit_hits[i], std::string{kLimitNames[i]});
  const LinkCounters &before = first_->link, &now = last_.link;
  add(bus, before.incomplete, now.incomplete, "incomplete answers");
  add(bus, before.retries, now.retries, "retries");
  add(bus, before.bad_checksums, now.bad_checksums, "bad checksums");
  add(bus, before.reconnects, now.reconnects, "reconnects");
  add(bus, first_->overruns, last_.overruns, "cycles too long");
  const std::string all = lineOf("faults (docs/faults.md)", faults) + lineOf("goals cut by the safety layer", limits) +
                          lineOf("bus and loop", bus);
  return all.empty() ? kNoFaults : all;
}

}  // namespace darwinop::motion
