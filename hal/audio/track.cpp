// One sound of the mix: resampling, volume, pitch and balance.
#include "hal/audio/track.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::audio {

Track::Track(std::unique_ptr<SoundSource> source, int mix_rate)
    : source_{std::move(source)}, frames_a_mix_frame_{static_cast<double>(source_->rate()) / mix_rate} {}

Track::Next Track::advance() {
  if (used_ == filled_) {
    used_ = 0;
    filled_ = source_->read(chunk_);
    if (filled_ == 0 && !source_->ended()) return Next::kNothingYet;
    // A source without any frame would loop forever.
    if (filled_ == 0 && setting_.loop && source_->rewind()) filled_ = source_->read(chunk_);
    if (filled_ == 0) return Next::kOver;
  }
  here_ = next_;
  next_ = chunk_[used_++];
  return Next::kFrame;
}

bool Track::addTo(std::span<AudioFrame> mix) {
  const double step = frames_a_mix_frame_ * setting_.pitch;
  const auto volume = static_cast<float>(setting_.volume);
  const float left = volume * static_cast<float>(std::min(1.0, 1 - setting_.balance));
  const float right = volume * static_cast<float>(std::min(1.0, 1 + setting_.balance));
  for (AudioFrame& out : mix) {
    for (; at_ >= 1; at_ -= 1) {
      const Next next = advance();
      if (next == Next::kOver) return false;
      if (next == Next::kNothingYet) return true;
    }
    // Linear interpolation: its error is far below the loudspeaker's distortion.
    const auto at = static_cast<float>(at_);
    out.left += left * (here_.left + at * (next_.left - here_.left));
    out.right += right * (here_.right + at * (next_.right - here_.right));
    at_ += step;
  }
  return true;
}

}  // namespace darwinop::audio
