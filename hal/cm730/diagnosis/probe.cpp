// Start-up measurements.
#include "hal/cm730/diagnosis/probe.hpp"

#include <algorithm>
#include <vector>

#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "core/registers.hpp"
#include "hal/cm730/diagnosis/cycle_time.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/instruction_trial.hpp"
#include "hal/cm730/diagnosis/observation.hpp"
#include "hal/cm730/diagnosis/probe_requests.hpp"
#include "hal/cm730/diagnosis/servo_probe.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint8_t kBoardBytes = find(kCm730, "voltage").address + 1;  // 0..50
constexpr Nanos kServoBoot{300'000'000};       // as upstream waits after switching servo power on
constexpr Nanos kStallMargin{10'000'000};      // scheduling delay of a busy PC; not a loss
constexpr Nanos kMarginOverMedian{3'000'000};  // delay by other programs and USB frames

// By judgement: how long starting programs keep a robot's computer busy was not measured. Five take under a second.
constexpr int kRoundTripAttempts = 5;
constexpr Nanos kBetweenAttempts{50'000'000};

constexpr Patience kOnePing{1, Nanos{20'000'000}};  // a latency timer of 16 ms

class Probe {
 public:
  Probe(ByteLine& line, const ProbeOptions& options) : line_{line}, options_{options} {
    facts_.port = options.port;
    facts_.period = options.period;
    facts_.allowed = options.allowed;
    facts_.permitted = options.permitted;
    for (std::size_t i = 0; i < kJoints; ++i) {
      facts_.servo[i].absent = options.absent[i];
      facts_.start[i] = kJointTable[i].start + options.offsets.ticks(static_cast<Joint>(i));
    }
  }

  RobotFacts run() {
    const Nanos began = line_.now();
    if (options_.observe) countForeignFrames(line_, facts_);
    if (!facts_.lost && measureBoard()) {
      measureRoundTrip();
      if (!isSupported(facts_)) return finish(began);
      switchServosOn();
      if (facts_.board.suppliesServos()) measureServos(requests_, options_, facts_);
      if (!facts_.lost && facts_.board.suppliesServos()) tryInstructions(line_, facts_);
      measureLosses();
      if (options_.observe && !facts_.lost) observe(line_, facts_);
    }
    return finish(began);
  }

 private:
  RobotFacts finish(Nanos began) {
    facts_.took = line_.now() - began;
    return facts_;
  }

  bool measureBoard() {
    BoardFacts& board = facts_.board;
    const Answer pinged = requests_.ping(kBoardId);
    board.found = pinged.ok();
    board.ping_tries = pinged.tries;
    board.garbled = pinged.garbled && !pinged.ok();
    if (!board.found) {
      if (!board.garbled) countServosWithoutBoard();
      board.absent = options_.permitted.no_board && !board.garbled;
      return board.absent && board.servos_without_it > 0;
    }
    const Answer table = requests_.read(kBoardId, 0, kBoardBytes);
    board.garbled |= table.garbled && !table.ok();
    if (!table.ok()) return false;
    board.readable = true;
    const Bytes data = table.data();
    board.model = wordAt(data, 0);
    board.firmware = data[board::kFirmware];
    board.power_was_on = board.power_on = data[board::kDxlPower] != 0;
    board.voltage = voltFromRegister(data[find(kCm730, "voltage").address]);
    std::size_t axis = 0;
    for (const char* name : {"accel_x", "accel_y", "accel_z"}) {
      const Register& reg = find(kCm730, name);
      board.accelerometer[axis++] = MeterPerSec2{(wordAt(data, reg.address) - reg.zero) * reg.scale};
    }
    return true;
  }

  /// Pings only: what answers may be anything.
  void countServosWithoutBoard() {
    requests_.patience = kOnePing;
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i)
      if (!facts_.servo[i].absent && requests_.ping(kJointTable[i].id).ok()) {
        if (facts_.board.servos_without_it++ == 0) round_trip_id_ = kJointTable[i].id;
      }
    requests_.patience = {};
  }

  /// A computer that starts other programs delays some reads for a while: measured again until the cycle fits.
  void measureRoundTrip() {
    RoundTrip least;
    for (int attempt = 0; attempt < kRoundTripAttempts && !facts_.lost; ++attempt) {
      if (attempt > 0 && pass(line_, kBetweenAttempts) == LineStatus::kLost) facts_.lost = true;
      const RoundTrip measured = readRepeatedly();
      if (measured.reads > 0 && (least.reads == 0 || measured.median < least.median)) least = measured;
      facts_.round_trip = least;
      if (least.reads > 0 && (cycleFits(facts_) || isTimer(least))) break;
    }
    // From here on a silent servo costs little time.
    if (least.reads > 0)
      requests_.patience.margin = std::min(requests_.patience.margin, least.median + kMarginOverMedian);
  }

  RoundTrip readRepeatedly() {
    std::vector<Nanos> took;
    for (int i = 0; i < options_.round_trip_reads && !facts_.lost; ++i)
      if (const Answer answer = requests_.read(round_trip_id_, 0, 2); answer.ok() && answer.tries == 1)
        took.push_back(answer.took);
    if (took.empty()) return {};
    std::ranges::sort(took);
    return {.reads = static_cast<int>(took.size()),
            .shortest = took.front(),
            .median = took[took.size() / 2],
            .high = took[took.size() * 9 / 10]};
  }

  void switchServosOn() {
    BoardFacts& board = facts_.board;
    if (board.absent || board.power_on || facts_.lost) return;
    if (options_.before_servo_power) options_.before_servo_power();
    constexpr int kAttempts = 3;  // a busy computer may lose the write or the reply
    for (int tried = 0; tried < kAttempts && !board.power_on && !facts_.lost; ++tried) {
      const std::uint8_t on = 1;
      requests_.note(writeRegisters(line_, kBoardId, board::kDxlPower, Bytes{&on, 1}, Patience{}));
      if (pass(line_, kServoBoot) == LineStatus::kLost) facts_.lost = true;
      const Answer answer = requests_.note(readRegisters(line_, kBoardId, board::kDxlPower, 1, Patience{}));
      board.power_on = answer.ok() && answer.data()[0] == 1;
    }
  }

  void measureLosses() {
    const Nanos until = line_.now() + options_.loss_budget;
    LossBurst burst;
    for (int round = 0; round < options_.loss_reads_per_servo; ++round)
      for (std::size_t i = 0; i < kJoints; ++i) {
        ServoFacts& servo = facts_.servo[i];
        if (!servo.readable) continue;
        if (facts_.lost || line_.now() >= until) return;
        ++servo.reads;
        const Answer answer = requests_.note(readRegisters(line_, kJointTable[i].id, servo::kPresentPosition, 2,
                                                           {1, facts_.round_trip.median + kStallMargin}));
        if (!answer.ok()) ++servo.losses;
        if (options_.observe) burst.note(line_, facts_, answer.ok());
      }
  }

  ByteLine& line_;
  const ProbeOptions& options_;
  RobotFacts facts_;
  std::uint8_t round_trip_id_ = kBoardId;
  ProbeRequests requests_{line_, facts_.lost};
};

}  // namespace

RobotFacts measure(ByteLine& line, const ProbeOptions& options) {
  return Probe{line, options}.run();
}

ProbeReport probe(ByteLine& line, const ProbeOptions& options) {
  ProbeReport report{measure(line, options), {}};
  report.findings = diagnose(report.facts);
  return report;
}

}  // namespace darwinop::cm730
