// Reports each camera message once.
#include "hal/camera_v4l2/reporter.hpp"

namespace darwinop::v4l2 {

void Reporter::report(CameraError kind, const std::string& sentence) {
  const auto bit = [](CameraError error) { return static_cast<std::size_t>(error); };
  if (reported_[bit(kind)]) return;
  reported_.set(bit(kind));
  // Unplugged implies absent.
  if (kind == CameraError::kUnplugged) reported_.set(bit(CameraError::kAbsent));
  send(sentence);
}

void Reporter::back(const std::string& sentence) {
  if (!hasError()) return;
  reported_.reset();
  send(sentence);
}

void Reporter::remark(const std::string& sentence) {
  if (remarks_.insert(sentence).second) send(sentence);
}

void Reporter::mute() {
  const std::lock_guard lock{mutex_};
  log_ = nullptr;
}

void Reporter::send(const std::string& sentence) {
  const std::lock_guard lock{mutex_};
  if (!log_) return;
  try {
    log_(sentence);
  } catch (...) {  // an exception of the receiver must not end the camera's thread
  }
}

}  // namespace darwinop::v4l2
