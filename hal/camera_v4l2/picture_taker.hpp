// Takes filled buffers from the driver, shows the newest complete picture and queues the buffers again.
#pragma once

#include "hal/camera_v4l2/buffers.hpp"
#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/error_burst.hpp"
#include "hal/camera_v4l2/frame_count.hpp"
#include "hal/camera_v4l2/picture.hpp"
#include "hal/pixels/yuyv_image.hpp"
#include "hal/triple_buffer.hpp"

namespace darwinop::v4l2 {

/// The picture is rotated and converted to BGRA, or copied unchanged where `pictures` hold YUYV.
///
/// Each picture of the camera is counted once: a complete one in `frames` (even if a newer one replaced it at once), a
/// broken one in `damaged`, one that the driver never delivered in `dropped`.
class PictureTaker {
 public:
  struct Outcome {
    int error = 0;       // errno: streaming has failed
    bool shown = false;  // there is a new picture
    bool idle = false;   // nothing was ready
  };

  /// All references must outlive it.
  PictureTaker(StreamBuffers& buffers, const PictureShape& shape, TripleBuffer<Picture>& pictures, FrameCount& count,
               Counters& counters, const RawFrameTaker& on_raw_frame)
      : buffers_{buffers},
        shape_{shape},
        pictures_{pictures},
        count_{count},
        counters_{counters},
        on_raw_frame_{on_raw_frame} {}

  /// Never blocks or allocates.
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
