// webots::Motion: player of .motion files.
#include "webots/utils/Motion.hpp"

#include "webots/motion_playback.hpp"

namespace webots {

Motion::Motion(const std::string& file_name) : playback_(new darwinop::webots_api::MotionPlayback{file_name}) {}

Motion::~Motion() {
  delete playback_;
}

bool Motion::isValid() const {
  return playback_->isValid();
}
void Motion::play() {
  playback_->play();
}
void Motion::stop() {
  playback_->stop();
}
void Motion::setLoop(bool loop) {
  playback_->setLoop(loop);
}
void Motion::setReverse(bool reverse) {
  playback_->setReverse(reverse);
}
void Motion::setTime(int time) {
  playback_->setTime(std::chrono::milliseconds{time});
}

int Motion::getDuration() const {
  return static_cast<int>((playback_->duration() + playback_->leadInLeft()).count());
}
int Motion::getTime() const {
  return static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(playback_->time()).count());
}
bool Motion::isOver() const {
  return playback_->isOver();
}

}  // namespace webots
