// One sound in the mix: brought to the mix's rate, at its volume, pitch and balance.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "hal/audio/sound_source.hpp"

namespace darwinop::audio {

struct Setting {
  double volume = 1;   // 0 to 1
  double pitch = 1;    // 0.5 to 2
  double balance = 0;  // -1: left only, 1: right only
  bool loop = false;
};

class Track {
 public:
  Track(std::unique_ptr<SoundSource> source, int mix_rate);

  void set(const Setting& setting) { setting_ = setting; }
  /// Adds the next piece to `mix`. False: it is over. A source that has nothing yet leaves a gap.
  [[nodiscard]] bool addTo(std::span<Frame> mix);

 private:
  enum class Next { kFrame, kNothingYet, kOver };
  Next advance();

  std::unique_ptr<SoundSource> source_;
  double frames_a_mix_frame_;  // at pitch 1
  Setting setting_;
  std::array<Frame, 512> chunk_{};
  std::size_t used_ = 0, filled_ = 0;
  Frame here_{}, next_{};  // between them lies what is heard
  double at_ = 2;          // 0: here_, 1: next_; 2: both have to be read first
};

}  // namespace darwinop::audio
