#include "hal/cm730/reply_decoder.hpp"

#include "core/conversions.hpp"
#include "core/registers.hpp"

namespace darwinop::cm730 {
namespace {

/// A register's raw value out of a block that starts at `window`.
std::uint16_t raw(Bytes block, std::uint8_t first, const Register& r) noexcept {
  const std::size_t at = static_cast<std::size_t>(r.address - first);
  return r.bytes == 2 ? wordAt(block, at) : block[at];
}

double si(Bytes block, std::uint8_t first, const Register& r) noexcept {
  return (raw(block, first, r) - r.zero) * r.scale;
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

void ReplyDecoder::begin(std::span<const ReadList::Entry> list, std::uint8_t board_bytes,
                         BusReadings& readings) noexcept {
  list_ = list;
  board_bytes_ = board_bytes;
  readings_ = &readings;
  board_answered_ = false;
  position_ = 0;
  answered_.reset();
}

std::size_t ReplyDecoder::answerBytes() const noexcept {
  std::size_t bytes = board_bytes_ + kFrameOverhead;
  for (const ReadList::Entry entry : list_) bytes += (entry.look ? kServoLook : kServoWindow).frameBytes();
  return bytes;
}

std::size_t ReplyDecoder::nextFrameBytes() const noexcept {
  if (!board_answered_) return board_bytes_ + kFrameOverhead;
  if (position_ == list_.size()) return 0;
  return list_[position_].look ? kServoLook.frameBytes() : kServoWindow.frameBytes();
}

void ReplyDecoder::take(const Frame& frame) noexcept {
  if (frame.id == kBoardId)
    takeBoard(frame);
  else
    takeServo(frame);
}

void ReplyDecoder::takeBoard(const Frame& frame) noexcept {
  if (frame.params.empty()) return;  // acknowledges a write
  if (frame.params.size() != board_bytes_ || board_answered_) {
    ++late_;
    return;
  }
  board_answered_ = true;
  const Bytes b = frame.params;
  constexpr std::uint8_t kFirst = kBoardWindow.address;
  BoardReading& out = readings_->board;
  out.answered = true;
  out.gyro = {RadPerSec{si(b, kFirst, kGyroX)}, RadPerSec{si(b, kFirst, kGyroY)}, RadPerSec{si(b, kFirst, kGyroZ)}};
  out.accelerometer = {MeterPerSec2{si(b, kFirst, kAccelX)}, MeterPerSec2{si(b, kFirst, kAccelY)},
                       MeterPerSec2{si(b, kFirst, kAccelZ)}};
  out.buttons = static_cast<std::uint8_t>(raw(b, kFirst, kButtons));
  out.voltage = Volt{si(b, kFirst, kVoltage)};
  out.microphone_left = raw(b, kFirst, kMicLeft);
  out.servo_power = raw(b, kFirst, kPower) != 0;
  out.led_panel = static_cast<std::uint8_t>(raw(b, kFirst, kPanel));
  out.led_head = raw(b, kFirst, kHeadLed);
  out.led_eye = raw(b, kFirst, kEyeLed);
  out.error_bits = frame.code;
}

void ReplyDecoder::takeServo(const Frame& frame) noexcept {
  std::size_t at = position_;
  while (at < list_.size() && kJointTable[list_[at].joint].id != frame.id) ++at;
  if (!board_answered_ || at == list_.size()) {
    ++late_;
    return;
  }
  const ReadList::Entry entry = list_[at];
  const Window window = entry.look ? kServoLook : kServoWindow;
  const Bytes b = frame.params;
  if (b.size() != window.count || raw(b, window.address, kPosition) > kTickMax) {
    ++late_;  // not what was asked for
    return;
  }
  position_ = at + 1;
  answered_.set(entry.joint);
  ServoReading& out = readings_->servo[entry.joint];
  out.answered = true;
  out.position = offsets_.jointAngle(static_cast<Joint>(entry.joint), raw(b, window.address, kPosition));
  out.velocity = velocityFromRegister(raw(b, window.address, kSpeed));
  out.load = loadFromRegister(raw(b, window.address, kLoad));
  out.error_bits = frame.code;
  if (!entry.look) return;
  out.looked = true;
  out.torque_enabled = raw(b, window.address, kTorqueEnable) != 0;
  out.speed_limit = RadPerSec{si(b, window.address, kMovingSpeed)};
  out.goal = offsets_.jointAngle(static_cast<Joint>(entry.joint), raw(b, window.address, kGoal));
  out.torque_limit = torqueFromRegister(raw(b, window.address, kTorqueLimit));
  out.voltage = Volt{si(b, window.address, kServoVoltage)};
  out.temperature = Celsius{si(b, window.address, kTemperature)};
}

}  // namespace darwinop::cm730
