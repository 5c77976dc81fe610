// What a virtual camera and whoever paints its pictures share: one file, mapped by both.
//
// The painter (darwinop-virtual-camera, darwinop-virtual-robot) makes it and fills one picture after the other; the
// shim in the process that opens /dev/videoN reads them, and writes the size that it negotiated. Each side tolerates
// that the other is gone.
#pragma once

#include <time.h>

#include <atomic>
#include <cstdint>

namespace darwinop::hil {

inline constexpr std::uint32_t kFrameFileMagic = 0x4d415643;  // "CVAM"
inline constexpr std::uint32_t kFrameFileVersion = 3;
inline constexpr int kMostWidth = 800, kMostHeight = 600;  // the largest size of the robot's camera
inline constexpr std::uint32_t kMostBytes = 2u * kMostWidth * kMostHeight;

/// What is wrong with the camera from now on; set by a test, seen by the shim at the next frame.
enum class CameraFault : std::uint32_t {
  kNone,
  kGone,         // unplugged: ENODEV on every call, open() finds no file
  kSilent,       // no frames
  kShort,        // frames with half of their bytes
  kFlagged,      // frames that the driver marks V4L2_BUF_FLAG_ERROR
  kIoError,      // VIDIOC_DQBUF fails with EIO
  kSlow,         // five frames a second
  kBusy,         // VIDIOC_STREAMON and S_FMT fail with EBUSY
  kNoAccess,     // open() fails with EACCES
  kOtherFormat,  // the driver gives MJPEG instead of YUYV
  kOneBuffer,    // the driver grants a single buffer
  kNoMmap,       // the driver does no streaming
  kDrops,        // every third frame is lost, and counted
};

/// Lies at the start of the file. Two pictures follow (YUYV, rows of 2 * width bytes, as a camera mounted upside down
/// sends them): the painter fills one while the shim reads the other, so that neither waits, and a painter that died
/// amid its work leaves a whole picture. Picture number n, counted from 1, lies at pictureAt(n).
struct FrameFile {
  std::uint32_t magic = kFrameFileMagic, version = kFrameFileVersion;
  std::atomic<std::uint32_t> fault{0};                               // CameraFault
  std::atomic<std::uint32_t> wanted_width{320}, wanted_height{240};  // written by the shim
  std::atomic<std::uint32_t> pictures{0};  // complete ones; unchanged after reading: what was read is whole
  std::atomic<std::uint32_t> width[2] = {}, height[2] = {};  // of picture n: at [n % 2]; not always what is wanted
  std::atomic<std::int64_t> painted_ns[2] = {};              // CLOCK_MONOTONIC
  std::atomic<std::int64_t> glanced_ns{0};  // as asked_ns, by who is content with half as many pictures
  std::atomic<std::int64_t> asked_ns{0};  // CLOCK_MONOTONIC; written by whoever looks: nobody looks, nobody need paint
  std::atomic<std::uint32_t> blind{0};    // 1: nothing can be painted, and `why` says why; set once, behind it
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
