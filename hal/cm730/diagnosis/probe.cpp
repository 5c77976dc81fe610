// Start-up measurements.
#include "hal/cm730/diagnosis/probe.hpp"

#include <algorithm>
#include <vector>

#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "core/registers.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/instruction_trial.hpp"
#include "hal/cm730/diagnosis/observation.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint8_t kServoBytes = servo::kPresentTemperature + 1;       // 0..43
constexpr std::uint8_t kBoardBytes = find(kCm730, "voltage").address + 1;  // 0..50
constexpr std::uint8_t kCwLimit = find(kMx28, "cw_limit").address, kCcwLimit = find(kMx28, "ccw_limit").address;
constexpr std::uint8_t kMaxTorque = find(kMx28, "max_torque").address, kLed = find(kMx28, "led").address;
constexpr std::uint8_t kReturnDelayWanted = 0, kStatusLevelWanted = 2;
constexpr Nanos kServoBoot{300'000'000};       // as upstream waits after switching servo power on
constexpr Nanos kStallMargin{10'000'000};      // scheduling delay of a busy PC; not a loss
constexpr Nanos kSecondLookTime{300'000'000};  // for all silent servos together
constexpr Nanos kMarginOverMedian{3'000'000};  // delay by other programs and USB frames

class Probe {
 public:
  Probe(ByteLine& line, const ProbeOptions& options) : line_{line}, options_{options} {
    facts_.port = options.port;
    facts_.period = options.period;
    facts_.allowed = options.allowed;
    facts_.board_model = options.board_model;
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
      if (facts_.board.power_on) measureServos();
      if (!facts_.lost && facts_.board.power_on) tryInstructions(line_, facts_);
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
  const Answer& note(const Answer& answer) {
    if (answer.status == LineStatus::kLost) facts_.lost = true;
    return answer;
  }
  Answer ping(std::uint8_t id) { return note(cm730::ping(line_, id, patience_)); }
  Answer read(std::uint8_t id, std::uint8_t address, std::uint8_t count) {
    return note(readRegisters(line_, id, address, count, patience_));
  }
  /// Writes once: a lost reply must not cost a second EEPROM write cycle.
  Answer writeOnce(std::uint8_t id, std::uint8_t address, std::uint8_t value) {
    return note(writeRegisters(line_, id, address, Bytes{&value, 1}, {1, patience_.margin}));
  }

  bool measureBoard() {
    BoardFacts& board = facts_.board;
    const Answer pinged = ping(kBoardId);
    board.found = pinged.ok();
    board.ping_tries = pinged.tries;
    board.garbled = pinged.garbled && !pinged.ok();
    if (!board.found) return false;
    const Answer table = read(kBoardId, 0, kBoardBytes);
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

  void measureRoundTrip() {
    std::vector<Nanos> took;
    for (int i = 0; i < options_.round_trip_reads && !facts_.lost; ++i)
      if (const Answer answer = read(kBoardId, 0, 2); answer.ok() && answer.tries == 1) took.push_back(answer.took);
    facts_.round_trip_reads = static_cast<int>(took.size());
    if (took.empty()) return;
    std::ranges::sort(took);
    facts_.round_trip = took[took.size() / 2];
    facts_.shortest_round_trip = took.front();
    facts_.long_round_trip = took[took.size() * 9 / 10];
    // From here on a silent servo costs little time.
    patience_.margin = std::min(patience_.margin, facts_.round_trip + kMarginOverMedian);
  }

  void switchServosOn() {
    BoardFacts& board = facts_.board;
    if (board.power_on || facts_.lost) return;
    constexpr int kAttempts = 3;  // a busy computer may lose the write or the reply
    for (int tried = 0; tried < kAttempts && !board.power_on && !facts_.lost; ++tried) {
      const std::uint8_t on = 1;
      note(writeRegisters(line_, kBoardId, board::kDxlPower, Bytes{&on, 1}, Patience{}));
      if (pass(line_, kServoBoot) == LineStatus::kLost) facts_.lost = true;
      const Answer answer = note(readRegisters(line_, kBoardId, board::kDxlPower, 1, Patience{}));
      board.power_on = answer.ok() && answer.data()[0] == 1;
    }
  }

  void measureServos() {
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i)
      if (!facts_.servo[i].absent) measureServo(kJointTable[i].id, facts_.servo[i]);
    retrySilentServos();
  }

  /// Retries silent servos: a busy computer may have missed their replies.
  void retrySilentServos() {
    const auto is_silent = [](const ServoFacts& servo) { return !servo.absent && !servo.found; };
    const auto silent = std::ranges::count_if(facts_.servo, is_silent);
    if (silent == 0) return;
    const Patience before = patience_;
    patience_ = {1, std::min(Patience{}.margin, kSecondLookTime / silent)};
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i)
      if (is_silent(facts_.servo[i])) measureServo(kJointTable[i].id, facts_.servo[i]);
    patience_ = before;
  }

  void measureServo(std::uint8_t id, ServoFacts& servo) {
    const Answer pinged = ping(id);
    servo.found = pinged.ok();
    servo.garbled = pinged.garbled && !pinged.ok();
    if (!servo.found) return;
    readTable(id, servo);
    if (!servo.readable && !facts_.lost) readPatiently(id, servo);
    if (!servo.readable && !servo.garbled && !facts_.lost) correctMute(id, servo);
    if (!isSupported(servo)) return;
    if (servo.status_level != kStatusLevelWanted) {
      servo.level_correction = correct(id, servo::kStatusLevel, kStatusLevelWanted, servo.torque_on);
      if (servo.level_correction == Correction::kDone) servo.status_level = kStatusLevelWanted;
    }
    if (servo.return_delay <= kMostReturnDelay) return;
    servo.return_delay_was = servo.return_delay;
    servo.delay_correction = correct(id, servo::kReturnDelay, kReturnDelayWanted, servo.torque_on);
    if (servo.delay_correction == Correction::kDone) servo.return_delay = kReturnDelayWanted;
  }

  /// It answers pings but not reads: status level 0. Model, level and torque cannot be read, so only `doctor --fix`
  /// writes; a servo under torque ignores it.
  void correctMute(std::uint8_t id, ServoFacts& servo) {
    servo.level_correction = Correction::kNotAsked;
    if (!options_.correct_mute) return;
    servo.level_correction = correct(id, servo::kStatusLevel, kStatusLevelWanted, false);
    if (servo.level_correction != Correction::kDone) return;
    servo.was_mute = true;
    readTable(id, servo);
  }

  /// Retries with a longer timeout: a delay by this computer looks like status level 0 or like a duplicate id.
  void readPatiently(std::uint8_t id, ServoFacts& servo) {
    const Patience before = patience_;
    patience_ = Patience{};
    servo.garbled = false;
    readTable(id, servo);
    patience_ = before;
  }

  void readTable(std::uint8_t id, ServoFacts& servo) {
    const Answer table = read(id, 0, kServoBytes);
    servo.garbled |= table.garbled && !table.ok();
    if (!table.ok()) return;
    const Bytes data = table.data();
    servo.readable = true;
    servo.error_bits = table.error_bits;
    servo.model = wordAt(data, 0);
    servo.firmware = data[servo::kFirmware];
    servo.return_delay = data[servo::kReturnDelay];
    servo.status_level = data[servo::kStatusLevel];
    servo.cw_limit = wordAt(data, kCwLimit);
    servo.ccw_limit = wordAt(data, kCcwLimit);
    servo.max_torque = wordAt(data, kMaxTorque);
    servo.torque_on = data[servo::kTorqueEnable] != 0;
    servo.led_on = data[kLed] != 0;
    servo.torque_limit = wordAt(data, servo::kTorqueLimit);
    servo.position = options_.offsets.jointAngle(static_cast<Joint>(id - 1), wordAt(data, servo::kPresentPosition));
    servo.voltage = voltFromRegister(data[servo::kPresentVoltage]);
    servo.load = loadFromRegister(wordAt(data, find(kMx28, "present_load").address));
    servo.temperature = Celsius{static_cast<double>(data[servo::kPresentTemperature])};
  }

  Correction correct(std::uint8_t id, std::uint8_t address, std::uint8_t wanted, bool torque_on) {
    if (!options_.correct) return Correction::kNotAsked;
    if (torque_on) return Correction::kTorqueOn;
    for (int attempt = 0; attempt < 2 && !facts_.lost; ++attempt) {
      writeOnce(id, address, wanted);
      const Answer now = read(id, address, 1);
      if (now.ok() && now.data()[0] == wanted) return Correction::kDone;
    }
    return Correction::kRefused;
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
        const Answer answer = note(
            readRegisters(line_, kJointTable[i].id, servo::kPresentPosition, 2, {1, facts_.round_trip + kStallMargin}));
        if (!answer.ok()) ++servo.losses;
        if (options_.observe) burst.note(line_, facts_, answer.ok());
      }
  }

  ByteLine& line_;
  const ProbeOptions& options_;
  RobotFacts facts_;
  Patience patience_;
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
