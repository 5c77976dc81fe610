// Real-time camera pictures: a thread encodes each new frame once.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"
#include "remote/picture_source.hpp"

namespace darwinop::remote {

/// newest() is wait-free. The thread encodes at the camera's rate, 30 pictures a second, so create this only while
/// there is a client.
class LivePictures final : public PictureSource {
 public:
  struct Options {
    ImageSize size = kWholeImage;
    int quality = qualityOf(kWholeImage);
    /// Clock of the frame timestamps.
    std::function<Nanos()> now;
    /// Called once from the thread if the frames do not have the size kWholeImage; all pictures are black then.
    std::function<void(const std::string&)> log;
    /// Called from the thread with each new frame before its picture is published. Must not throw.
    std::function<void(const CameraFrame&)> on_frame = {};
    /// Polling interval of the camera; adds half of it to a picture's age on average.
    Nanos poll_interval = std::chrono::milliseconds{4};
  };

  /// `camera` is used by the thread from now on; YUYV frames avoid a conversion from BGRA. Throws std::invalid_argument
  /// for
  /// invalid options and std::system_error if the thread cannot be started.
  LivePictures(std::unique_ptr<FrameSource> camera, Options options);
  /// Waits for the picture being encoded: some milliseconds.
  ~LivePictures() override;
  LivePictures(const LivePictures&) = delete;
  LivePictures& operator=(const LivePictures&) = delete;

  JpegPicture newest() override;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace darwinop::remote
