#include "apps/calibrate/by_hand.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <istream>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "apps/calibrate/messages.hpp"
#include "connect/robot_file.hpp"
#include "core/conversions.hpp"
#include "core/text/number_text.hpp"

namespace darwinop::calibrate {
namespace {

constexpr Nanos kReadTime = std::chrono::seconds{2};  // every servo's torque is polled every 20 cycles
constexpr int kTriesPerJoint = 3;
constexpr double kStillRad = 3 * kRadPerTick;

struct Reading {
  HeldJoint held;
  bool known = false, under_torque = false;
};

std::optional<Reading> readJoint(runtime::RobotLink& link, Joint joint, const std::atomic<bool>& stop) {
  std::vector<double> angles;
  Reading out{.held = {joint, 0, 0}};
  const auto cycles = static_cast<std::uint64_t>(kReadTime / link.period());
  const std::uint64_t first = link.sensors().cycle + 1;
  for (std::uint64_t cycle = first; cycle < first + cycles; ++cycle) {
    if (!link.waitForCycle(cycle, stop)) return std::nullopt;
    const JointSensors seen = link.sensors().joint[index(joint)];
    if (seen.motion.fresh()) angles.push_back(seen.position.value);
    out.under_torque = out.under_torque || (seen.polled.fresh() && seen.torque_enabled);
  }
  out.known = angles.size() >= cycles / 2;
  for (const double angle : angles) out.held.reading_rad += angle / static_cast<double>(angles.size());
  for (const double angle : angles)
    out.held.spread_rad = std::max(out.held.spread_rad, std::abs(angle - out.held.reading_rad));
  return out;
}

std::string nameOf(Joint joint) {
  return std::string{row(joint).name};
}

double offsetAfter(const HeldJoint& one, const cm730::JointOffsets& before) {
  return before.ticks(one.joint) * kRadPerTick + one.reading_rad;
}

bool isWithinRange(const HeldJoint& one, const cm730::JointOffsets& before) {
  return std::abs(offsetAfter(one, before)) <= connect::kMostOffset;
}

}  // namespace

std::vector<HeldJoint> readHeldJoints(runtime::RobotLink& link, const std::vector<Joint>& joints, std::istream& answers,
                                      const std::atomic<bool>& stop, std::ostream& log) {
  std::vector<HeldJoint> out;
  for (const Joint joint : joints) {
    for (int tries = 0; tries < kTriesPerJoint; ++tries) {
      log << '\n'
          << nameOf(joint) << " (" << row(joint).anatomical
          << "): hold it at zero.\n  Enter when it is there; s and Enter: skip; q and Enter: end > " << std::flush;
      std::string answer;
      if (!std::getline(answers, answer) || answer == "q") return out;
      if (answer == "s") break;
      const auto reading = readJoint(link, joint, stop);
      if (!reading && stop) return out;
      if (!reading) throw std::runtime_error(messages::kNoReadings + link.whyEnded());
      const char* const wrong = !reading->known                        ? messages::kServoIsSilent
                                : reading->under_torque                ? messages::kUnderTorque
                                : reading->held.spread_rad > kStillRad ? messages::kJointMoved
                                                                       : nullptr;
      if (wrong == nullptr) {
        out.push_back(reading->held);
        break;
      }
      log << nameOf(joint) << wrong << '\n';
    }
  }
  return out;
}

std::string asText(const std::vector<HeldJoint>& held, const cm730::JointOffsets& before) {
  std::string out = "\n[Offsets]     before rad    after rad   change deg\n";
  for (const HeldJoint& one : held) {
    char line[200];
    std::snprintf(line, sizeof line, "%-12s %11.4f %12.4f %12.2f%s\n", nameOf(one.joint).c_str(),
                  before.ticks(one.joint) * kRadPerTick, offsetAfter(one, before), one.reading_rad / kRadPerDegree,
                  isWithinRange(one, before) ? "" : messages::kHornIsFarOff);
    out += line;
  }
  return out;
}

std::vector<IniValue> iniValues(const std::vector<HeldJoint>& held, const cm730::JointOffsets& before,
                                const std::string& date) {
  std::vector<IniValue> out;
  for (const HeldJoint& one : held)
    if (isWithinRange(one, before))
      out.push_back({nameOf(one.joint), text::fixedText(offsetAfter(one, before), 4),
                     date + ", held by hand, spread " + text::fixedText(one.spread_rad, 4) + " rad, was " +
                         text::fixedText(before.ticks(one.joint) * kRadPerTick, 4)});
  return out;
}

}  // namespace darwinop::calibrate
