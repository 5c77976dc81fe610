// FTDI latency timer: a partial packet is sent when it is full or when the timer expires.
#pragma once

#include <array>
#include <cstdint>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"
#include "hil-mocks/chunk.hpp"

namespace darwinop::hil {

/// Time 0: passes bytes at once. `send` takes Bytes.
class LatencyTimer {
 public:
  explicit LatencyTimer(Nanos time) : time_{time} {}

  template <class Send>
  void take(Bytes bytes, Nanos now, Send&& send) {
    if (time_ == Nanos{0}) return send(bytes);
    for (const std::uint8_t byte : bytes) {
      if (held_ == 0) due_ = now + time_;
      packet_[held_++] = byte;
      if (held_ == packet_.size()) flush(send);
    }
  }
  template <class Send>
  void expire(Nanos now, Send&& send) {
    if (held_ > 0 && now >= due_) flush(send);
  }
  [[nodiscard]] Nanos due() const { return held_ > 0 ? due_ : Nanos::max(); }
  void clear() { held_ = 0; }

 private:
  template <class Send>
  void flush(Send&& send) {
    send(Bytes{packet_}.first(held_));
    held_ = 0;
  }

  Nanos time_, due_{0};
  std::array<std::uint8_t, 62> packet_{};  // 64-byte USB packet minus two status bytes
  std::size_t held_ = 0;
};

}  // namespace darwinop::hil
