// A byte block with its completion time, and a fixed-size ring of such blocks.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::hil {

struct Chunk {
  static constexpr std::size_t kCapacity = 2 * kMaxFrame;  // a frame, and as many bytes added by a fault
  Nanos at{0};
  std::size_t size = 0;
  std::array<std::uint8_t, kCapacity> data;

  Chunk() = default;
  Chunk(Bytes bytes, Nanos when) : at{when}, size{std::min(bytes.size(), kCapacity)} {
    std::copy_n(bytes.begin(), size, data.begin());
  }
  [[nodiscard]] Bytes bytes() const { return Bytes{data}.first(size); }
  void dropFront(std::size_t count) {
    std::copy_n(data.begin() + static_cast<std::ptrdiff_t>(count), size - count, data.begin());
    size -= count;
  }
};

class ChunkRing {
 public:
  explicit ChunkRing(std::size_t capacity) : slots_(capacity) {}

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] Chunk& front() noexcept { return slots_[first_]; }
  [[nodiscard]] const Chunk& front() const noexcept { return slots_[first_]; }
  void pop() noexcept {
    first_ = (first_ + 1) % slots_.size();
    --count_;
  }
  /// Returns false and drops the block if the ring is full.
  bool push(Bytes bytes, Nanos at) noexcept {
    if (count_ == slots_.size()) return false;
    Chunk& slot = slots_[(first_ + count_++) % slots_.size()];
    slot.at = at;
    slot.size = std::min(bytes.size(), Chunk::kCapacity);
    std::copy_n(bytes.begin(), slot.size, slot.data.begin());
    return true;
  }
  void clear() noexcept { first_ = count_ = 0; }

 private:
  std::vector<Chunk> slots_;
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace darwinop::hil
