#include "hal/cm730/reply_decoder.hpp"

#include "core/conversions.hpp"
#include "core/registers.hpp"

namespace darwinop::cm730 {
namespace {

/// Raw value of a register from a block that starts at address kFirst and is long enough.
template <std::uint8_t kFirst, const Register& kRegister>
std::uint16_t raw(Bytes block) noexcept {
  constexpr std::size_t kAt = kRegister.address - kFirst;
  if constexpr (kRegister.bytes == 2) return wordAt(block, kAt);
  return block[kAt];
}

template <std::uint8_t kFirst, const Register& kRegister>
double si(Bytes block) noexcept {
  return (raw<kFirst, kRegister>(block) - kRegister.zero) * kRegister.scale;
}

constexpr Register kGyroX = find(kCm730, "gyro_x");
constexpr Register kGyroY = find(kCm730, "gyro_y");
constexpr Register kGyroZ = find(kCm730, "gyro_z");
constexpr Register kAccelX = find(kCm730, "accel_x");
constexpr Register kAccelY = find(kCm730, "accel_y");
constexpr Register kAccelZ = find(kCm730, "accel_z");
constexpr Register kPower = find(kCm730, "dxl_power");
constexpr Register kPanel = find(kCm730, "led_panel");
constexpr Register kHeadLed = find(kCm730, "led_head");
constexpr Register kEyeLed = find(kCm730, "led_eye");
constexpr Register kButtons = find(kCm730, "buttons");
constexpr Register kVoltage = find(kCm730, "voltage");
constexpr Register kMicLeft = find(kCm730, "mic_left");
constexpr Register kPosition = find(kMx28, "present_position");
constexpr Register kSpeed = find(kMx28, "present_speed");
constexpr Register kLoad = find(kMx28, "present_load");
constexpr Register kServoVoltage = find(kMx28, "present_voltage");
constexpr Register kTemperature = find(kMx28, "present_temperature");
constexpr Register kTorqueLimit = find(kMx28, "torque_limit");
constexpr Register kMovingSpeed = find(kMx28, "moving_speed");
constexpr Register kGoal = find(kMx28, "goal_position");
constexpr Register kTorqueEnable = find(kMx28, "torque_enable");

}  // namespace

void ReplyDecoder::begin(std::span<const ReadList::Entry> list, std::uint8_t first_bytes,
                         BusReadings& readings) noexcept {
  list_ = list;
  first_bytes_ = first_bytes;
  readings_ = &readings;
  first_answered_ = false;
  position_ = 0;
  last_ = Taken::kNothing;
  answered_.reset();
  polled_.reset();
}

std::size_t ReplyDecoder::answerBytes() const noexcept {
  std::size_t bytes = first_bytes_ + kFrameOverhead;
  for (const ReadList::Entry entry : list_) bytes += kServoWindows[entry.poll].frameBytes();
  if (!board_ && !list_.empty()) [[unlikely]]
    bytes -= kServoPoll.frameBytes();  // counted as first_bytes_
  return bytes;
}

std::size_t ReplyDecoder::nextFrameBytes() const noexcept {
  if (!first_answered_) return first_bytes_ + kFrameOverhead;
  if (position_ == list_.size()) return 0;
  return kServoWindows[list_[position_].poll].frameBytes();
}

void ReplyDecoder::withdraw() noexcept {
  if (last_ == Taken::kBoard) first_answered_ = readings_->board.answered = false;
  if (last_ == Taken::kServo) {
    const std::uint8_t joint = list_[position_ - 1].joint;
    if (!board_ && position_ == 1) first_answered_ = readings_->servos_answered = false;
    answered_[joint] = polled_[joint] = false;
    readings_->servo[joint].answered = readings_->servo[joint].polled = false;
  }
  last_ = Taken::kNothing;
}

void ReplyDecoder::takeBoard(const Frame& frame) noexcept {
  if (frame.params.empty()) return;  // acknowledges a write
  if (frame.params.size() != first_bytes_ || first_answered_ || !board_) {
    ++late_;
    return;
  }
  first_answered_ = true;
  last_ = Taken::kBoard;
  const Bytes b = frame.params;
  constexpr std::uint8_t kFirst = kBoardWindow.address;
  BoardReading& out = readings_->board;
  out.answered = true;
  out.gyro = {RadPerSec{si<kFirst, kGyroX>(b)}, RadPerSec{si<kFirst, kGyroY>(b)}, RadPerSec{si<kFirst, kGyroZ>(b)}};
  out.accelerometer = {MeterPerSec2{si<kFirst, kAccelX>(b)}, MeterPerSec2{si<kFirst, kAccelY>(b)},
                       MeterPerSec2{si<kFirst, kAccelZ>(b)}};
  imu_.apply(out);
  out.buttons = static_cast<std::uint8_t>(raw<kFirst, kButtons>(b));
  out.voltage = Volt{si<kFirst, kVoltage>(b)};
  out.microphone_left = raw<kFirst, kMicLeft>(b);
  out.servo_power = raw<kFirst, kPower>(b) != 0;
  out.led_panel = static_cast<std::uint8_t>(raw<kFirst, kPanel>(b));
  out.led_head = raw<kFirst, kHeadLed>(b);
  out.led_eye = raw<kFirst, kEyeLed>(b);
  out.error_bits = frame.code;
}

/// Without a board: opens the exchange. Its length is none that the other servos are read with, so a late reply of
/// theirs is not taken for it.
void ReplyDecoder::takeFirst(const Frame& frame) noexcept {
  if (board_ || list_.empty() || frame.id != servoId(list_[0].joint) || frame.params.size() != first_bytes_) {
    ++late_;
    return;
  }
  first_answered_ = true;
  takeServo(Frame{frame.id, frame.code, frame.params.last(kServoPoll.count)});
  first_answered_ = readings_->servos_answered = last_ == Taken::kServo;
}

void ReplyDecoder::takeServo(const Frame& frame) noexcept {
  if (!first_answered_) [[unlikely]]
    return takeFirst(frame);
  std::size_t at = position_;
  while (at < list_.size() && servoId(list_[at].joint) != frame.id) ++at;
  if (at == list_.size()) {
    ++late_;
    return;
  }
  constexpr std::uint8_t kMotion = kServoWindow.address, kPoll = kServoPoll.address;
  const ReadList::Entry entry = list_[at];
  if (frame.params.size() != kServoWindows[entry.poll].count) {
    ++late_;  // not the expected reply
    return;
  }
  const Bytes motion = frame.params.subspan(entry.poll ? kMotion - kPoll : 0);
  const std::uint16_t position = raw<kMotion, kPosition>(motion);
  if (position > kTickMax) {
    ++late_;
    return;
  }
  const auto joint = static_cast<Joint>(entry.joint);
  const RadPerSec velocity = velocityFromRegister(raw<kMotion, kSpeed>(motion));
  const double load = stall_.load(joint, raw<kMotion, kLoad>(motion));
  position_ = at + 1;
  last_ = Taken::kServo;
  answered_[entry.joint] = true;
  ServoReading& out = readings_->servo[entry.joint];
  out.answered = true;
  out.position = offsets_.jointAngle(joint, position);
  out.velocity = velocity;
  out.load = load;
  out.error_bits = frame.code;
  if (entry.poll) takePoll(joint, frame.params, out);
}

void ReplyDecoder::takePoll(Joint joint, Bytes block, ServoReading& out) noexcept {
  constexpr std::uint8_t kFirst = kServoPoll.address;
  out.polled = polled_[index(joint)] = true;
  out.torque_enabled = raw<kFirst, kTorqueEnable>(block) != 0;
  out.speed_limit = RadPerSec{si<kFirst, kMovingSpeed>(block)};
  out.goal = offsets_.jointAngle(joint, raw<kFirst, kGoal>(block));
  out.torque_limit = stall_.limit(joint, raw<kFirst, kTorqueLimit>(block));
  out.voltage = Volt{si<kFirst, kServoVoltage>(block)};
  out.temperature = Celsius{si<kFirst, kTemperature>(block)};
}

}  // namespace darwinop::cm730
