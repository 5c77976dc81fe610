#include "remote/monitor/eye.hpp"

#include <stdexcept>

namespace darwinop::monitor {

void Eye::look(bool wanted, bool free, Nanos now) {
  if (!wanted || !free) {
    pictures_.reset();
    next_try_ = Nanos{0};
    why_ = wanted ? "a controller drives, and the camera is left to it" : "nobody has asked for pictures";
    return;
  }
  if (pictures_ || now < next_try_) return;
  next_try_ = now + kAgain;
  why_ = "this robot has no camera";
  if (!open_) return;
  try {
    pictures_ = open_();
    why_.clear();
  } catch (const std::runtime_error& error) {
    why_ = error.what();
  }
}

remote::JpegPicture Eye::newest() {
  return pictures_ ? pictures_->newest() : remote::JpegPicture{};
}

}  // namespace darwinop::monitor
