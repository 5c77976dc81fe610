#include "hal/cm730/diagnosis/fault_naming.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "core/servo_limits.hpp"
#include "hal/cm730/diagnosis/chains.hpp"
#include "hal/cm730/diagnosis/line_events.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/diagnosis/swapped_servos.hpp"
#include "hal/cm730/serial_open.hpp"

namespace darwinop::cm730 {
namespace {

/// A short read takes 1 to 2 ms through USB, up to 3.8 ms if it misses two USB frames. From here on something else
/// delays it; from kLatencySignature on with little variation it is the latency timer.
constexpr Nanos kUsbDelayed{4'000'000}, kUsbDelayedSometimes{5'500'000};
constexpr Nanos kTimerDelay{7'000'000};   // of the shortest read
constexpr Nanos kTimerSpread{3'000'000};  // two USB frames and a byte
constexpr double kLoaded = 0.1;           // mean load of the servos
constexpr double kLowSupplyV = kBatteryLowV;
constexpr int kForeignFrames = 2;

double meanLoad(const RobotFacts& facts) {
  double sum = 0;
  for (const ServoFacts& servo : facts.servo)
    if (servo.readable && servo.torque_on) sum += std::abs(servo.load);
  return sum / kJoints;
}

std::string inMs(Nanos time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", static_cast<double>(time.count()) * 1e-6);
  return text;
}

std::string listOf(const std::bitset<kJoints>& joints) {
  if (joints.count() == 1) return servoName(static_cast<Joint>(std::countr_zero(joints.to_ulong())));
  std::string text = "servos";
  forEachJoint(joints, [&](std::size_t i) { text.append(" ").append(std::to_string(servoId(i))); });
  return text;
}

void replaceAll(std::string& text, std::string_view word, const std::string& by) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

class Naming {
 public:
  Naming(const RobotFacts& facts, const Findings& findings) : facts_{facts}, findings_{findings} {}

  std::vector<NamedFault> run() {
    nameThePort();
    nameTheBoard();
    nameTheLine();
    nameSilentServos();
    nameByKind();
    nameSwapped();
    std::ranges::stable_sort(named_, {}, &NamedFault::fault);
    return std::move(named_);
  }

 private:
  struct Words {
    std::string other, from;
  };

  [[nodiscard]] bool has(Kind kind) const {
    return std::ranges::any_of(findings_, [kind](const Finding& row) { return row.is(kind); });
  }
  [[nodiscard]] bool isNamed(BusFault fault) const {
    return std::ranges::find(named_, fault, &NamedFault::fault) != named_.end();
  }
  [[nodiscard]] std::bitset<kJoints> jointsOf(Kind kind) const {
    std::bitset<kJoints> joints;
    for (const Finding& row : findings_)
      if (row.joint && row.is(kind)) joints.set(index(*row.joint));
    return joints;
  }

  NamedFault& name(BusFault fault, std::string evidence, std::bitset<kJoints> joints = {}, const Words& words = {}) {
    NamedFault named;
    named.fault = fault;
    named.joints = joints;
    named.evidence = std::move(evidence);
    named.what = row(fault).what;
    named.remedy = row(fault).remedy;
    for (std::string* text : {&named.what, &named.remedy}) {
      replaceAll(*text, "PORT", facts_.port);
      replaceAll(*text, "SERVO", listOf(joints));
      replaceAll(*text, "OTHER", words.other);
      replaceAll(*text, "FROM", words.from);
    }
    named_.push_back(std::move(named));
    return named_.back();
  }

  void nameThePort() {
    for (const Finding& finding : findings_) {
      if (finding.is(Kind::kPortMissing))
        name(finding.what.find(kPortInUse) == std::string::npos ? BusFault::kPortMissing : BusFault::kOtherProgram,
             finding.what);
      if (finding.is(Kind::kPortUnusable)) name(BusFault::kPortUnusable, finding.what);
    }
    if (has(Kind::kPortLost)) name(BusFault::kPortLost, {});
    if (facts_.observed.foreign_frames >= kForeignFrames)
      name(BusFault::kOtherProgram,
           std::to_string(facts_.observed.foreign_frames) + " replies arrived that this program had not requested");
  }

  void nameTheBoard() {
    const bool restarted = acrossChains(facts_);
    const bool low = has(Kind::kSupplyLow) || has(Kind::kSupplyEmpty);
    if (facts_.observed.power_losses == 0 && restarted)
      name(BusFault::kBrownOut, "servos of several chains restarted while they were under torque");
    else if (low && meanLoad(facts_) >= kLoaded)
      name(BusFault::kBrownOut,
           "under " + std::to_string(static_cast<int>(kLowSupplyV)) + " V while servos carry load");
    else if (low)
      name(BusFault::kSupplyLow, {});
    if (facts_.observed.power_losses > 0)
      name(BusFault::kBoardResets, "servo power went off " + std::to_string(facts_.observed.power_losses) + " times");
  }

  void nameTheLine() {
    const Nanos usual = facts_.round_trip, spread = facts_.long_round_trip - facts_.shortest_round_trip;
    const std::string times = "short reads take " + inMs(facts_.shortest_round_trip) + " to " +
                              inMs(facts_.long_round_trip) + ", median " + inMs(usual);
    const bool constant = facts_.shortest_round_trip >= kTimerDelay && spread <= kTimerSpread;
    if (has(Kind::kLatencyTimer) || constant)
      name(BusFault::kLatencyTimer, times);
    else if (usual >= kUsbDelayed || facts_.long_round_trip >= kUsbDelayedSometimes)
      name(BusFault::kUsbDelays, times + ": a latency timer would delay all of them alike");
    else if (const auto loose = findLooseConnector(facts_))
      name(BusFault::kLooseConnector, loose->evidence, bit(loose->first),
           {{}, loose->from ? servoName(*loose->from) : "the board"});
    else if (isNoisy(facts_) || has(Kind::kRepliesLost) || has(Kind::kLineNoisy))
      name(BusFault::kNoisyLine, noiseText(facts_));
    if (has(Kind::kCycleTooLong) && !isNamed(BusFault::kLatencyTimer) && !isNamed(BusFault::kUsbDelays) &&
        !has(Kind::kReturnDelay))
      name(BusFault::kCycleTooLong, {});
    if (firstReadLost() && named_.empty()) name(BusFault::kFirstReadLost, {});
  }

  [[nodiscard]] bool firstReadLost() const {
    return facts_.board.readable && (facts_.board.ping_tries > 1 || facts_.instructions.first_lost);
  }

  void nameSilentServos() {
    if (has(Kind::kNoServo)) name(BusFault::kNoServo, {});
    if (!facts_.board.power_on || has(Kind::kNoServo)) return;
    std::bitset<kJoints> silent = jointsThat([&](std::size_t i) {
      const ServoFacts& servo = facts_.servo[i];
      return !servo.absent && !servo.found && !servo.garbled && servo.late_answers == 0;
    });
    for (const Chain chain : {Chain::kRightArm, Chain::kLeftArm, Chain::kHead, Chain::kRightLeg, Chain::kLeftLeg})
      silent &= ~nameBreak(chain, silent);
    nameGarbled(silent);
    if (const auto& stray = facts_.observed.stray_ids; silent.count() == 1 && stray.size() == 1) {
      name(BusFault::kWrongId, {}, silent, {std::to_string(stray[0]), {}});
      silent.reset();
    }
    forEachJoint(silent, [&](std::size_t i) {
      name(BusFault::kServoSilent, "the other servos of its chain answer", bit(static_cast<Joint>(i)));
    });
  }

  /// Returns the servos that the break explains.
  std::bitset<kJoints> nameBreak(Chain chain, const std::bitset<kJoints>& silent) {
    const ChainBreak where = findBreak(facts_, chain);
    if (!where.first_silent || where.silent < 2) return {};
    const auto behind = jointsThat(
        silent, [&](std::size_t i) { return kJointTable[i].chain == chain && i >= index(*where.first_silent); });
    if (static_cast<int>(behind.count()) != where.silent) return {};
    name(BusFault::kChainBroken, listOf(behind) + " are silent: one broken cable is likelier than as many defects",
         bit(*where.first_silent), {{}, where.last_answering ? servoName(*where.last_answering) : "the board"});
    return behind;
  }

  /// Two servos reply at once under one id; a silent one is likely to be the second.
  void nameGarbled(std::bitset<kJoints>& silent) {
    const auto garbled = jointsOf(Kind::kServoGarbled);
    if (garbled.count() != 1) return;
    if (silent.count() != 1) {
      name(BusFault::kDuplicateId, "its replies are garbled", garbled, {"the new one", {}});
      return;
    }
    const auto second = static_cast<Joint>(std::countr_zero(silent.to_ulong()));
    name(BusFault::kDuplicateId, "its replies are garbled, and " + servoName(second) + " is silent", garbled,
         {servoName(second), {}})
        .other = second;
    silent.reset();
  }

  void nameByKind() {
    struct KindFault {
      Kind kind;
      BusFault fault;
    };
    static constexpr KindFault kOfKind[] = {
        {Kind::kBoardSilent, BusFault::kBoardSilent},
        {Kind::kBoardGarbled, BusFault::kNotABoard},
        {Kind::kBoardUnreadable, BusFault::kBoardUnreadable},
        {Kind::kBoardModel, BusFault::kBoardModel},
        {Kind::kServoPowerOff, BusFault::kServoPowerOff},
        {Kind::kNoBulkRead, BusFault::kNoBulkRead},
        {Kind::kNoSyncWrite, BusFault::kNoSyncWrite},
        {Kind::kBlockLengths, BusFault::kBlockLengths},
        {Kind::kServoUnreadable, BusFault::kStatusLevel},
        {Kind::kStatusLevel, BusFault::kStatusLevel},
        {Kind::kServoModel, BusFault::kServoModel},
        {Kind::kServoFirmware, BusFault::kServoFirmware},
        {Kind::kWheelMode, BusFault::kWheelMode},
        {Kind::kMultiTurnMode, BusFault::kMultiTurnMode},
        {Kind::kNoRange, BusFault::kServoLimits},
        {Kind::kStartPoseOutside, BusFault::kServoLimits},
        {Kind::kNarrowRange, BusFault::kServoLimits},
        {Kind::kMaxTorqueZero, BusFault::kMaxTorqueZero},
        {Kind::kReturnDelay, BusFault::kReturnDelays},
        {Kind::kTorqueLimitZero, BusFault::kServoOverload},
        {Kind::kServoOverloadBit, BusFault::kServoOverload},
        {Kind::kServoHot, BusFault::kServoHot},
        {Kind::kServoTooHot, BusFault::kServoHot},
        {Kind::kServoOverheatBit, BusFault::kServoHot},
        {Kind::kServoErrorBit, BusFault::kServoErrorBit},
        {Kind::kServoInstruction, BusFault::kServoInstruction},
    };
    for (std::size_t i = 0; i < kBusFaults; ++i) {
      std::bitset<kJoints> joints;
      bool found = false;
      for (const KindFault& entry : kOfKind) {
        if (entry.fault != static_cast<BusFault>(i) || !has(entry.kind)) continue;
        found = true;
        joints |= jointsOf(entry.kind);
      }
      if (found) name(static_cast<BusFault>(i), {}, joints);
    }
  }

  void nameSwapped() {
    const auto pair = findSwapped(facts_);
    if (!pair) return;
    name(BusFault::kSwapped, pair->evidence, bit(pair->first), {servoName(pair->second), {}}).other = pair->second;
  }

  static std::bitset<kJoints> bit(Joint joint) { return std::bitset<kJoints>{}.set(index(joint)); }

  const RobotFacts& facts_;
  const Findings& findings_;
  std::vector<NamedFault> named_;
};

}  // namespace

std::vector<NamedFault> nameFaults(const RobotFacts& facts, const Findings& findings) {
  return Naming{facts, findings}.run();
}

std::string toText(const NamedFault& fault) {
  std::string text{row(fault.fault).name};
  text += ": " + fault.what + "\n";
  if (!fault.evidence.empty()) text += "      because " + fault.evidence + "\n";
  return text + "      -> " + fault.remedy + "\n";
}

}  // namespace darwinop::cm730
