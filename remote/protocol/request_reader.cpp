// Incremental parser of requests in a byte stream.
#include "remote/protocol/request_reader.hpp"

#include <algorithm>
#include <cstring>

namespace darwinop::remote {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Cursor over the sections of one request. Reads NUL after the last byte, as the 2013 server does.
class SectionCursor {
 public:
  explicit SectionCursor(Bytes bytes) : bytes_{bytes} {}

  [[nodiscard]] std::uint8_t here() const { return at_ < bytes_.size() ? bytes_[at_] : 0; }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] bool cutOff() const { return cut_off_; }
  [[nodiscard]] std::uint8_t byte() { return bytes_[at_++]; }
  [[nodiscard]] std::int32_t word() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | byte();
    return static_cast<std::int32_t>(value);
  }
  /// Skips `tag` if it is next and `more` bytes follow.
  [[nodiscard]] bool take(char tag, std::size_t more = 0) {
    if (cut_off_ || at_ == bytes_.size() || bytes_[at_] != static_cast<std::uint8_t>(tag)) return false;
    cut_off_ = bytes_.size() - at_ - 1 < more;
    if (!cut_off_) ++at_;
    return !cut_off_;
  }

  /// False, and marks the section as cut off, if fewer bytes follow.
  [[nodiscard]] bool has(std::size_t more) {
    cut_off_ = cut_off_ || bytes_.size() - at_ < more;
    return !cut_off_;
  }
  void stepTo(std::size_t at) { at_ = at; }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
  bool cut_off_ = false;
};

void readLed(SectionCursor& in, Request& request, RequestIssues& issues) {
  const std::uint8_t index = in.byte();
  std::uint32_t colour = 0;
  for (int i = 0; i < 3; ++i) colour = colour << 8 | in.byte();
  if (index < kLeds)
    (void)request.leds.add({static_cast<Led>(index), colour});
  else
    ++issues.invalid_leds;
}

void readMotor(SectionCursor& in, Request& request, RequestIssues& issues) {
  const std::uint8_t index = in.byte();
  MotorSetting motor;
  const auto sub = [&](char tag, MotorSetting::Bit bit, std::int32_t& to) {
    if (!in.take(tag, 4)) return;
    to = in.word();
    motor.set |= bit;
  };
  sub('p', MotorSetting::kPosition, motor.position);
  sub('v', MotorSetting::kVelocity, motor.velocity);
  sub('a', MotorSetting::kAcceleration, motor.acceleration);
  sub('m', MotorSetting::kAvailableTorque, motor.available_torque);
  if (in.take('c', 12)) {
    for (std::int32_t& part : motor.pid) part = in.word();
    motor.set |= MotorSetting::kPid;
  }
  sub('f', MotorSetting::kTorque, motor.torque);
  if (index >= kJoints) {
    ++issues.invalid_motors;
    return;
  }
  motor.joint = static_cast<Joint>(index);
  (void)request.motors.add(motor);
}

void readIndex(SectionCursor& in, Few<std::uint8_t, kJoints>& to, RequestIssues& issues) {
  const std::uint8_t index = in.byte();
  if (index >= kJoints) ++issues.invalid_sensors;
  (void)to.add(index);
}

/// Skips another version: its client gets a reply without the extension.
void readExtension(SectionCursor& in, Request& request) {
  const std::uint8_t version = in.byte();
  const std::size_t size = in.byte();
  if (!in.has(size)) return;
  const std::size_t end = in.at() + size;
  if (version == kExtensionVersion && size >= kExtensionContent) {
    const auto word = [&in] { return static_cast<std::uint32_t>(in.word()); };
    const std::uint8_t flags = in.byte();
    request.extension.start_where_it_is = (flags & 1) != 0;
    request.extension.end_of_session = (flags & 2) != 0;
    request.extension.only_if_up = (flags & 4) != 0;
    request.extension.unattended = (flags & 8) != 0;
    request.extension.fault_resets = word();
    request.extension.picture = word();
    const std::uint64_t high = word();
    request.extension.until_cycle = high << 32 | word();
    request.extended = true;
  }
  in.stepTo(end);
}

}  // namespace

void readSections(std::span<const std::uint8_t> sections, Request& request, RequestIssues& issues) {
  SectionCursor in{sections};
  request = {};
  issues = {};
  request.accelerometer = in.take('A');
  request.gyro = in.take('G');
  request.camera = in.take('C');
  for (std::size_t i = 0; i < kLeds && in.take('L', 4); ++i) readLed(in, request, issues);
  for (std::size_t i = 0; i < kJoints && in.take('S', 1); ++i) readMotor(in, request, issues);
  for (std::size_t i = 0; i < kJoints && in.take('P', 1); ++i) readIndex(in, request.positions, issues);
  for (std::size_t i = 0; i < kJoints && in.take('F', 1); ++i) readIndex(in, request.torques, issues);
  if (in.take(static_cast<char>(kExtensionTag), 2)) readExtension(in, request);
  issues.cut_off = in.cutOff();
  if (in.cutOff() || in.here() == 0) return;
  issues.unknown_at = kRequestHead + in.at();
  issues.unknown_byte = in.here();
}

std::span<std::uint8_t> RequestReader::room() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, pending());
  end_ -= begin_;
  begin_ = 0;
  return std::span{buffer_}.subspan(end_);
}

RequestReader::Result RequestReader::next(Request& request, RequestIssues& issues) {
  const auto* const first = std::find(buffer_.data() + begin_, buffer_.data() + end_, kFirstByte);
  const std::size_t skipped = static_cast<std::size_t>(first - buffer_.data()) - begin_;
  garbage_ += skipped;
  begin_ += skipped;
  if (pending() < kRequestHead) return Result::kIncomplete;
  const std::size_t length = first[1] | first[2] << 8;
  if (length < kRequestHead || length > kMostStated) return Result::kInvalid;
  if (pending() < length) return Result::kIncomplete;
  readSections({first + kRequestHead, length - kRequestHead}, request, issues);
  begin_ += length;
  return Result::kRequest;
}

}  // namespace darwinop::remote
