// One sound of the mix: resampling, volume, pitch and balance.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "hal/audio/sound_source.hpp"

namespace darwinop::audio {

struct TrackSetting {
  double volume = 1;   // 0 to 1
  double pitch = 1;    // 0.5 to 2
  double balance = 0;  // -1: left only, 1: right only
  bool loop = false;
};

class Track {
 public:
  Track(std::unique_ptr<SoundSource> source, int mix_rate);

  void set(const TrackSetting& setting) { setting_ = setting; }
  /// Adds the next block to `mix`. Returns false at the end. A source without data yet leaves a gap.
  [[nodiscard]] bool addTo(std::span<AudioFrame> mix);

 private:
  enum class Next { kFrame, kNothingYet, kOver };
  Next advance();

  std::unique_ptr<SoundSource> source_;
  double frames_a_mix_frame_;  // source frames per mix frame at pitch 1
  TrackSetting setting_;
  std::array<AudioFrame, 512> chunk_{};
  std::size_t used_ = 0, filled_ = 0;
  AudioFrame here_{}, next_{};  // the output interpolates between these
  double at_ = 2;               // 0: here_, 1: next_; 2: read both first
};

}  // namespace darwinop::audio
