// Effects of wire faults on a frame.
#include "hil-mocks/wire_faults.hpp"

#include <algorithm>

namespace darwinop::hil {
namespace {

void insert(Chunk& chunk, std::size_t at, std::uint8_t byte) {
  if (chunk.size == Chunk::kCapacity) return;
  std::copy_backward(chunk.data.begin() + static_cast<std::ptrdiff_t>(at),
                     chunk.data.begin() + static_cast<std::ptrdiff_t>(chunk.size),
                     chunk.data.begin() + static_cast<std::ptrdiff_t>(chunk.size + 1));
  chunk.data[at] = byte;
  ++chunk.size;
}

void erase(Chunk& chunk, std::size_t at) {
  std::copy(chunk.data.begin() + static_cast<std::ptrdiff_t>(at + 1),
            chunk.data.begin() + static_cast<std::ptrdiff_t>(chunk.size),
            chunk.data.begin() + static_cast<std::ptrdiff_t>(at));
  --chunk.size;
}

}  // namespace

void spoil(Chunk& chunk, const InjectedFault& fault, Rng& random) noexcept {
  if (fault.kind == FaultKind::kDelay) {
    chunk.at += std::chrono::duration_cast<Nanos>(std::chrono::duration<double, std::milli>(fault.amount));
    return;
  }
  if (fault.kind == FaultKind::kRepeatFrame) {
    const std::size_t size = chunk.size;
    for (std::size_t i = 0; i < size; ++i) insert(chunk, chunk.size, chunk.data[i]);
    return;
  }
  const auto bytes = static_cast<int>(fault.amount);
  for (int i = 0; i < bytes; ++i) {
    if (fault.kind == FaultKind::kGarbage) {
      insert(chunk, 0, static_cast<std::uint8_t>(random.below(256)));
      continue;
    }
    if (chunk.size == 0) return;
    const std::size_t at = random.below(chunk.size);
    if (fault.kind == FaultKind::kDrop) erase(chunk, at);
    if (fault.kind == FaultKind::kCorrupt) chunk.data[at] ^= static_cast<std::uint8_t>(1 + random.below(255));
    if (fault.kind == FaultKind::kRepeat) insert(chunk, at, chunk.data[at]);
  }
}

void flicker(Chunk& chunk, const InjectedFault& fault, Rng& random) noexcept {
  constexpr std::size_t kIdAt = 2, kErrorAt = 4, kShortest = 6;
  if (chunk.size < kShortest) return;
  const std::size_t joint = chunk.data[kIdAt] - std::size_t{1};
  if (joint >= kJoints || !fault.joints[joint] || random.uniform() >= fault.chance) return;
  const auto right = [&] { return checksum(chunk.bytes().subspan(kIdAt, chunk.size - kIdAt - 1)); };
  if (chunk.data[chunk.size - 1] != right()) return;  // damaged on its way: the servo has sent another one
  chunk.data[kErrorAt] |= fault.bits;
  chunk.data[chunk.size - 1] = right();
}

}  // namespace darwinop::hil
