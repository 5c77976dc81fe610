// Bytes from the PC to the board with their send times. Fixed size; bytes that do not fit are dropped and counted.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::hil {

class InputQueue {
 public:
  /// Capacity for 16 s of 16 ms cycles: a stalled board answers queued requests later.
  InputQueue() : bytes_(1u << 18), runs_(1u << 12) {}

  [[nodiscard]] bool empty() const noexcept { return run_count_ == 0; }
  /// Send time of the first byte.
  [[nodiscard]] Nanos when() const noexcept { return runs_[first_run_].when; }

  void push(Bytes bytes, Nanos when) noexcept {
    if (bytes.empty()) return;
    if (byte_count_ + bytes.size() > bytes_.size() || run_count_ == runs_.size()) {
      lost_ += static_cast<std::uint32_t>(bytes.size());
      return;
    }
    for (const std::uint8_t byte : bytes) bytes_[(first_byte_ + byte_count_++) % bytes_.size()] = byte;
    runs_[(first_run_ + run_count_++) % runs_.size()] = {when, bytes.size()};
  }

  std::uint8_t pop() noexcept {
    const std::uint8_t byte = bytes_[first_byte_];
    first_byte_ = (first_byte_ + 1) % bytes_.size();
    --byte_count_;
    if (--runs_[first_run_].size == 0) {
      first_run_ = (first_run_ + 1) % runs_.size();
      --run_count_;
    }
    return byte;
  }

  void clear() noexcept { byte_count_ = run_count_ = 0; }
  [[nodiscard]] std::uint32_t lost() const noexcept { return lost_; }

 private:
  struct Run {
    Nanos when{0};
    std::size_t size = 0;
  };
  std::vector<std::uint8_t> bytes_;
  std::vector<Run> runs_;
  std::size_t first_byte_ = 0, byte_count_ = 0, first_run_ = 0, run_count_ = 0;
  std::uint32_t lost_ = 0;
};

}  // namespace darwinop::hil
