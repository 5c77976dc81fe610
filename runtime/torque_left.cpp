#include "runtime/torque_left.hpp"

#include <vector>

#include "core/text/joined.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

constexpr std::uint32_t kTwoRounds = 2 * kPollRound;

}  // namespace

JointSet everAnswered(const Sensors& seen) noexcept {
  JointSet present;
  for (std::size_t i = 0; i < kJoints; ++i) present[i] = seen.joint[i].polled.ever() || seen.joint[i].motion.ever();
  return present;
}

JointSet perhapsUnderTorque(const Sensors& seen, const JointSet& present) noexcept {
  const bool offline = seen.safety.state == State::kOffline;
  if (!offline && seen.board.motion.age <= kAnswerPatience && !seen.board.servo_power) return {};
  JointSet left;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    const bool polled = !offline && joint.polled.age <= kTwoRounds;
    left[i] = present[i] && (!polled || joint.torque_enabled);
  }
  return left;
}

std::string namesOf(const JointSet& joints) {
  if (joints.all()) return messages::kAllJoints;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (joints[i]) names.emplace_back(kJointTable[i].name);
  return text::joined(names);
}

}  // namespace darwinop::runtime
