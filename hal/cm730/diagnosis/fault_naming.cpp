#include "hal/cm730/diagnosis/fault_naming.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "core/servo_limits.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/kind_faults.hpp"
#include "hal/cm730/diagnosis/line_events.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/diagnosis/silent_servos.hpp"
#include "hal/cm730/diagnosis/swapped_servos.hpp"
#include "hal/cm730/serial_open.hpp"

namespace darwinop::cm730 {
namespace {

/// A short read takes 1 to 2 ms through USB, up to 3.8 ms if it misses two USB frames. From here on something else
/// delays it; from kLatencySignature on with little variation it is the latency timer.
constexpr Nanos kUsbDelayed{4'000'000}, kUsbDelayedSometimes{5'500'000};
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

void replaceAll(std::string& text, std::string_view word, const std::string& by) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

FaultPlace placeOf(const LooseConnector& loose, const BoardFacts& board) {
  FaultPlace place{BusFault::kLooseConnector, only(loose.first), loose.evidence};
  place.from_text = loose.from ? servoName(*loose.from) : feedName(board);
  return place;
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
    if (named_.empty() && firstReadLost()) name(BusFault::kFirstReadLost, {});
    std::ranges::stable_sort(named_, {}, &NamedFault::fault);
    return std::move(named_);
  }

 private:
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

  void name(BusFault fault, std::string evidence, const std::bitset<kJoints>& joints = {}) {
    name({fault, joints, std::move(evidence)});
  }
  void name(const FaultPlace& place) {
    NamedFault named{place.fault, place.joints, place.other, {}, {}, place.evidence};
    named.what = row(place.fault).what;
    named.remedy = row(place.fault).remedy;
    for (std::string* text : {&named.what, &named.remedy}) {
      replaceAll(*text, "PORT", facts_.port);
      replaceAll(*text, "SERVO", servoNames(place.joints));
      replaceAll(*text, "OTHER", place.other_text);
      replaceAll(*text, "FROM", place.from_text);
    }
    named_.push_back(std::move(named));
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
      name(BusFault::kBoardResets,
           "servo power went off during the check: " + std::to_string(facts_.observed.power_losses) + "x");
  }

  void nameTheLine() {
    const auto& [reads, shortest, median, high] = facts_.round_trip;
    const std::string times = "short reads take " + inMs(shortest) + " to " + inMs(high) + ", median " + inMs(median);
    const bool constant = isTimer(facts_.round_trip) && high - shortest <= kTimerSpread;
    if (has(Kind::kLatencyTimer) || constant)
      name(BusFault::kLatencyTimer, times);
    else if (median >= kUsbDelayed || high >= kUsbDelayedSometimes)
      name(BusFault::kUsbDelays, times + ": a latency timer would delay all of them alike");
    else if (const auto loose = findLooseConnector(facts_))
      name(placeOf(*loose, facts_.board));
    else if (isNoisy(facts_) || has(Kind::kRepliesLost) || has(Kind::kLineNoisy))
      name(BusFault::kNoisyLine, noiseText(facts_));
    if (has(Kind::kCycleTooLong) && !isNamed(BusFault::kLatencyTimer) && !isNamed(BusFault::kUsbDelays) &&
        !has(Kind::kReturnDelay))
      name(BusFault::kCycleTooLong, {});
  }

  /// With other losses it was one of them.
  [[nodiscard]] bool firstReadLost() const {
    const bool board = facts_.board.readable && facts_.board.ping_tries > 1;
    return facts_.board.isKnown() && (board || facts_.instructions.first_lost) && lostReplies(facts_) == 0;
  }

  void nameSilentServos() {
    if (has(Kind::kNoServo)) return name(BusFault::kNoServo, {});
    if (!facts_.board.suppliesServos()) return;
    for (const FaultPlace& place : explainSilentServos(facts_)) name(place);
  }

  /// A servo whose replies are late or lost also seems to lack instructions.
  [[nodiscard]] bool isConsequence(BusFault fault) const {
    constexpr BusFault kCauses[] = {BusFault::kBoardResets,    BusFault::kLatencyTimer, BusFault::kUsbDelays,
                                    BusFault::kLooseConnector, BusFault::kNoisyLine,    BusFault::kOtherProgram};
    return fault == BusFault::kServoInstruction &&
           std::ranges::any_of(kCauses, [this](BusFault cause) { return isNamed(cause); });
  }

  void nameByKind() {
    for (std::size_t i = 0; i < kBusFaults; ++i) {
      std::bitset<kJoints> joints;
      bool found = false;
      for (const KindFault& entry : kKindFaults) {
        if (entry.fault != static_cast<BusFault>(i) || !has(entry.kind)) continue;
        found = true;
        joints |= jointsOf(entry.kind);
      }
      if (found && !isConsequence(static_cast<BusFault>(i))) name(static_cast<BusFault>(i), {}, joints);
    }
  }

  void nameSwapped() {
    if (const auto pair = findSwapped(facts_))
      name({BusFault::kSwapped, only(pair->first), pair->evidence, pair->second, servoName(pair->second), {}});
  }

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
