// The CM-730 and its twenty servos as a ServoBus: one SyncWrite, one BulkRead, over any byte line.
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
#include "hal/cm730/joint_offsets.hpp"
#include "hal/cm730/read_list.hpp"
#include "hal/cm730/reply_decoder.hpp"
#include "hal/cm730/request_tag.hpp"
#include "hal/cm730/wire.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::cm730 {

struct BusConfig {
  Nanos period{16'000'000};
  /// How long past its wire time an answer may take before it counts as missing. USB delivers in 1 ms frames, the
  /// FTDI chip holds back the end of an answer for 1 ms, and a plain kernel may be late by milliseconds.
  Nanos margin{5'000'000};
  JointOffsets offsets{};
  std::bitset<kJoints> absent{};    // joints that are never asked
  bool fixed_block_length = false;  // request_tag.hpp

  /// As patient as the period allows: kFullCycle. At 8 ms a missing answer can make its cycle overrun;
  /// less patience would take late USB frames for missing answers.
  static constexpr BusConfig forPeriod(Nanos period, const JointOffsets& offsets = {}) {
    return {period, std::clamp(period - kFullCycle, Nanos{1'000'000}, Nanos{5'000'000}), offsets, {}, false};
  }
  /// How many servos may be polled in one cycle: what the period has room for beside a full cycle and a missing
  /// answer, and four in any case.
  [[nodiscard]] constexpr std::size_t polls() const {
    constexpr Nanos kPollTime = wireTime(kServoPoll.count - kServoWindow.count);
    const auto room = (period - kFullCycle - margin) / kPollTime;
    return static_cast<std::size_t>(std::clamp<std::int64_t>(room, 4, kJoints));
  }

  static constexpr Nanos kFullCycle{5'500'000};  // on the wire, twenty servos
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
  void learn(std::span<const ReadList::Entry> list) noexcept;
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
  std::uint32_t silent_cycles_ = 0;  // in a row without the board
  std::uint32_t reconnects_seen_ = 0;
  LedCommand led_wanted_{};
  bool power_wanted_ = false;
  static constexpr int kLocks = 2;  // frames; nobody acknowledges them
  int locks_due_ = kLocks;
  int board_write_wait_ = 0;
  BoardReading board_{};
};

}  // namespace darwinop::cm730
