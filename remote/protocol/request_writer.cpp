// Serializes requests byte for byte as the simulator's clients do.
#include "remote/protocol/request_writer.hpp"

namespace darwinop::remote {
namespace {

class RequestWriter {
 public:
  explicit RequestWriter(RequestBuffer& buffer) : buffer_{buffer} {}

  void byte(std::uint8_t value) { buffer_[size_++] = value; }
  void tag(char value) { byte(static_cast<std::uint8_t>(value)); }
  void word(std::int32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
      byte(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> shift));
  }
  std::span<const std::uint8_t> finish() {
    byte(0);
    buffer_[1] = static_cast<std::uint8_t>(size_ & 0xFF);
    buffer_[2] = static_cast<std::uint8_t>(size_ >> 8);
    return std::span{buffer_}.first(size_);
  }

 private:
  RequestBuffer& buffer_;
  std::size_t size_ = 0;
};

void writeMotor(const MotorSetting& motor, RequestWriter& out) {
  out.tag('S');
  out.byte(static_cast<std::uint8_t>(motor.joint));
  const auto sub = [&](char tag, MotorSetting::Bit bit, std::int32_t value) {
    if (!motor.has(bit)) return;
    out.tag(tag);
    out.word(value);
  };
  sub('p', MotorSetting::kPosition, motor.position);
  sub('v', MotorSetting::kVelocity, motor.velocity);
  sub('a', MotorSetting::kAcceleration, motor.acceleration);
  sub('m', MotorSetting::kAvailableTorque, motor.available_torque);
  if (motor.has(MotorSetting::kPid)) {
    out.tag('c');
    for (const std::int32_t part : motor.pid) out.word(part);
  }
  sub('f', MotorSetting::kTorque, motor.torque);
}

void writeExtension(const Extension& extension, RequestWriter& out) {
  out.byte(kExtensionTag);
  out.byte(kExtensionVersion);
  out.byte(kExtensionContent);
  out.byte(static_cast<std::uint8_t>((extension.start_where_it_is ? 1 : 0) | (extension.end_of_session ? 2 : 0) |
                                     (extension.only_if_up ? 4 : 0) | (extension.unattended ? 8 : 0)));
  out.word(static_cast<std::int32_t>(extension.fault_resets));
  out.word(static_cast<std::int32_t>(extension.picture));
  out.word(static_cast<std::int32_t>(extension.until_cycle >> 32));
  out.word(static_cast<std::int32_t>(extension.until_cycle & 0xFFFFFFFF));
}

}  // namespace

std::span<const std::uint8_t> writeRequest(const Request& request, RequestBuffer& buffer) {
  RequestWriter out{buffer};
  out.byte(kFirstByte);
  out.byte(0);  // length, filled in by finish()
  out.byte(0);
  if (request.accelerometer) out.tag('A');
  if (request.gyro) out.tag('G');
  if (request.camera) out.tag('C');
  for (const LedSetting& led : request.leds) {
    out.tag('L');
    out.byte(static_cast<std::uint8_t>(led.led));
    for (int shift = 16; shift >= 0; shift -= 8) out.byte(static_cast<std::uint8_t>(led.colour >> shift));
  }
  for (const MotorSetting& motor : request.motors) writeMotor(motor, out);
  for (const std::uint8_t index : request.positions) {
    out.tag('P');
    out.byte(index);
  }
  for (const std::uint8_t index : request.torques) {
    out.tag('F');
    out.byte(index);
  }
  if (request.extended) writeExtension(request.extension, out);
  return out.finish();
}

}  // namespace darwinop::remote
