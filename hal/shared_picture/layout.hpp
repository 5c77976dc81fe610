// Shared-memory layout by which one process publishes its camera pictures: three slots in a file.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::shared_picture {

inline constexpr int kWidth = 320, kHeight = 240;
inline constexpr std::size_t kPictureBytes = 2u * kWidth * kHeight;  // YUYV in camera format, no padding

/// Pictures are copied only if a request came within this time.
inline constexpr Nanos kAsked{2'000'000'000};
/// Maximum age of a picture. Older ones are left over from an earlier request or a dead process.
inline constexpr Nanos kFresh{2'000'000'000};

struct WindowFiles {
  /// The pictures. Writable by the owner only, readable by its group: an observer cannot modify them.
  std::string pictures;
  /// Time of the last request: 8 bytes, CLOCK_MONOTONIC in ns. Writable by the group. Never mapped: truncation of a
  /// mapped file would kill the camera's process.
  std::string asked;
};

struct Slot {
  alignas(64) std::atomic<std::uint32_t> turn{0};  // seqlock: odd while being written, incremented by two per picture
  alignas(8) std::uint64_t sequence = 0;
  alignas(8) std::int64_t time_ns = 0;  // CLOCK_MONOTONIC
  alignas(64) std::array<std::uint8_t, kPictureBytes> bytes{};
};

/// The writer uses the slots in turn, so that a copying reader is disturbed only after three more pictures. A writer
/// that dies in the middle leaves an odd `turn` and `newest` at the previous picture: readers never block.
struct SharedWindow {
  static constexpr std::uint32_t kMagic = 0x57504f44;  // "DOPW"
  static constexpr std::uint32_t kLayout = 1;          // increment when a member changes
  static constexpr std::uint32_t kSlots = 3;

  std::uint32_t magic = kMagic;
  std::uint32_t layout = kLayout;
  std::uint32_t size = sizeof(SharedWindow);
  std::atomic<std::uint32_t> other_size{0};  // width << 16 | height of a picture of unsupported size; 0: none
  std::atomic<std::uint32_t> newest{0};      // slot + 1; 0: none yet
  std::array<Slot, kSlots> slots{};
};

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
static_assert(sizeof(Slot) == 64 + kPictureBytes && sizeof(SharedWindow) == 64 + 3 * sizeof(Slot),
              "same layout for 32 and 64 bits");

}  // namespace darwinop::shared_picture
