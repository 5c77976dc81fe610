#include "apps/calibrate/joints/offset_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apps/calibrate/joints/messages.hpp"
#include "apps/calibrate/messages.hpp"
#include "connect/robot_file.hpp"
#include "core/conversions.hpp"
#include "core/text/number_text.hpp"

namespace darwinop::calibrate {
namespace {

std::string nameOf(Joint joint) {
  return std::string{row(joint).name};
}

double offsetBefore(const cm730::JointOffsets& before, Joint joint) {
  return before.ticks(joint) * kRadPerTick;
}

bool isWritten(const JointOffset& one, const cm730::JointOffsets& before) {
  return one.observed && std::abs(offsetBefore(before, one.joint) + one.offset_rad) <= connect::kMostOffset;
}

}  // namespace

std::string asText(const std::vector<JointOffset>& found, const cm730::JointOffsets& before) {
  std::string out = "\n[Offsets]     before rad    after rad   change deg   standard deviation deg\n";
  std::string unknown;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const auto one = std::ranges::find(found, joint, &JointOffset::joint);
    if (one == found.end() || !one->observed) unknown += (unknown.empty() ? "" : ", ") + nameOf(joint);
    if (one == found.end()) continue;
    char line[200];
    std::snprintf(line, sizeof line, "%-12s %11.4f %12.4f %12.2f %12.2f%s\n", nameOf(joint).c_str(),
                  offsetBefore(before, joint), offsetBefore(before, joint) + one->offset_rad,
                  one->offset_rad / kRadPerDegree, one->sigma_rad / kRadPerDegree,
                  isWritten(*one, before) ? ""
                  : one->observed         ? messages::kHornIsFarOff
                                          : "   not written");
    out += line;
  }
  if (!unknown.empty()) out += "\n" + std::string{messages::kNotObserved} + unknown + messages::kByHand;
  return out;
}

std::vector<IniValue> iniValues(const std::vector<JointOffset>& found, const cm730::JointOffsets& before,
                                const std::string& date) {
  std::vector<IniValue> out;
  for (const JointOffset& one : found) {
    if (!isWritten(one, before)) continue;
    const double old = offsetBefore(before, one.joint);
    out.push_back(
        {nameOf(one.joint), text::fixedText(old + one.offset_rad, 4),
         date + ", by gravity, sd " + text::fixedText(one.sigma_rad, 4) + " rad, was " + text::fixedText(old, 4)});
  }
  return out;
}

}  // namespace darwinop::calibrate
