// Encodes pictures of a simulated camera between simulation steps.
#include "remote/jpeg/lockstep_pictures.hpp"

#include <utility>

#include "remote/jpeg/black_image.hpp"

namespace darwinop::remote {

LockstepPictures::LockstepPictures(std::unique_ptr<FrameSource> camera, ImageSize size, int quality,
                                   std::function<Nanos()> now)
    : camera_{std::move(camera)},
      now_{std::move(now)},
      encoder_{size, quality},
      black_{blackImage(encoder_)},
      bytes_(encoder_.mostBytes()) {}

JpegPicture LockstepPictures::newest() {
  const CameraFrame frame = camera_->newest();
  if (frame.sequence != std::exchange(encoded_, frame.sequence)) length_ = encoder_.encode(frame, bytes_);
  if (frame.sequence == 0 || length_ == 0 || !camera_->health().seeing) return {0, Nanos{0}, black_};
  return {frame.sequence, now_() - frame.time, std::span{bytes_}.first(length_)};
}

}  // namespace darwinop::remote
