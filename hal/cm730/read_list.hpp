// Which servos the next BulkRead asks, and in what order.
//
// Devices answer in list order, each waiting for the one before it, so a silent servo silences all behind it.
// The first one that did not answer goes to the end of the next list, where it can hurt only itself; if it stays
// silent it is left out, and asked again now and then, always last.
//
// One servo in turn is polled in each cycle. A servo that has missed an answer is polled as soon as it is
// received again, because it may have restarted, and gets no goals before that. So is one that is about to get torque.
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

  /// `period` of the loop, for what is counted in cycles but meant in seconds. `polls`: as many long windows at most
  /// are asked for in a cycle besides the one in turn. `absent`: never asked.
  explicit ReadList(Nanos period, std::size_t polls = kJoints, const Mask& absent = {});

  /// The servos to ask in this cycle, in order. The board is always asked first and is not part of the list.
  std::span<const Entry> next() noexcept;

  /// These are due to be polled, besides those that have missed an answer.
  void requestPolls(const Mask& who) noexcept { due_ |= who; }

  /// What came of the last list. Call only when the board itself answered: otherwise nothing is learnt.
  void answered(const Mask& who) noexcept;
  /// The board did not answer.
  void missedAll() noexcept { due_.set(); }

  /// Servo power is off: nobody is asked until a while after the next call of powerIsOn().
  void powerIsOff() noexcept;
  void powerIsOn() noexcept;

  /// Power is on, and has been for as long as a servo takes to start.
  [[nodiscard]] bool servosAreUp() const noexcept { return boot_wait_ == 0 && powered_; }

  /// Servos that have been given up on for now.
  [[nodiscard]] const Mask& silent() const noexcept { return silent_; }
  /// Times a servo was asked again after it had not answered.
  [[nodiscard]] std::uint32_t retries() const noexcept { return retries_; }

 private:
  void append(const Mask& joints) noexcept;
  void appendProbe() noexcept;
  void choosePolls() noexcept;
  void pollInTurn() noexcept;
  void forgive(const Mask& who) noexcept;
  void blame(std::size_t joint) noexcept;
  void onTrial(std::size_t joint) noexcept;

  std::array<Entry, kJoints> list_{};
  std::size_t length_ = 0;
  std::size_t polls_;
  Mask listed_, polled_;  // in the list, with a long window
  Mask silent_, absent_;
  Mask suspected_;                                 // on the chain of the faulty servo, no answer since
  Mask due_;                                       // to be polled: have missed an answer, or were asked for
  Mask missed_;                                    // whose misses_ are not 0
  Mask tried_;                                     // whose on_trial_ is not 0
  std::array<std::uint8_t, kJoints> misses_{};     // in a row, only those the servo is to blame for
  std::array<std::uint16_t, kJoints> on_trial_{};  // cycles it stays at the end after it misbehaved
  std::size_t next_probe_ = 0, next_poll_ = 0;
  std::uint32_t cycles_to_probe_ = 0;
  bool probe_answered_ = false;
  std::uint32_t boot_cycles_, boot_wait_ = 0;
  bool powered_ = false;  // as far as is known
  std::uint32_t retries_ = 0;
};

}  // namespace darwinop::cm730
