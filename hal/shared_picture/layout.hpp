// The window through which other processes see the camera of the one that has it open: three pictures in a file.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::shared_picture {

inline constexpr int kWidth = 320, kHeight = 240;
inline constexpr std::size_t kPictureBytes = 2u * kWidth * kHeight;  // YUYV, no gaps, as the camera gives it

/// A picture is copied into the window only when somebody has asked within this time.
inline constexpr Nanos kAsked{2'000'000'000};
/// An older picture is not shown: it was left by somebody who looked long ago, or by a process that died.
inline constexpr Nanos kFresh{2'000'000'000};

struct WindowFiles {
  /// The pictures. Written by its maker alone, its group reads: an onlooker can do no harm here.
  std::string pictures;
  /// When somebody asked last: 8 bytes, CLOCK_MONOTONIC in ns. The group writes. Nobody maps it: who cut it short would
  /// kill the camera's process.
  std::string asked;
};

struct Slot {
  alignas(64) std::atomic<std::uint32_t> turn{0};  // odd while it is being written, grows by two with each picture
  alignas(8) std::uint64_t sequence = 0;
  alignas(8) std::int64_t time_ns = 0;  // CLOCK_MONOTONIC
  alignas(64) std::array<std::uint8_t, kPictureBytes> bytes{};
};

/// The writer fills the slots in turn, so that a reader is disturbed only when three more pictures come while it
/// copies. Who dies in the middle leaves an odd turn, and `newest` at the picture before: nobody ever waits.
struct Window {
  static constexpr std::uint32_t kMagic = 0x57504f44;  // "DOPW"
  static constexpr std::uint32_t kLayout = 1;          // count up when a member here changes
  static constexpr std::uint32_t kSlots = 3;

  std::uint32_t magic = kMagic;
  std::uint32_t layout = kLayout;
  std::uint32_t size = sizeof(Window);
  std::atomic<std::uint32_t> other_size{0};  // width << 16 | height of pictures that have no room here; 0: none came
  std::atomic<std::uint32_t> newest{0};      // slot + 1; 0: none yet
  std::array<Slot, kSlots> slots{};
};

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
static_assert(sizeof(Slot) == 64 + kPictureBytes && sizeof(Window) == 64 + 3 * sizeof(Slot), "on every computer");

}  // namespace darwinop::shared_picture
