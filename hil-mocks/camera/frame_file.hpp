// Shared-memory layout between a virtual camera and its painter: one file, mapped by both.
//
// The painter (darwinop-virtual-camera, darwinop-virtual-robot) creates the file and writes the pictures; the shim in
// the process that opens /dev/videoN reads them and writes the negotiated size. Each side tolerates the absence of the
// other.
#pragma once

#include <time.h>

#include <atomic>
#include <cstdint>

namespace darwinop::hil {

inline constexpr std::uint32_t kFrameFileMagic = 0x4d415643;  // "CVAM"
inline constexpr std::uint32_t kFrameFileVersion = 3;
inline constexpr int kMostWidth = 800, kMostHeight = 600;  // largest size of the robot's camera
inline constexpr std::uint32_t kMostBytes = 2u * kMostWidth * kMostHeight;

/// Camera fault, set by a test; the shim applies it at the next frame.
enum class CameraFault : std::uint32_t {
  kNone,
  kGone,         // unplugged: ENODEV on every call, open() finds no file
  kSilent,       // no pictures
  kShort,        // pictures with half of their bytes
  kFlagged,      // pictures marked V4L2_BUF_FLAG_ERROR
  kIoError,      // VIDIOC_DQBUF fails with EIO
  kSlow,         // five pictures per second
  kBusy,         // VIDIOC_STREAMON and S_FMT fail with EBUSY
  kNoAccess,     // open() fails with EACCES
  kOtherFormat,  // MJPEG instead of YUYV
  kOneBuffer,    // one buffer only
  kNoMmap,       // no streaming
  kDrops,        // every third picture is lost, and counted
};

/// Header of the file. Two pictures follow (YUYV, rows of 2 * width bytes, in the orientation of a camera mounted
/// upside down): the painter writes one while the shim reads the other, so neither waits, and a painter that dies
/// leaves a complete picture. Picture n, counted from 1, is at pictureAt(n).
struct FrameFile {
  std::uint32_t magic = kFrameFileMagic, version = kFrameFileVersion;
  std::atomic<std::uint32_t> fault{0};                               // CameraFault
  std::atomic<std::uint32_t> wanted_width{320}, wanted_height{240};  // written by the shim
  std::atomic<std::uint32_t> pictures{0};  // complete ones; if unchanged after reading, the data read are complete
  std::atomic<std::uint32_t> width[2] = {},
                             height[2] = {};     // of picture n: index n % 2; may differ from the requested size
  std::atomic<std::int64_t> painted_ns[2] = {};  // CLOCK_MONOTONIC
  std::atomic<std::int64_t> glanced_ns{0};       // as asked_ns, for readers that need half the rate
  std::atomic<std::int64_t> asked_ns{0};         // CLOCK_MONOTONIC of the last read; painting stops without readers
  std::atomic<std::uint32_t> blind{0};           // 1: nothing can be painted, reason in `why`; set once, after `why`
  char why[512] = {};
};
inline constexpr std::uint32_t kPictureAt = 4096;
inline constexpr std::uint32_t kFrameFileSize = kPictureAt + 2 * kMostBytes;
constexpr std::uint32_t pictureAt(std::uint32_t number) {
  return kPictureAt + number % 2 * kMostBytes;
}
/// CLOCK_MONOTONIC, ns.
inline std::int64_t frameFileClock() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}
static_assert(sizeof(FrameFile) <= kPictureAt && std::atomic<std::uint32_t>::is_always_lock_free);

}  // namespace darwinop::hil
