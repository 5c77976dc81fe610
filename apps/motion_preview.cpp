// Preview of `darwinop motion play`.
#include "motion_preview.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "core/goals/lead_in.hpp"
#include "core/text/number_text.hpp"
#include "managers/motion/first_step.hpp"
#include "managers/motion_text/dry_run.hpp"
#include "motion_messages.hpp"
#include "motion_print.hpp"
#include "webots/motion_playback.hpp"

namespace darwinop::motion {

namespace {

struct FarJoint {
  std::size_t joint = 0;
  double way = 0;  // rad
};

/// "its first pose is 75.6 degrees away (LegLowerR)", and the duration of the lead-in.
std::string wayText(const FarJoint& far, bool is_led) {
  std::string text = "its first pose is " + text::fixedText(far.way / kRadPerDegree, 1) + " degrees away";
  if (far.way > 0) text += " (" + std::string{kJointTable.at(far.joint).name} + ")";
  if (is_led) text += kLeadIn + text::fixedText(goals::LeadIn::durationMs(far.way) / 1000, 1) + " s";
  return text;
}

Pose startTicks() {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = kJointTable[i].start;
  return pose;
}

FarJoint farthest(const Pose& from, const Pose& to) {
  FarJoint far;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (const double way = std::abs(to[i] - from[i]) * kRadPerTick; way > far.way) far = {i, way};
  return far;
}

}  // namespace

std::string previewOf(const PageFile& file, const std::vector<int>& pages) {
  std::string text;
  Pose pose = startTicks();
  for (const int number : pages) {
    const Page& page = file.at(static_cast<std::size_t>(number));
    const Pose target = firstTarget(page, pose);
    const bool is_led = firstStepSpeed(page, pose) > kFastestFirstStep;
    const FarJoint far = farthest(pose, target);
    const DryRun played = dryRun(file, number, is_led ? target : pose);
    pose = played.poses.back();
    text += "page " + std::to_string(number) + " \"" + nameOf(page) +
            "\": " + text::fixedText(static_cast<double>(played.poses.size() - 1) * kTickMs / 1000, 1) + " s";
    if (played.sections.size() > 1) text += ", including its successors";
    if (played.cut) text += kRepeatsForever;
    text += "; " + wayText(far, is_led) + '\n';
  }
  return text;
}

std::string previewOf(const webots_api::MotionText& motion, const std::string& file) {
  FarJoint far;
  for (const webots_api::MotionCurve& curve : motion.curves) {
    const auto joint = findJoint(curve.motor);
    const auto first = curve.atOrFirst(0);
    if (!joint || !first) continue;
    const double way = std::abs(*first - radFromTicks(row(*joint).start).value);
    if (way > far.way) far = {index(*joint), way};
  }
  return file + ": " + text::fixedText(motion.duration_ms / 1000.0, 1) + " s; " +
         wayText(far, far.way > webots_api::MotionPlayback::kNear) + '\n';
}

}  // namespace darwinop::motion
