#include "hal/cm730/diagnosis/silent_servos.hpp"

#include <bit>

#include "hal/cm730/diagnosis/chains.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"

namespace darwinop::cm730 {
namespace {

class SilentServos {
 public:
  explicit SilentServos(const RobotFacts& facts) : facts_{facts} {
    silent_ = jointsThat([&](std::size_t i) {
      const ServoFacts& servo = facts.servo[i];
      return !servo.absent && !servo.found && !servo.garbled && servo.late_answers == 0;
    });
    garbled_ = jointsThat([&](std::size_t i) { return !facts.servo[i].readable && facts.servo[i].garbled; });
  }

  std::vector<FaultPlace> run() {
    for (const Chain chain : {Chain::kRightArm, Chain::kLeftArm, Chain::kHead, Chain::kRightLeg, Chain::kLeftLeg})
      placeBreak(chain);
    forEachJoint(garbled_, [&](std::size_t i) { placeDuplicate(static_cast<Joint>(i)); });
    placeWrongId();
    forEachJoint(silent_, [&](std::size_t i) {
      places_.push_back(
          {BusFault::kServoSilent, only(static_cast<Joint>(i)), "a broken cable would silence more servos"});
    });
    return std::move(places_);
  }

 private:
  void placeBreak(Chain chain) {
    const ChainBreak where = findBreak(facts_, chain);
    if (!where.first_silent || where.silent < 2) return;
    const auto behind = jointsThat(
        silent_, [&](std::size_t i) { return kJointTable[i].chain == chain && i >= index(*where.first_silent); });
    if (static_cast<int>(behind.count()) != where.silent) return;
    FaultPlace place{BusFault::kChainBroken, only(*where.first_silent)};
    place.evidence = servoNames(behind) + " are silent: one broken cable is likelier than as many defects";
    place.from_text = where.last_answering ? servoName(*where.last_answering) : feedName(facts_.board);
    places_.push_back(std::move(place));
    silent_ &= ~behind;
  }

  /// Two servos reply at once under one id; a silent one is likely to be the second.
  void placeDuplicate(Joint owner) {
    FaultPlace place{BusFault::kDuplicateId, only(owner), "its replies are garbled"};
    place.other_text = "the new one";
    if (silent_.count() == 1 && garbled_.count() == 1) {
      place.other = static_cast<Joint>(std::countr_zero(silent_.to_ulong()));
      place.other_text = servoName(*place.other);
      place.evidence += ", and " + place.other_text + " is silent";
      silent_.reset();
    }
    places_.push_back(std::move(place));
  }

  void placeWrongId() {
    const auto& stray = facts_.observed.stray_ids;
    if (silent_.count() != 1 || stray.size() != 1) return;
    FaultPlace place{BusFault::kWrongId, silent_, "it is silent, and this id answers"};
    place.other_text = std::to_string(stray[0]);
    places_.push_back(std::move(place));
    silent_.reset();
  }

  const RobotFacts& facts_;
  std::bitset<kJoints> silent_, garbled_;
  std::vector<FaultPlace> places_;
};

}  // namespace

std::vector<FaultPlace> explainSilentServos(const RobotFacts& facts) {
  return SilentServos{facts}.run();
}

std::string servoNames(const std::bitset<kJoints>& joints) {
  if (joints.count() == 1) return servoName(static_cast<Joint>(std::countr_zero(joints.to_ulong())));
  std::string text = "servos";
  forEachJoint(joints, [&](std::size_t i) { text.append(" ").append(std::to_string(servoId(i))); });
  return text;
}

}  // namespace darwinop::cm730
