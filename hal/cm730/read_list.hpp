// Servos of the next BulkRead, and their order.
//
// Devices reply in list order, each after the one before it, so a silent servo silences all behind it. The first servo
// that did not reply is moved to the end of the next list, where it affects no other; if it stays silent it is removed
// and retried periodically, at the end of the list.
//
// Without a board the first servo of the list opens the exchange (reply_decoder.hpp). If it is silent, nothing is known
// about the others: the next list begins with a servo of another chain.
//
// Each cycle polls one servo (round robin). A servo that missed a reply is polled as soon as it replies again, because
// it may have restarted; it gets no goals before that. A servo about to get torque is polled as well.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "core/joints.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::cm730 {

class ReadList {
 public:
  struct Entry {
    std::uint8_t joint;  // index, 0..19
    bool poll;           // true: read the long window
  };
  using Mask = std::bitset<kJoints>;

  /// `period` of the loop, to convert times to cycles. `polls`: maximum number of polls per cycle besides the
  /// round-robin one. `absent`: never read. Without a `board` the first servo is always polled.
  explicit ReadList(Nanos period, std::size_t polls = kJoints, const Mask& absent = {}, bool board = true);

  /// Servos to read in this cycle, in order. The board is always read first and is not part of the list.
  std::span<const Entry> next() noexcept;

  /// Requests polls, besides those of servos that missed a reply.
  void requestPolls(const Mask& who) noexcept { due_ |= who; }

  /// Servos of the last list that replied. Call only if the board replied; otherwise the result says nothing about
  /// servos.
  void answered(const Mask& who) noexcept;
  /// The board did not reply; without a board the first servo.
  void missedAll() noexcept { due_.set(); }

  // -- without a board
  /// As next(), but the first servo only.
  std::span<const Entry> nextAlone() noexcept;
  /// The first servo of the last list replied, or did not.
  void leaderAnswered() noexcept { passed_.reset(); }
  void leaderMissed() noexcept;
  /// No servo has replied for some cycles: each is asked again, also those that were silent before.
  void forgetSilent() noexcept;

  /// Servo power is off: no servo is read until kBootTime after power returns.
  void powerIsOff() noexcept;
  void powerIsOn() noexcept;

  /// Power has been on for at least the start-up time of a servo.
  [[nodiscard]] bool servosAreUp() const noexcept { return boot_wait_ == 0 && powered_; }

  /// Servos that are removed from the list for now.
  [[nodiscard]] const Mask& silent() const noexcept { return silent_; }
  /// Repeated requests to servos that had not replied.
  [[nodiscard]] std::uint32_t retries() const noexcept { return retries_; }

 private:
  void append(const Mask& joints) noexcept;
  void placeLeader() noexcept;
  void appendProbe() noexcept;
  void choosePolls() noexcept;
  void pollInTurn() noexcept;
  void forgive(const Mask& who) noexcept;
  void blame(std::size_t joint) noexcept;
  void onTrial(std::size_t joint) noexcept;

  std::array<Entry, kJoints> list_{};
  std::size_t length_ = 0;
  std::size_t polls_;
  bool board_;
  Mask passed_;           // without a board: the first servos of the lists since the last reply
  Mask listed_, polled_;  // in the list; of these, polled
  Mask silent_, absent_;
  Mask suspected_;                                 // behind the faulty servo on its chain, no reply since
  Mask due_;                                       // to be polled: missed a reply, or requested
  Mask missed_;                                    // misses_ is not 0
  Mask tried_;                                     // on_trial_ is not 0
  std::array<std::uint8_t, kJoints> misses_{};     // in a row, only those attributed to the servo
  std::array<std::uint16_t, kJoints> on_trial_{};  // remaining cycles at the end of the list
  std::size_t next_probe_ = 0, next_poll_ = 0;
  std::uint32_t cycles_to_probe_ = 0;
  bool probe_answered_ = false;
  std::uint32_t boot_cycles_, boot_wait_ = 0;
  bool powered_ = false;  // as far as is known
  std::uint32_t retries_ = 0;
};

}  // namespace darwinop::cm730
