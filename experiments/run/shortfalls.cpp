#include "experiments/run/shortfalls.hpp"

#include <algorithm>
#include <cmath>

#include "core/text/number_text.hpp"

namespace darwinop::experiments {
namespace {

constexpr double kSame = 0.005;  // rad: three ticks, more than rounding to ticks

}  // namespace

Shortfalls::Shortfalls(const Plan& plan, const std::vector<Joint>& recorded, const std::bitset<kJoints>& absent) {
  for (const JointPlan& moved : plan.moved) moved_.set(index(moved.joint));
  for (const Joint joint : recorded) measured_.set(index(joint));
  measured_ = (measured_ | moved_) & ~absent;
  moved_ &= ~absent;
}

void Shortfalls::Range::include(double value) {
  if (std::isnan(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void Shortfalls::update(const Pose& asked, const Sensors& sensors) {
  hits_ = sensors.safety.limit_hits[static_cast<std::size_t>(Limit::kPosition)];
  if (steps_++ == 0) first_hits_ = hits_;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = sensors.joint[i];
    seen_[i].measured += joint.motion.fresh() ? 1U : 0U;
    seen_[i].asked.include(asked[i]);
    seen_[i].commanded.include(joint.commanded.value);
  }
}

bool Shortfalls::isUnmeasured(std::size_t joint) const {
  return measured_[joint] && steps_ > 0 && seen_[joint].measured * 2 <= steps_;
}

/// The counter alone does not name the joint. Ranges alone differ also where a phase ends before a goal is reached.
bool Shortfalls::isClamped(std::size_t joint) const {
  const Seen& seen = seen_[joint];
  return moved_[joint] && !isUnmeasured(joint) && hits_ != first_hits_ && seen.commanded.low <= seen.commanded.high &&
         (seen.asked.low < seen.commanded.low - kSame || seen.asked.high > seen.commanded.high + kSame);
}

std::string Shortfalls::unmeasuredText() const {
  std::string lines;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (isUnmeasured(i)) lines.append(kJointTable[i].name).append(kNotMeasured).append("\n");
  return lines;
}

std::string Shortfalls::clampedText() const {
  const auto range = [](const Range& of) { return text::fixedText(of.low, 3) + " to " + text::fixedText(of.high, 3); };
  std::string lines;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (isClamped(i))
      lines += std::string{kJointTable[i].name} + kGoalsClamped + range(seen_[i].asked) + " rad, sent " +
               range(seen_[i].commanded) + " rad\n";
  return lines;
}

}  // namespace darwinop::experiments
