// Memory-mapped V4L2 streaming: dequeues filled buffers and queues them again.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hal/camera_v4l2/device.hpp"

namespace darwinop::v4l2 {

/// A dequeued buffer.
struct Filled {
  int error = 0;  // errno; EAGAIN: none is ready
  std::uint32_t index = 0;
  std::uint32_t sequence = 0;
  bool marked_bad = false;
  std::chrono::nanoseconds time{0};     // CLOCK_MONOTONIC
  std::span<const std::uint8_t> bytes;  // length as reported by the driver
};

/// Streams from construction to destruction.
class StreamBuffers {
 public:
  static constexpr std::uint32_t kAsked = 4, kNeeded = 2;
  /// Details of CameraError::kFewBuffers.
  static constexpr const char *kNoBuffer = "no buffer", *kOneBuffer = "a single buffer";

  /// Throws CameraRefused. `device` must outlive it.
  explicit StreamBuffers(const V4l2Device& device);
  ~StreamBuffers();
  StreamBuffers(const StreamBuffers&) = delete;
  StreamBuffers& operator=(const StreamBuffers&) = delete;

  [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(mapped_.size()); }
  /// The oldest picture that is ready. Never blocks.
  [[nodiscard]] Filled take() noexcept;
  /// 0, or the errno.
  int giveBack(std::uint32_t index) noexcept;
  /// Linux 2.6.31 reports a damaged picture as EIO and keeps its buffer without naming it: queues every idle buffer
  /// again. The caller must hold none. Returns 0 or the errno.
  int giveBackStrays() noexcept;

 private:
  void map();
  void release() noexcept;

  const V4l2Device& device_;
  std::vector<std::span<std::uint8_t>> mapped_;
};

}  // namespace darwinop::v4l2
