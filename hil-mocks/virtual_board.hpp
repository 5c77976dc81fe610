// A CM-730 with twenty MX-28 on its bus, byte for byte, on a clock that is passed in.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "hal/body.hpp"
#include "hil-mocks/chunk.hpp"
#include "hil-mocks/device.hpp"
#include "hil-mocks/input_queue.hpp"
#include "hil-mocks/instruction_parser.hpp"
#include "hil-mocks/virtual_servo.hpp"

namespace darwinop::hil {

/// BoardOptions::body_step of a body with physics: as often as a servo looks at its encoder.
inline constexpr Nanos kPhysicsStep = std::chrono::milliseconds{1};

struct BoardOptions {
  Nanos byte_time = std::chrono::microseconds{10};  // 1 Mbaud, 8N1; 0: unpaced
  Nanos body_step = std::chrono::milliseconds{2};
  Nanos servo_boot{0};       // a servo hears nothing so long after its supply came on
  bool servo_power = false;  // at the start; false as after switching the robot on
  std::uint8_t firmware = 0x13;
  // What a board with another firmware lacks.
  bool bulk_read = true, sync_write = true;
  std::uint8_t only_block = 0;  // bytes of its own that a BULK_READ can have; 0: any number
  double supply_v = 11.8;
  double temperature_c = 30;
  std::array<ServoOptions, kJoints> servo{};
};

struct BoardCounters {
  std::uint64_t frames = 0, sync_writes = 0, bulk_reads = 0, replies = 0;
  std::uint64_t bad_checksums = 0;  // instructions
  std::uint64_t lost_bytes = 0;     // no room for them
};

/// The CM-730's own registers.
class BoardDevice : public Device {
 public:
  explicit BoardDevice(std::uint8_t firmware);
  [[nodiscard]] bool servoPower() const { return table_.byte(board::kDxlPower) != 0; }
  void setServoPower(bool on) { table_.setByte(board::kDxlPower, on ? 1 : 0); }
  void measure(const BodyState& body, double supply_v);
  /// The RESET button.
  void restart();

 private:
  [[nodiscard]] std::uint8_t standingErrors() const override { return 0; }
  void factoryReset() override {}  // acknowledged, nothing happens (firmware)
};

/// Time only moves forward, by receive() and advance(). Not thread-safe. Requests and replies share one line:
/// bytes that come while devices still talk wait for them.
class VirtualBoard {
 public:
  VirtualBoard(const BoardOptions& options, Body& body);

  /// Bytes handed over by the PC at `when`; they are on the wire from then on, or from when the line is free.
  void receive(Bytes bytes, Nanos when) noexcept;
  /// Lets everything happen that happens until then. With `stop_at_reply` it returns right after a reply was
  /// made; now() tells how far it got.
  void advance(Nanos until, bool stop_at_reply = false) noexcept;
  [[nodiscard]] Nanos now() const noexcept { return now_; }
  /// No status begins before this unless more is received; nothing: none will.
  [[nodiscard]] std::optional<Nanos> earliestReply() const noexcept;
  /// Status frames, one a chunk; `at` is when the last byte is on the PC's side, and may be ahead of now().
  [[nodiscard]] ChunkRing& output() noexcept { return output_; }

  // -- faults; each lasts until it is taken back
  void setServoDead(Joint joint, bool dead) noexcept;
  void setServoErrors(Joint joint, std::uint8_t bits) noexcept { servoOf(joint).setErrors(bits); }
  /// Nothing: as the body says, or else BoardOptions.
  void setTemperature(Joint joint, std::optional<double> celsius) noexcept { servoOf(joint).setTemperature(celsius); }
  void setSupply(double volt) noexcept;
  /// The supply falls by so much (V) when all servos draw their full load, and in proportion to what they draw.
  void setSag(double volt) noexcept { sag_v_ = volt; }
  /// How long a servo takes to start when it gets its supply the next time.
  void setBoot(Joint joint, Nanos boot) noexcept { boot_[index(joint)] = boot; }
  void setJam(Joint joint, std::optional<Nanos> trips_after) noexcept { servoOf(joint).setJam(trips_after); }
  /// A second device with the id of this servo answers, too.
  void setTwin(Joint joint, bool there) noexcept { twins_[index(joint)] = there; }
  [[nodiscard]] bool hasTwin(Joint joint) const noexcept { return twins_[index(joint)]; }
  /// So many more BULK_READs are heard by no device.
  void missBulkReads(int count) noexcept { bulk_reads_to_miss_ += count; }
  /// Bytes towards the PC that nobody asked for.
  void babble(Bytes bytes) noexcept;
  /// Pressed by a fault, besides what the body says.
  void setButtons(std::uint8_t bits) noexcept { buttons_ = bits; }
  /// Replaces the body's accelerometer, m/s2.
  void setAcceleration(const std::optional<std::array<double, 3>>& accel) noexcept { acceleration_ = accel; }
  /// Neither reads nor answers until then; the body goes on. A time in the past ends a stall.
  void stallUntil(Nanos when) noexcept { stalled_until_ = when; }
  /// The RESET button: registers to their defaults, servo power off.
  void pressReset() noexcept;

  // -- for tests and reports
  /// Sees what happens at each motor. Null: nobody.
  void observe(ServoObserver* observer) noexcept;
  [[nodiscard]] const BoardOptions& options() const noexcept { return options_; }
  [[nodiscard]] const BoardCounters& counters() const noexcept { return counters_; }
  [[nodiscard]] const VirtualServo& servo(Joint joint) const { return servos_[index(joint)]; }
  [[nodiscard]] const BoardDevice& device() const { return device_; }
  [[nodiscard]] const Body& body() const { return body_; }

 private:
  struct Turn {
    std::uint8_t count, id, address;
  };

  VirtualServo& servoOf(Joint joint) { return servos_[index(joint)]; }
  [[nodiscard]] std::optional<Nanos> nextEvent() const noexcept;
  [[nodiscard]] Nanos free() const { return std::max(line_free_, stalled_until_); }
  void stepBody(Nanos until) noexcept;
  void sagSupply() noexcept;
  void takeByte() noexcept;
  void execute(bool good_checksum) noexcept;
  void executeUnicast(std::uint8_t id, std::uint8_t instruction, Bytes params, bool good_checksum) noexcept;
  void executeSyncWrite(Bytes params) noexcept;
  void startBulkRead(Bytes params) noexcept;
  void nextTurn() noexcept;
  void carryOut(Device& device, std::uint8_t instruction, Bytes params) noexcept;
  void afterBoardWrite() noexcept;
  void measure(Device& device) noexcept;
  template <class F>
  void forEachListener(std::uint8_t id, F&& action) noexcept;

  // A status under construction. Two devices with one id talk at once: their bits are and-ed on the wire.
  void beginReply() noexcept { reply_size_ = 0; }
  void addReply(const Device& device, const Device::Answer& answer) noexcept;
  void addTwin(const VirtualServo& servo, std::uint8_t address, std::uint8_t count) noexcept;
  void sendReply(bool on_the_bus) noexcept;

  BoardOptions options_;
  Body& body_;
  BoardDevice device_;
  std::vector<VirtualServo> servos_;
  Drives drives_{};
  InputQueue input_;
  ChunkRing output_{1024};
  InstructionParser parser_;
  BoardCounters counters_;
  bool silenced_ = false;  // the body is in trouble: a robot that hangs answers nothing

  Nanos now_{0}, body_time_{0};
  Nanos line_free_{0};      // bus: bytes of a request or reply until then
  Nanos downlink_free_{0};  // board to PC
  Nanos stalled_until_{0};

  std::array<Turn, 85> turns_{};  // of the BULK_READ being answered
  std::size_t turn_ = 0, turn_count_ = 0;
  std::bitset<256> had_turn_;

  std::array<std::uint8_t, kMaxFrame> reply_{};
  std::size_t reply_size_ = 0;
  Nanos reply_delay_{0};

  double supply_v_, sag_v_ = 0;
  double rail_v_;  // what is left of the supply
  std::array<Nanos, kJoints> boot_{};
  std::bitset<kJoints> twins_;
  int bulk_reads_to_miss_ = 0;
  std::uint8_t buttons_ = 0;
  std::optional<std::array<double, 3>> acceleration_;
};

}  // namespace darwinop::hil
