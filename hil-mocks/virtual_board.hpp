// A CM-730 with twenty MX-28 on its bus at the byte level, on an external clock.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "hal/body.hpp"
#include "hil-mocks/chunk.hpp"
#include "hil-mocks/device.hpp"
#include "hil-mocks/input_queue.hpp"
#include "hil-mocks/instruction_parser.hpp"
#include "hil-mocks/virtual_servo.hpp"

namespace darwinop::hil {

/// BoardOptions::body_step of a body with physics: the encoder sampling interval of a servo.
inline constexpr Nanos kPhysicsStep = std::chrono::milliseconds{1};
/// Time after which a body with physics, placed with stiff joints, lies still without torque. Of the twin on its floor:
/// 0.12 s.
inline constexpr Nanos kSettlesIn = std::chrono::milliseconds{200};

struct BoardOptions {
  Nanos byte_time = std::chrono::microseconds{10};  // 1 Mbaud, 8N1; 0: unpaced
  Nanos body_step = std::chrono::milliseconds{2};
  Nanos servo_boot{0};       // boot time of a servo after its supply is switched on
  bool servo_power = false;  // initial state; false as after switching the robot on
  std::uint8_t firmware = 0x13;
  std::uint16_t model = find(kCm730, "model").reset;
  bool board = true;  // false: servos alone on a USB2Dynamixel or U2D2, always supplied
  // Missing features of other firmware versions.
  bool bulk_read = true, sync_write = true;
  std::uint8_t only_block = 0;  // the only number of board bytes that BULK_READ supports; 0: any
  double supply_v = 11.8;
  double temperature_c = 30;
  std::array<ServoOptions, kJoints> servo{};
};

struct BoardCounters {
  std::uint64_t frames = 0, sync_writes = 0, bulk_reads = 0, replies = 0;
  std::uint64_t bad_checksums = 0;  // instructions
  std::uint64_t lost_bytes = 0;     // dropped because the queue was full
};

/// The CM-730's registers.
class BoardDevice : public BusDevice {
 public:
  BoardDevice(std::uint16_t model, std::uint8_t firmware);
  [[nodiscard]] bool servoPower() const { return table_.byte(board::kDxlPower) != 0; }
  void setServoPower(bool on) { table_.setByte(board::kDxlPower, on ? 1 : 0); }
  void measure(const BodyState& body, double supply_v);
  /// The RESET button.
  void restart();

 private:
  [[nodiscard]] std::uint8_t standingErrors() const override { return 0; }
  void factoryReset() override {}  // acknowledged without effect (firmware)
};

/// Time advances only by receive() and advance(). Not thread-safe. Half duplex: bytes received while devices transmit
/// wait for them.
class VirtualBoard {
 public:
  VirtualBoard(const BoardOptions& options, Body& body);

  /// Bytes sent by the PC at `when`; they are on the wire from then on, or from when the line is free.
  void receive(Bytes bytes, Nanos when) noexcept;
  /// Simulates until then. With `stop_at_reply` it returns after the first reply; now() gives the time reached.
  void advance(Nanos until, bool stop_at_reply = false) noexcept;
  [[nodiscard]] Nanos now() const noexcept { return now_; }
  /// Earliest time of the next status unless more is received; empty: none.
  [[nodiscard]] std::optional<Nanos> earliestReply() const noexcept;
  /// Status frames, one per chunk; `at` is the arrival of the last byte at the PC, possibly after now().
  [[nodiscard]] ChunkRing& output() noexcept { return output_; }

  // -- faults; each lasts until it is reset
  void setServoDead(Joint joint, bool dead) noexcept;
  void setServoErrors(Joint joint, std::uint8_t bits) noexcept { servoOf(joint).setErrors(bits); }
  /// Empty: from the body, else BoardOptions.
  void setTemperature(Joint joint, std::optional<double> celsius) noexcept { servoOf(joint).setTemperature(celsius); }
  void setSupply(double volt) noexcept;
  /// Voltage drop (V) at full load of all servos; proportional to their current.
  void setSag(double volt) noexcept { sag_v_ = volt; }
  /// Boot time of a servo at its next power-up.
  /// Chance that this servo misses a request, and that its answer is damaged on the bus.
  void setNoise(Joint joint, double chance) noexcept { noise_[index(joint)] = chance; }
  void setBoot(Joint joint, Nanos boot) noexcept { boot_[index(joint)] = boot; }
  void setJam(Joint joint, std::optional<Nanos> trips_after) noexcept { servoOf(joint).setJam(trips_after); }
  /// Adds a second device with this servo's id.
  void setTwin(Joint joint, bool there) noexcept { twins_[index(joint)] = there; }
  [[nodiscard]] bool hasTwin(Joint joint) const noexcept { return twins_[index(joint)]; }
  /// The next n BULK_READs are received by no device.
  void missBulkReads(int count) noexcept { bulk_reads_to_miss_ += count; }
  void forgetMisses() noexcept { bulk_reads_to_miss_ = 0; }
  /// Unsolicited bytes towards the PC.
  void babble(Bytes bytes) noexcept;
  /// Pressed by a fault, in addition to the body's buttons.
  void setButtons(std::uint8_t bits) noexcept { buttons_ = bits; }
  /// Overrides the body's accelerometer, m/s2.
  void setAcceleration(const std::optional<std::array<double, 3>>& accel) noexcept { acceleration_ = accel; }
  /// Until then the board neither reads nor replies; the body continues. A time in the past ends a stall.
  void stallUntil(Nanos when) noexcept { stalled_until_ = when; }
  /// RESET button: registers to their defaults, servo power off.
  void pressReset() noexcept;

  // -- for tests and reports
  /// Observes each motor. May be null.
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
  void supplyServos() noexcept;
  void takeByte() noexcept;
  void execute(bool good_checksum) noexcept;
  void executeUnicast(std::uint8_t id, std::uint8_t instruction, Bytes params, bool good_checksum) noexcept;
  void executeSyncWrite(Bytes params) noexcept;
  void startBulkRead(Bytes params) noexcept;
  void nextTurn() noexcept;
  void drawUnreached() noexcept;
  void damageReply(std::uint8_t id) noexcept;
  void carryOut(BusDevice& device, std::uint8_t instruction, Bytes params) noexcept;
  void afterBoardWrite() noexcept;
  void measure(BusDevice& device) noexcept;
  template <class F>
  void forEachListener(std::uint8_t id, F&& action) noexcept;

  // A status under construction. Two devices with one id transmit at once: their bits are AND-ed on the wire.
  void beginReply() noexcept { reply_size_ = 0; }
  void addReply(const BusDevice& device, const BusDevice::Answer& answer) noexcept;
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
  bool silenced_ = false;  // the body has failed: the board answers nothing

  Nanos now_{0}, body_time_{0};
  Nanos line_free_{0};      // bus is busy with a request or reply until then
  Nanos downlink_free_{0};  // board to PC
  Nanos stalled_until_{0};

  std::array<Turn, 85> turns_{};  // entries of the current BULK_READ
  std::size_t turn_ = 0, turn_count_ = 0;
  std::bitset<256> had_turn_;

  std::array<std::uint8_t, kMaxFrame> reply_{};
  std::size_t reply_size_ = 0;
  Nanos reply_delay_{0};

  double supply_v_, sag_v_ = 0;
  double rail_v_;  // supply voltage under load
  bool brown_out_ = false;
  std::array<Nanos, kJoints> boot_{};
  std::array<double, kJoints> noise_{};
  std::bitset<kJoints> unreached_;  // servos that miss the present request
  Rng random_{1};
  std::bitset<kJoints> twins_;
  int bulk_reads_to_miss_ = 0;
  std::uint8_t buttons_ = 0;
  std::optional<std::array<double, 3>> acceleration_;
};

}  // namespace darwinop::hil
