// The CM-730 and its twenty servos, or the servos alone, as a ServoBus: one SyncWrite, one BulkRead, over any byte
// line.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"
#include "hal/cm730/goal_writer.hpp"
#include "hal/cm730/imu_correction.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/cm730/read_list.hpp"
#include "hal/cm730/reply_decoder.hpp"
#include "hal/cm730/request_tag.hpp"
#include "hal/cm730/stall_torques.hpp"
#include "hal/cm730/wire.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::cm730 {

struct BusConfig {
  Nanos period{16'000'000};
  /// Time beyond its transmission time after which a reply counts as missing. USB transfers in 1 ms frames, the FTDI
  /// chip holds the end of a reply back for 1 ms, and a kernel without real-time patches may be late by milliseconds.
  Nanos margin{5'000'000};
  JointOffsets offsets{};
  std::bitset<kJoints> absent{};     // joints that are never read
  std::bitset<kJoints> no_writes{};  // joints whose EEPROM is not locked, beside `absent`
  bool fixed_block_length = false;   // request_tag.hpp
  StallTorques stall{};
  ImuCorrection imu{};
  bool board = true;  // false: servos alone on an adapter; the servo read first takes the board's place

  /// The longest margin that the period permits beside kFullCycle. At 8 ms a missing reply can make its cycle overrun;
  /// a shorter margin would take late USB frames for missing replies.
  static constexpr BusConfig forPeriod(Nanos period, const JointOffsets& offsets = {}) {
    return {period, std::clamp(period - kFullCycle, Nanos{1'000'000}, Nanos{5'000'000}), offsets, {}, {}, false, {}, {},
            true};
  }
  /// Maximum number of servos polled in one cycle: as many as fit into the period beside a full cycle and a missing
  /// reply, at least four.
  [[nodiscard]] constexpr std::size_t polls() const {
    constexpr Nanos kPollTime = wireTime(kServoPoll.count - kServoWindow.count);
    const auto room = (period - kFullCycle - margin) / kPollTime;
    return static_cast<std::size_t>(std::clamp<std::int64_t>(room, 4, kJoints));
  }

  static constexpr Nanos kFullCycle{5'500'000};  // transmission time of a cycle with twenty servos
};

class Cm730Bus final : public ServoBus {
 public:
  /// `line` must outlive the bus. Nothing is sent yet.
  Cm730Bus(ByteLine& line, const BusConfig& config);

  void write(const SafeCommands& commands) noexcept override;
  void read(BusReadings& readings) noexcept override;

 private:
  std::size_t sendRequest(std::span<const ReadList::Entry> list) noexcept;
  void receive(Nanos request_done) noexcept;
  [[nodiscard, gnu::always_inline]] std::span<const ReadList::Entry> nextList() noexcept;
  void learn(std::span<const ReadList::Entry> list) noexcept;
  [[gnu::cold, gnu::noinline]] void learnWithoutBoard() noexcept;
  using LedBytes = std::array<std::uint8_t, 5>;
  void sendBoardWrite() noexcept;
  [[nodiscard]] std::optional<LedBytes> ledsToWrite() const noexcept;
  void send(Bytes frame) noexcept;
  bool restThisCycle() noexcept;

  ByteLine& line_;
  BusConfig config_;
  GoalWriter goals_;
  ReadList list_;
  ReplyDecoder decoder_;
  RequestTag tag_;
  FrameReader reader_;
  std::array<std::uint8_t, kMaxFrame> frame_{};

  WireFigures wire_{};
  LinkCounters link_{};
  Nanos began_{0};
  bool wrote_ = false;
  std::uint32_t silent_cycles_ = 0;  // in a row without a reply of the board, or of the first servo
  std::uint32_t reconnects_seen_ = 0;
  LedCommand led_wanted_{};
  bool power_wanted_ = false;
  static constexpr int kLocks = 2;  // frames; sent twice, because they are not acknowledged
  int locks_due_ = kLocks;
  int board_write_wait_ = 0;
  BoardReading board_{};
};

}  // namespace darwinop::cm730
