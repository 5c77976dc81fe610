// The faults of the blind test.
#include <algorithm>

#include "core/conversions.hpp"
#include "hal/cm730/diagnosis/drawn_robot.hpp"
#include "hal/cm730/diagnosis/draws.hpp"

namespace darwinop::cm730 {
namespace {

constexpr double kObserved = 10;  // s; longer than an examination

void drawLimits(RobotDraw& drawn, Rng& rng) {
  hil::ServoOptions& servo = anyServo(drawn, rng);
  const JointRow& joint = kJointTable[static_cast<std::size_t>(&servo - drawn.board.servo.data())];
  const auto inside = static_cast<std::uint16_t>(rng.between(joint.low + 50, joint.high - 50));
  if (rng.coin())
    servo.cw_limit = inside;
  else
    servo.ccw_limit = inside;
}

void drawSwapped(RobotDraw& drawn, Rng& rng) {
  std::size_t a = 0, b = 0;
  twoServos(rng, a, b);
  if (a > b) std::swap(a, b);
  drawn.joints.set(a);
  drawn.other = static_cast<Joint>(b);
  drawn.board.servo[a].id = servoId(b);
  drawn.board.servo[b].id = servoId(a);
  for (std::size_t i = 0; i < kJoints; ++i)  // the page asks for the start pose
    drawn.position_rad[i] = radFromTicks(kJointTable[i].start).value + rng.between(-0.08, 0.08);
}

void drawDuplicate(RobotDraw& drawn, Rng& rng) {
  std::size_t owner = 0, second = 0;
  twoServos(rng, owner, second);
  drawn.board.servo[second].id = servoId(owner);
  drawn.joints.set(owner);
  drawn.other = static_cast<Joint>(second);
}

void drawBreak(RobotDraw& drawn, Rng& rng) {
  std::vector<std::size_t> behind;
  while (behind.size() < 2) behind = jointsFrom(rng.below(kJoints));
  drawn.joints.set(behind.front());
  for (const std::size_t i : behind) drawn.board.servo[i].missing = true;
}

void drawLooseConnector(RobotDraw& drawn, Rng& rng) {
  const auto behind = jointsFrom(rng.below(kJoints));
  drawn.joints.set(behind.front());
  for (double at = rng.between(0, 0.2); at < kObserved; at += rng.between(0.1, 0.3)) {
    hil::InjectedFault open = fault(hil::FaultKind::kDead, at);
    open.lasts = hil::faultTime(rng.between(0.02, 0.08));
    open.boot = hil::faultTime(rng.between(0.005, 0.02));
    for (const std::size_t i : behind) open.joints.set(i);
    drawn.script.push_back(open);
  }
}

void drawBrownOut(RobotDraw& drawn, Rng& rng) {
  drawn.torque_on = drawn.board.servo_power = true;
  drawn.load = rng.between(0.3, 0.6);
  const bool restarts = rng.coin();
  const double drop = restarts ? rng.between(7.5, 12) : drawn.board.supply_v - rng.between(8, 10.8);
  drawn.script.push_back(fault(hil::FaultKind::kSag, restarts ? rng.between(0.8, 1.4) : 0, drop / drawn.load));
}

void drawReturnDelays(RobotDraw& drawn, Rng& rng) {
  std::array<std::size_t, kJoints> order{};
  for (std::size_t i = 0; i < kJoints; ++i) order[i] = i;
  rng.shuffle(order);
  for (std::size_t i = 0; i < kJoints / 2; ++i) {
    drawn.board.servo[order[i]].return_delay = 250;
    drawn.joints.set(order[i]);
  }
}

void drawResets(RobotDraw& drawn, Rng& rng) {
  const double period = rng.between(0.15, 0.9);
  for (double at = rng.between(0, period); at < kObserved; at += period)
    drawn.script.push_back(fault(hil::FaultKind::kReset, at));
}

void drawFirstReadLost(RobotDraw& drawn, Rng& rng) {
  if (rng.coin()) return drawn.script.push_back(fault(hil::FaultKind::kMiss, 0, 1));
  hil::InjectedFault drop = fault(hil::FaultKind::kDrop, 0, 255);
  drop.lasts = Nanos{0};
  drawn.script.push_back(drop);
}

void drawOverload(RobotDraw& drawn, Rng& rng) {
  hil::InjectedFault bit = fault(hil::FaultKind::kErrors);
  bit.bits = error_bit::kOverload;
  bit.joints.set(rng.below(kJoints));
  drawn.joints = bit.joints;
  drawn.script.push_back(bit);
}

void drawHot(RobotDraw& drawn, Rng& rng) {
  hil::InjectedFault hot = fault(hil::FaultKind::kHeat, 0, rng.between(66, 79));
  hot.joints.set(rng.below(kJoints));
  drawn.joints = hot.joints;
  drawn.script.push_back(hot);
}

}  // namespace

const std::vector<DrawnFault> kDrawnFaults{
    {"latency timer 16", BusFault::kLatencyTimer, [](RobotDraw& d, Rng& rng) { d.latency = rng.coin() ? 16ms : 8ms; }},
    {"wrong baud", BusFault::kServoSilent,
     [](RobotDraw& d, Rng& rng) {
       constexpr std::array<std::uint8_t, 4> kBauds{34, 16, 9, 3};
       anyServo(d, rng).baud = rng.pick(kBauds);
     }},
    {"first read lost", BusFault::kFirstReadLost, drawFirstReadLost},
    {"dead id", BusFault::kServoSilent, [](RobotDraw& d, Rng& rng) { anyServo(d, rng).missing = true; }},
    {"duplicate id", BusFault::kDuplicateId, drawDuplicate},
    {"two servos swapped", BusFault::kSwapped, drawSwapped},
    {"broken chain", BusFault::kChainBroken, drawBreak},
    {"loose connector", BusFault::kLooseConnector, drawLooseConnector},
    {"low voltage", BusFault::kSupplyLow,
     [](RobotDraw& d, Rng& rng) {
       d.board.supply_v = rng.between(8, 10.9);
       d.torque_on = false;
     }},
    {"brown-out under load", BusFault::kBrownOut, drawBrownOut},
    {"return delays", BusFault::kReturnDelays, drawReturnDelays},
    {"status level 0", BusFault::kStatusLevel,
     [](RobotDraw& d, Rng& rng) { anyServo(d, rng).status_level = rng.coin() ? 0 : 1; }},
    {"wheel mode", BusFault::kWheelMode,
     [](RobotDraw& d, Rng& rng) {
       hil::ServoOptions& servo = anyServo(d, rng);
       servo.cw_limit = servo.ccw_limit = 0;
     }},
    {"wrong model", BusFault::kServoModel,
     [](RobotDraw& d, Rng& rng) {
       constexpr std::array<std::uint16_t, 4> kModels{12, 30, 310, 320};
       anyServo(d, rng).model = rng.pick(kModels);
     }},
    {"wrong limits", BusFault::kServoLimits, drawLimits},
    {"other program on the port", BusFault::kOtherProgram,
     [](RobotDraw& d, Rng& rng) {
       d.other_period = hil::faultTime(rng.between(0.008, 0.1));
       d.board.servo_power = true;  // for a while already
       d.board.servo_boot = 0ms;
     }},
    {"USB hub with delays", BusFault::kUsbDelays,
     [](RobotDraw& d, Rng& rng) {
       d.least_delay = 2ms;
       d.most_delay = hil::faultTime(rng.between(0.005, 0.008));
     }},
    {"noisy line", BusFault::kNoisyLine,
     [](RobotDraw& d, Rng& rng) { d.damaged_per_byte = rng.between(0.001, 0.002); }},
    {"board without BULK_READ", BusFault::kNoBulkRead, [](RobotDraw& d, Rng&) { d.board.bulk_read = false; }},
    {"board reset loop", BusFault::kBoardResets, drawResets},
    // Beyond the twenty.
    {"board off", BusFault::kBoardSilent,
     [](RobotDraw& d, Rng&) { d.script.push_back(fault(hil::FaultKind::kStall)); }},
    {"no board", BusFault::kNoBoard, [](RobotDraw& d, Rng&) { d.board.board = false; }},
    {"cable pulled", BusFault::kPortLost,
     [](RobotDraw& d, Rng& rng) { d.script.push_back(fault(hil::FaultKind::kUnplug, rng.uniform())); }},
    {"servo fuse", BusFault::kNoServo,
     [](RobotDraw& d, Rng&) {
       for (hil::ServoOptions& servo : d.board.servo) servo.missing = true;
     }},
    {"wrong id", BusFault::kWrongId,
     [](RobotDraw& d, Rng& rng) { anyServo(d, rng).id = static_cast<std::uint8_t>(21 + rng.below(90)); }},
    {"board without SYNC_WRITE", BusFault::kNoSyncWrite, [](RobotDraw& d, Rng&) { d.board.sync_write = false; }},
    {"one block length", BusFault::kBlockLengths, [](RobotDraw& d, Rng&) { d.board.only_block = 30; }},
    {"another board", BusFault::kBoardModel,
     [](RobotDraw& d, Rng& rng) { d.board.model = static_cast<std::uint16_t>(1 + rng.below(20000)); }},
    {"old firmware", BusFault::kServoFirmware,
     [](RobotDraw& d, Rng& rng) { anyServo(d, rng).firmware = static_cast<std::uint8_t>(10 + rng.below(17)); }},
    {"multi-turn mode", BusFault::kMultiTurnMode, [](RobotDraw& d, Rng& rng) { anyServo(d, rng).cw_limit = kTickMax; }},
    {"no torque", BusFault::kMaxTorqueZero, [](RobotDraw& d, Rng& rng) { anyServo(d, rng).max_torque = 0; }},
    {"overload", BusFault::kServoOverload, drawOverload},
    {"hot servo", BusFault::kServoHot, drawHot},
};

}  // namespace darwinop::cm730
