// What the judge at the servos reports: sums, and the history of a servo whose promise was broken.
#include <string>

#include "campaign/servo_judge.hpp"

namespace darwinop {

ServoJudge::Tally& ServoJudge::Tally::operator+=(const Tally& other) {
  edges += other.edges;
  steps += other.steps;
  trips += other.trips;
  releases += other.releases;
  outages += other.outages;
  limp_looks += other.limp_looks;
  late += other.late;
  blind += other.blind;
  damaged += other.damaged;
  tolerated += other.tolerated;
  for (std::size_t i = 0; i < kPromises; ++i) broken[i] += other.broken[i];
  return *this;
}

void ServoJudge::note(Joint joint, const char* what) {
  Servo& servo = servo_[index(joint)];
  servo.history[servo.happened++ % kHistory] = {cycle_, what, robot_.board().servo(joint).state(), truth(joint)};
}

std::string ServoJudge::historyOf(Joint joint) const {
  const Servo& servo = servo_[index(joint)];
  std::string text = "\n  state " + std::string{kStateNames[static_cast<std::size_t>(state_)]};
  for (std::size_t i = servo.happened > kHistory ? servo.happened - kHistory : 0; i < servo.happened; ++i) {
    const auto& [cycle, what, state, position] = servo.history[i % kHistory];
    text += "\n  cycle " + std::to_string(cycle) + ": " + what + "; torque " + (state.torque_enable ? "on" : "off") +
            ", limit " + std::to_string(state.torque_limit) + ", speed " + std::to_string(state.speed) + ", goal " +
            std::to_string(state.goal) + ", joint at " + std::to_string(static_cast<int>(position));
  }
  return text;
}

void ServoJudge::blame(Promise promise, Joint joint, const std::string& what) {
  blame(promise, std::string{row(joint).name} + ": " + what + (failure_.empty() ? historyOf(joint) : ""));
}

void ServoJudge::blame(Promise promise, const std::string& what) {
  ++tally_.broken[static_cast<std::size_t>(promise)];
  if (failure_.empty()) failure_ = "cycle " + std::to_string(cycle_) + ": " + what;
}

}  // namespace darwinop
