#include "hal/cm730/diagnosis/servo_probe.hpp"

#include <algorithm>

#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "core/registers.hpp"
#include "core/servo_models.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint8_t kServoBytes = servo::kPresentTemperature + 1;  // 0..43
constexpr std::uint8_t kCwLimit = find(kMx28, "cw_limit").address, kCcwLimit = find(kMx28, "ccw_limit").address;
constexpr std::uint8_t kMaxTorque = find(kMx28, "max_torque").address, kLed = find(kMx28, "led").address;
constexpr std::uint8_t kReturnDelayWanted = 0, kStatusLevelWanted = 2;
constexpr Nanos kSecondLookTime{300'000'000};  // for all silent servos together

class ServoProbe {
 public:
  ServoProbe(ProbeRequests& requests, const ProbeOptions& options, RobotFacts& facts)
      : requests_{requests}, options_{options}, facts_{facts} {}

  void run() {
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i)
      if (!facts_.servo[i].absent) measureServo(kJointTable[i].id, facts_.servo[i]);
    retrySilentServos();
  }

 private:
  /// Retries silent servos: a busy computer may have missed their replies.
  void retrySilentServos() {
    const auto is_silent = [](const ServoFacts& servo) { return !servo.absent && !servo.found; };
    const auto silent = std::ranges::count_if(facts_.servo, is_silent);
    if (silent == 0) return;
    const Patience before = requests_.patience;
    requests_.patience = {1, std::min(Patience{}.margin, kSecondLookTime / silent)};
    for (std::size_t i = 0; i < kJoints && !facts_.lost; ++i)
      if (is_silent(facts_.servo[i])) measureServo(kJointTable[i].id, facts_.servo[i]);
    requests_.patience = before;
  }

  void measureServo(std::uint8_t id, ServoFacts& servo) {
    const Answer pinged = requests_.ping(id);
    servo.found = pinged.ok();
    servo.garbled = pinged.garbled && !pinged.ok();
    if (!servo.found) return;
    readTable(id, servo);
    if (!servo.readable && !facts_.lost) readPatiently(id, servo);
    if (!servo.readable && !servo.garbled && !facts_.lost) correctMute(id, servo);
    if (!isSupported(servo, options_.permitted)) return;
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
    const Patience before = requests_.patience;
    requests_.patience = Patience{};
    servo.garbled = false;
    readTable(id, servo);
    requests_.patience = before;
  }

  void readTable(std::uint8_t id, ServoFacts& servo) {
    const Answer table = requests_.read(id, 0, kServoBytes);
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
    const ServoModel* const model = findServoModel(servo.model);
    if (model == nullptr || model->use != ServoUse::kIfPermitted) return;
    servo.slave_mode = data[servo::kDriveMode] != 0;
    const Answer mode = requests_.read(id, servo::kTorqueControl, 1);
    servo.torque_control = !mode.ok() || mode.data()[0] != 0;
  }

  Correction correct(std::uint8_t id, std::uint8_t address, std::uint8_t wanted, bool torque_on) {
    if (!options_.correct) return Correction::kNotAsked;
    if (torque_on) return Correction::kTorqueOn;
    for (int attempt = 0; attempt < 2 && !facts_.lost; ++attempt) {
      requests_.writeOnce(id, address, wanted);
      const Answer now = requests_.read(id, address, 1);
      if (now.ok() && now.data()[0] == wanted) return Correction::kDone;
    }
    return Correction::kRefused;
  }

  ProbeRequests& requests_;
  const ProbeOptions& options_;
  RobotFacts& facts_;
};

}  // namespace

void measureServos(ProbeRequests& requests, const ProbeOptions& options, RobotFacts& facts) {
  ServoProbe{requests, options, facts}.run();
}

}  // namespace darwinop::cm730
