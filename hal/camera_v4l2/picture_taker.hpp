// Takes what a device has ready, shows the newest whole picture, and gives the buffers back.
#pragma once

#include "hal/camera_v4l2/buffers.hpp"
#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/error_burst.hpp"
#include "hal/camera_v4l2/frame_count.hpp"
#include "hal/camera_v4l2/picture.hpp"
#include "hal/pixels/yuyv_image.hpp"
#include "hal/triple_buffer.hpp"

namespace darwinop::v4l2 {

/// A picture is turned and made BGRA, or copied as it is where `pictures` have room for YUYV.
///
/// Every picture that a camera counts is counted once: a whole one as `frames`, even when a newer one was ready by then
/// and it is not shown; a broken one as `damaged`; one that the driver never handed over as `dropped`.
class PictureTaker {
 public:
  struct Outcome {
    int error = 0;       // errno: this stream is over
    bool shown = false;  // there is a new picture
    bool idle = false;   // nothing was ready
  };

  /// All must outlive it.
  PictureTaker(StreamBuffers& buffers, const PictureShape& shape, TripleBuffer<Picture>& pictures, FrameCount& count,
               Counters& counters, const RawFrameTaker& on_raw_frame)
      : buffers_{buffers},
        shape_{shape},
        pictures_{pictures},
        count_{count},
        counters_{counters},
        on_raw_frame_{on_raw_frame} {}

  /// Never waits, never allocates.
  Outcome takeAll() noexcept;

 private:
  struct Numbered {
    Filled filled;
    std::uint64_t sequence = 0;
  };
  Numbered number(const Filled& filled) noexcept;
  int readError(int error) noexcept;
  void show(const Numbered& newest) noexcept;
  [[nodiscard]] pixels::YuyvImage imageOf(const Filled& filled) const noexcept;

  StreamBuffers& buffers_;
  PictureShape shape_;
  TripleBuffer<Picture>& pictures_;
  FrameCount& count_;
  Counters& counters_;
  const RawFrameTaker& on_raw_frame_;
  ErrorBurst errors_;
};

}  // namespace darwinop::v4l2
