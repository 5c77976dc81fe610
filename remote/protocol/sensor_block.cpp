// Sensor block of the protocol extension (docs/remote-protocol.md). One list of values in wire order serves reader and
// writer.
#include "remote/protocol/sensor_block.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace darwinop::remote {
namespace {

constexpr std::uint8_t kAgeNever = 255;
constexpr std::uint32_t kAgeMost = 254;  // this age or older

class BlockWriter {
 public:
  explicit BlockWriter(std::vector<std::uint8_t>& bytes) : bytes_{bytes} {}

  template <std::integral T>
  void integer(const T& value) {
    for (int shift = 8 * (static_cast<int>(sizeof(T)) - 1); shift >= 0; shift -= 8)
      bytes_.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> shift));
  }
  template <std::floating_point T>
  void real(const T& value) {
    integer(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  void age(const Freshness& freshness) {
    integer(freshness.ever() ? static_cast<std::uint8_t>(std::min(freshness.age, kAgeMost)) : kAgeNever);
  }
  template <class... Bools>
  void flags(const Bools&... bits) {
    unsigned all = 0, at = 0;
    ((all |= (bits ? 1U : 0U) << at++), ...);
    integer(static_cast<std::uint8_t>(all));
  }
  template <class Enum>
  void choice(const Enum& value, Enum /*most*/) {
    integer(static_cast<std::uint8_t>(value));
  }
  template <std::size_t N>
  void set(const std::bitset<N>& bits) {
    integer(static_cast<std::uint32_t>(bits.to_ulong()));
  }
  void faults(const std::bitset<kFaults>& active) {
    std::uint64_t by_number = 0;
    for (std::size_t i = 0; i < kFaults; ++i)
      if (active[i]) by_number |= std::uint64_t{1} << static_cast<unsigned>(kFaultTable[i].fault);
    integer(by_number);
  }
  void fault(const Fault& fault) { integer(static_cast<std::uint8_t>(fault)); }

 private:
  std::vector<std::uint8_t>& bytes_;
};

class BlockReader {
 public:
  explicit BlockReader(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

  template <std::integral T>
  void integer(T& value) {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) all = all << 8 | bytes_[at_++];
    value = static_cast<T>(all);
  }
  template <std::floating_point T>
  void real(T& value) {
    value = static_cast<T>(std::bit_cast<float>(taken<std::uint32_t>()));
  }
  void age(Freshness& freshness) {
    const auto age = taken<std::uint8_t>();
    freshness.age = age == kAgeNever ? Freshness::kNever : age;
  }
  template <class... Bools>
  void flags(Bools&... bits) {
    unsigned all = taken<std::uint8_t>();
    ((bits = (all & 1U) != 0, all >>= 1U), ...);
  }
  /// A value beyond `most` becomes the first enumerator.
  template <class Enum>
  void choice(Enum& value, Enum most) {
    const auto number = taken<std::uint8_t>();
    value = number > static_cast<std::uint8_t>(most) ? Enum{} : static_cast<Enum>(number);
  }
  template <std::size_t N>
  void set(std::bitset<N>& bits) {
    bits = std::bitset<N>{taken<std::uint32_t>() & ((1U << N) - 1U)};
  }
  void faults(std::bitset<kFaults>& active) {
    const auto by_number = taken<std::uint64_t>();
    for (std::size_t i = 0; i < kFaults; ++i)
      active[i] = (by_number >> static_cast<unsigned>(kFaultTable[i].fault) & 1U) != 0;
  }
  void fault(Fault& fault) { fault = row(static_cast<Fault>(taken<std::uint8_t>())).fault; }

 private:
  template <std::integral T>
  T taken() {
    T value{};
    integer(value);
    return value;
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};
static_assert(std::ranges::all_of(kFaultTable, [](const FaultRow& r) { return static_cast<int>(r.fault) < 64; }));

template <class Block, class Joint>
void joint(Block& block, Joint& seen) {
  block.age(seen.motion);
  block.real(seen.position.value);
  block.real(seen.velocity.value);
  block.real(seen.load);
  block.integer(seen.error_bits);
  block.age(seen.polled);
  block.real(seen.voltage.value);
  block.real(seen.temperature.value);
  block.real(seen.torque_limit.value);
  block.real(seen.commanded.value);
  block.flags(seen.torque_enabled, seen.driven);
}

template <class Block, class Board>
void board(Block& block, Board& seen) {
  block.age(seen.motion);
  for (auto& axis : seen.gyro) block.real(axis.value);
  for (auto& axis : seen.accelerometer) block.real(axis.value);
  block.integer(seen.buttons);
  block.real(seen.voltage.value);
  block.real(seen.microphone_left);
  block.flags(seen.servo_power, seen.buttons_known, seen.absent);
  block.integer(seen.led_panel);
  block.integer(seen.led_head);
  block.integer(seen.led_eye);
  block.integer(seen.error_bits);
}

template <class Block, class Image>
void bus(Block& block, Image& seen) {
  for (auto* count : {&seen.link.exchanges, &seen.link.incomplete, &seen.link.retries, &seen.link.bad_checksums,
                      &seen.link.garbage_bytes, &seen.link.late_replies, &seen.link.reconnects,
                      &seen.link.clamped_goals, &seen.wire.bytes_out, &seen.wire.bytes_in})
    block.integer(*count);
  block.integer(seen.wire.wire_ns);
  block.integer(seen.wire.bus_ns);
}

template <class Block, class Report>
void safetyReport(Block& block, Report& seen) {
  block.choice(seen.state, static_cast<State>(kStates - 1));
  block.faults(seen.active);
  block.fault(seen.worst);
  block.integer(seen.worst_joint);
  block.choice(seen.reaction, Reaction::kStopSending);
  for (auto& hits : seen.limit_hits) block.integer(hits);
  block.flags(seen.controller_must_end);
  block.integer(seen.session);
  block.set(seen.tripped);
  block.set(seen.missed_start);
  block.integer(seen.start_timeouts);
  for (auto* setting : {&seen.gentle_speed, &seen.default_p_gain, &seen.default_speed}) block.real(*setting);
  block.choice(seen.at_end, Reaction::kStopSending);
}

template <class Block, class Image>
void image(Block& block, Image& seen) {
  block.integer(seen.cycle);
  block.integer(seen.time_ns);
  block.integer(seen.period_ns);
  block.integer(seen.wake_latency_ns);
  block.integer(seen.slack_ns);
  block.integer(seen.overruns);
  for (auto& each : seen.joint) joint(block, each);
  board(block, seen.board);
  bus(block, seen);
  safetyReport(block, seen.safety);
  block.set(seen.silent);
}

}  // namespace

void writeSensors(const Sensors& seen, std::vector<std::uint8_t>& bytes) {
  [[maybe_unused]] const std::size_t before = bytes.size();
  BlockWriter block{bytes};
  image(block, seen);
  assert(bytes.size() - before == kSensorBlock);
}

Sensors readSensors(std::span<const std::uint8_t> bytes) {
  assert(bytes.size() == kSensorBlock);
  Sensors seen;
  BlockReader block{bytes};
  image(block, seen);
  return seen;
}

}  // namespace darwinop::remote
