// Pictures of a simulated camera: encoded without a thread while simulated time stands still, so runs are repeatable.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "hal/frame_source.hpp"
#include "remote/jpeg/encoder.hpp"
#include "remote/picture_source.hpp"

namespace darwinop::remote {

class LockstepPictures final : public PictureSource {
 public:
  /// `now`: simulated time, the clock of the frame timestamps. Throws std::invalid_argument: see JpegEncoder.
  LockstepPictures(std::unique_ptr<FrameSource> camera, ImageSize size, int quality, std::function<Nanos()> now);

  /// Encodes a new frame. Call it between two simulation steps, in the thread that steps.
  JpegPicture newest() override;

 private:
  std::unique_ptr<FrameSource> camera_;
  std::function<Nanos()> now_;
  JpegEncoder encoder_;
  std::vector<std::uint8_t> black_, bytes_;
  std::size_t length_ = 0;
  std::uint64_t encoded_ = 0;
};

}  // namespace darwinop::remote
