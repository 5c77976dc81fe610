// Pictures of a camera in real time: a thread of its own encodes each new frame once, whoever asks or not.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"
#include "remote/picture_source.hpp"

namespace darwinop::remote {

/// newest() is wait-free and takes no part in the encoding. Lives as long as there is a client: the thread works at the
/// camera's pace, 30 pictures a second.
class LivePictures final : public PictureSource {
 public:
  struct Options {
    ImageSize size = kWholeImage;
    int quality = qualityOf(kWholeImage);
    /// The clock of the frames' time.
    std::function<Nanos()> now;
    /// Told a sentence, once, when the camera's frames are not of kWholeImage: then all is black. From the thread.
    std::function<void(const std::string&)> say;
    /// Shown each new frame of that size before its picture is; from the thread. It must not throw.
    std::function<void(const CameraFrame&)> look_at = {};
    /// How often the camera is looked at, which never waits: a picture is half of it older on average.
    Nanos look_every = std::chrono::milliseconds{4};
  };

  /// `camera` is used by the thread from now on; one that gives YUYV spares a way through BGRA. Throws
  /// std::invalid_argument: options without sense; std::system_error: no threads left.
  LivePictures(std::unique_ptr<FrameSource> camera, Options options);
  /// Waits for a picture that is being encoded: some milliseconds.
  ~LivePictures() override;
  LivePictures(const LivePictures&) = delete;
  LivePictures& operator=(const LivePictures&) = delete;

  JpegPicture newest() override;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace darwinop::remote
