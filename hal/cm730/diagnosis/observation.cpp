#include "hal/cm730/diagnosis/observation.hpp"

#include <algorithm>
#include <array>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"

namespace darwinop::cm730 {
namespace {

constexpr Nanos kSettling{30'000'000};      // replies to a program that has just ended
constexpr Nanos kQuiet{200'000'000};        // a program that polls every 100 ms is seen twice
constexpr Nanos kShortest{1'500'000'000};   // duration of the observation
constexpr Nanos kLongest{6'000'000'000};    // lost reads take longer
constexpr Nanos kPause{20'000'000};         // between looks at the servo power
constexpr Nanos kBetweenPings{60'000'000};  // of silent servos
constexpr Nanos kReplyMargin{10'000'000};   // scheduling delay of a busy PC; not a loss
constexpr Nanos kPingMargin{3'000'000};     // USB frames
constexpr int kRounds = 16;                 // with 20 servos, 18 000 bytes: a byte in 1000 is 18 losses
constexpr int kMostPowerLosses = 5;         // a board that restarts; more would only wear its switch
constexpr std::size_t kMostSilent = 6;      // more silent servos than that have one cause, not a wrong id each
constexpr std::uint8_t kTableBytes = servo::kPresentTemperature + 1;
// Foot pressure sensors of ROBOTIS, optional devices on the servo bus.
constexpr std::array<std::uint8_t, 2> kFootSensors{111, 112};

class Observation {
 public:
  Observation(ByteLine& line, RobotFacts& facts)
      : line_{line}, facts_{facts}, began_{line.now()}, power_was_on_{facts.board.power_on} {}

  void run() {
    for (int round = 0; round < kRounds && !over(kLongest); ++round) {
      look();
      readTables();
    }
    while (!over(kShortest)) {
      look();
      wait(kPause);
    }
    checkTorque();
    scanIds();
    countForeignFrames(line_, facts_);
    facts_.observed.done = !facts_.lost;
  }

 private:
  [[nodiscard]] bool over(Nanos duration) const { return facts_.lost || line_.now() - began_ >= duration; }
  const Answer& note(const Answer& answer) {
    if (answer.status == LineStatus::kLost) facts_.lost = true;
    return answer;
  }
  void wait(Nanos duration) {
    if (pass(line_, duration) == LineStatus::kLost) facts_.lost = true;
  }
  static bool silent(const ServoFacts& servo) { return !servo.absent && !servo.found && !servo.garbled; }

  void look() {
    checkPower();
    if (line_.now() < next_pings_) return;
    next_pings_ = line_.now() + kBetweenPings;
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i)
      if (silent(facts_.servo[i]) && answersPing(kJointTable[i].id)) ++facts_.servo[i].late_answers;
  }
  bool answersPing(std::uint8_t id) { return note(ping(line_, id, {1, facts_.round_trip.median + kPingMargin})).ok(); }

  void checkPower() {
    if (facts_.board.absent || facts_.observed.power_losses >= kMostPowerLosses) return;
    const Answer power = note(readRegisters(line_, kBoardId, board::kDxlPower, 1));
    if (!power.ok() || power.data()[0] != 0) return;
    if (power_was_on_) ++facts_.observed.power_losses;
    const std::uint8_t on = 1;
    note(writeRegisters(line_, kBoardId, board::kDxlPower, Bytes{&on, 1}));
    const Answer now = note(readRegisters(line_, kBoardId, board::kDxlPower, 1));
    power_was_on_ = now.ok() && now.data()[0] == 1;
  }

  void readTables() {
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i) {
      ServoFacts& servo = facts_.servo[i];
      if (!servo.readable) continue;
      ++servo.long_reads;
      const Patience once{1, facts_.round_trip.median + kReplyMargin};
      const bool answered = note(readRegisters(line_, kJointTable[i].id, 0, kTableBytes, once)).ok();
      if (!answered) ++servo.long_losses;
      burst_.note(line_, facts_, answered);
    }
  }

  /// Nothing here switches torque off: a servo whose torque is gone has restarted, or shut itself down.
  void checkTorque() {
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i) {
      ServoFacts& servo = facts_.servo[i];
      if (!servo.readable || !servo.torque_on) continue;
      const Answer torque = note(readRegisters(line_, kJointTable[i].id, servo::kTorqueEnable, 1));
      servo.restarted = torque.ok() && torque.data()[0] == 0;
    }
  }

  void scanIds() {
    const auto missing = static_cast<std::size_t>(std::ranges::count_if(facts_.servo, silent));
    if (missing == 0 || missing > kMostSilent || facts_.observed.power_losses > 0) return;
    for (unsigned id = 0; id < kBroadcastId && !facts_.lost; ++id) {
      const auto one = static_cast<std::uint8_t>(id);
      const bool known = (id >= 1 && id <= kJoints) || id == kBoardId;
      if (!known && std::ranges::find(kFootSensors, one) == kFootSensors.end() && answersPing(one))
        facts_.observed.stray_ids.push_back(one);
    }
  }

  ByteLine& line_;
  RobotFacts& facts_;
  Nanos began_, next_pings_{0};
  LossBurst burst_;
  bool power_was_on_;
};

}  // namespace

void LossBurst::note(ByteLine& line, RobotFacts& facts, bool answered) {
  in_a_row_ = answered ? 0 : in_a_row_ + 1;
  if (in_a_row_ < 2 || facts.lost) return;
  in_a_row_ = 0;
  const Answer board = ping(line, kBoardId, {1, facts.round_trip.median + kReplyMargin});
  const LineStatus waited = board.status == LineStatus::kTimeout ? pass(line, kFrameTimeout) : board.status;
  facts.lost = waited == LineStatus::kLost;
}

void countForeignFrames(ByteLine& line, RobotFacts& facts) {
  if (pass(line, kSettling) == LineStatus::kLost) facts.lost = true;
  const Nanos until = line.now() + kQuiet;
  FrameReader reader;
  std::array<std::uint8_t, 256> incoming{};
  while (!facts.lost && line.now() < until) {
    std::size_t count = 0;
    facts.lost = line.read(incoming, count, until) == LineStatus::kLost;
    for (Bytes rest{incoming.data(), count}; !rest.empty();) {
      rest = rest.subspan(reader.feed(rest));
      while (reader.next()) ++facts.observed.foreign_frames;
    }
  }
}

void observe(ByteLine& line, RobotFacts& facts) {
  Observation{line, facts}.run();
}

}  // namespace darwinop::cm730
