// Findings about each servo.
#include "hal/cm730/diagnosis/servo_rows.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "hal/cm730/diagnosis/chains.hpp"
#include "hal/cm730/diagnosis/readable_servo.hpp"

namespace darwinop::cm730 {
namespace {

Finding unreadableRow(Joint joint, const ServoFacts& servo) {
  if (!servo.garbled)
    return Finding::of(
        Kind::kServoUnreadable,
        servoName(joint) + ": answers pings only, so its status return level is 0 and its model is unknown",
        correctionRemedy(servo.level_correction));
  const std::string what = servoName(joint) + ": garbled replies";
  if (row(joint).id == 1)
    return Finding::of(Kind::kServoGarbled, what,
                       kIdOneTwice + std::string{", the id of a new servo: find the silent one, connect it alone and "
                                                 "set its id; otherwise check the cable"});
  return Finding::of(Kind::kServoGarbled, what,
                     "check the cable that leads to it, and that no other servo has this id");
}

std::string replaced(Joint joint) {
  return "a new servo has id 1 and 57142 baud: connect it alone and set id " + std::to_string(row(joint).id) +
         " and 1 Mbaud with the vendor's tool";
}

Finding silentRow(Joint joint, const RobotFacts& facts) {
  const Kind kind = isLeg(joint) ? Kind::kLegServoSilent : Kind::kServoSilent;
  const std::string what = servoName(joint) + ": silent";
  const std::string permit =
      isLeg(joint) ? "; if it is permanently missing, list it in [Robot] absent of robot.ini" : std::string{};
  const ChainBreak where = findBreak(facts, row(joint).chain);
  if (!where.first_silent || row(joint).id < row(*where.first_silent).id || where.silent == 1)
    return Finding::of(kind, what, "check its connectors; " + replaced(joint) + permit);
  if (joint != *where.first_silent) return Finding::of(kind, what + ", behind " + servoName(*where.first_silent), {});
  const std::string from = where.last_answering ? servoName(*where.last_answering) : feedName(facts.board);
  return Finding::of(kind, what + ", and all servos behind it in the chain",
                     "check the cable from " + from + " into " + servoName(joint) + permit);
}

}  // namespace

std::string servoName(Joint joint) {
  const JointRow& r = row(joint);
  return "servo " + std::to_string(r.id) + " " + std::string{r.name} + " (" + std::string{r.anatomical} + ")";
}

const char* feedName(const BoardFacts& board) {
  return board.absent ? "the adapter" : "the board";
}

void addServoRows(const RobotFacts& facts, Findings& rows) {
  if (std::ranges::none_of(facts.servo, [](const ServoFacts& s) { return s.found || s.garbled; })) {
    rows.push_back(facts.board.absent
                       ? Finding::of(Kind::kNoServo, "none of the servos answers on " + facts.port,
                                     kHowToSupply + std::string{"; check the cables from the adapter to the servos"})
                       : Finding::of(Kind::kNoServo, "none of the twenty servos answers although servo power is on",
                                     "check the cables from the board to the servos, then the board's servo fuse"));
    return;
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const ServoFacts& servo = facts.servo[i];
    if (servo.absent)
      rows.push_back(Finding::ok(servoName(joint) + ": listed as absent in robot.ini; not driven"));
    else if (servo.readable)
      rows.push_back(readableRow(joint, facts));
    else if (servo.found || servo.garbled)
      rows.push_back(unreadableRow(joint, servo));
    else
      rows.push_back(silentRow(joint, facts));
    rows.back().joint = joint;
  }
}

Findings underTorqueRows(const RobotFacts& facts) {
  const auto stiff = std::ranges::count_if(facts.servo, [](const auto& s) { return s.readable && s.torque_on; });
  if (stiff == 0) return {};
  return {Finding::of(
      Kind::kUnderTorque,
      std::to_string(stiff) + (stiff == 1 ? " servo is" : " servos are") + " under torque and no loop watches them",
      std::string{"hold the robot and "} + (facts.board.absent ? "cut the servos' supply" : "press RESET on its back") +
          " (all servos go limp)")};
}

}  // namespace darwinop::cm730
