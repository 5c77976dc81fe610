// Says things once.
#include "hal/camera_v4l2/voice.hpp"

namespace darwinop::v4l2 {

void Voice::trouble(Trouble kind, const std::string& sentence) {
  const auto bit = [](Trouble trouble) { return static_cast<std::size_t>(trouble); };
  if (told_[bit(kind)]) return;
  told_.set(bit(kind));
  // A camera that went away is not there: that was told.
  if (kind == Trouble::kUnplugged) told_.set(bit(Trouble::kAbsent));
  tell(sentence);
}

void Voice::back(const std::string& sentence) {
  if (!troubled()) return;
  told_.reset();
  tell(sentence);
}

void Voice::remark(const std::string& sentence) {
  if (remarks_.insert(sentence).second) tell(sentence);
}

void Voice::mute() {
  const std::lock_guard lock{mutex_};
  say_ = nullptr;
}

void Voice::tell(const std::string& sentence) {
  const std::lock_guard lock{mutex_};
  if (!say_) return;
  try {
    say_(sentence);
  } catch (...) {  // whoever listens must not end the camera's thread
  }
}

}  // namespace darwinop::v4l2
