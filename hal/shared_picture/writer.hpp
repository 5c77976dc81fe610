// Shows the camera's pictures to other processes while somebody looks.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "hal/byte_line.hpp"
#include "hal/guarded_mapping.hpp"
#include "hal/pixels/yuyv_image.hpp"
#include "hal/shared_picture/layout.hpp"

namespace darwinop::shared_picture {

/// One process, one camera's thread. Never waits for a reader.
class Writer {
 public:
  /// Makes both files anew for `group`; what a process that died left behind is replaced. Throws std::runtime_error,
  /// with what to do: no rights, no space.
  Writer(WindowFiles files, gid_t group);
  /// Removes its files.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// True: it was copied. Nobody asked within kAsked, or it is not of 320x240: nothing was. No lock, no allocation.
  /// `image` is whole, `now` and `time` are CLOCK_MONOTONIC.
  bool put(const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time, Nanos now) noexcept;

 private:
  [[nodiscard]] bool asked(Nanos now) const noexcept;
  void removeOwn() noexcept;

  WindowFiles files_;
  int pictures_ = -1, asked_ = -1;
  GuardedMapping memory_;  // who shortens the file must not end the process of the camera, nor a loop in it
  Window* window_ = nullptr;
  std::uint32_t next_ = 0;
};

}  // namespace darwinop::shared_picture
