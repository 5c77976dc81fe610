// Opens and closes the camera for observers.
#include "monitor/camera_source.hpp"

#include <stdexcept>

namespace darwinop::monitor {

void CameraSource::update(bool wanted, bool free, Nanos now) {
  if (!wanted || free != free_) {
    pictures_.reset();
    next_try_ = Nanos{0};
    why_ = kNotRequested;
  }
  free_ = free;
  if (!wanted || pictures_ || now < next_try_) return;
  next_try_ = now + kAgain;
  why_ = free ? "this robot has no camera" : kControllerDrives;
  const Open& open = free ? open_ : share_;
  if (!open) return;
  try {
    pictures_ = open();
    why_.clear();
  } catch (const std::runtime_error& error) {
    why_ = error.what();
  }
}

remote::JpegPicture CameraSource::newest() {
  return pictures_ ? pictures_->newest() : remote::JpegPicture{};
}

}  // namespace darwinop::monitor
