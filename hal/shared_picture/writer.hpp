// Publishes the camera's pictures to other processes on request.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "hal/byte_line.hpp"
#include "hal/guarded_mapping.hpp"
#include "hal/pixels/yuyv_image.hpp"
#include "hal/shared_picture/layout.hpp"

namespace darwinop::shared_picture {

/// Camera's thread of one process. Never waits for a reader.
class Writer {
 public:
  /// Creates both files for `group`, replacing those of a dead process. Throws std::runtime_error with a remedy if
  /// there is no permission or space.
  Writer(WindowFiles files, gid_t group);
  /// Removes its files.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Returns true if the picture was copied; false without a request within kAsked, or if it is not 320x240. No lock,
  /// no allocation. `image` is whole; `now` and `time` are CLOCK_MONOTONIC.
  bool put(const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time, Nanos now) noexcept;

 private:
  [[nodiscard]] bool asked(Nanos now) const noexcept;
  void removeOwn() noexcept;

  WindowFiles files_;
  int pictures_ = -1, asked_ = -1;
  GuardedMapping memory_;  // truncation by another process must not end this one
  SharedWindow* window_ = nullptr;
  std::uint32_t next_ = 0;
};

}  // namespace darwinop::shared_picture
