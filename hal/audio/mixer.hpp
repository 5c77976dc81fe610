// All that sounds at one time, added up.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hal/audio/track.hpp"
#include "hal/sound_output.hpp"

namespace darwinop::audio {

inline constexpr int kMixRate = 44100;          // Hz: that of most sound files
inline constexpr std::size_t kMostSounds = 32;  // at once: one more is refused

/// One frame as a sound card takes it.
struct Sample {
  std::int16_t left = 0, right = 0;
};

/// Used by one thread, or under one lock.
class Mixer {
 public:
  /// A file that sounds already and may go on gets the new name and values; true: nothing has to be opened.
  [[nodiscard]] bool change(const PlaySound& play);
  /// False: there are too many.
  [[nodiscard]] bool play(const PlaySound& play, std::unique_ptr<SoundSource> source);
  /// Instead of what is spoken now.
  void speak(const Speak& speak, std::unique_ptr<SoundSource> voice);
  void stop(const StopSound& stop);

  /// The next piece; what does not fit is cut off at full scale.
  void mix(std::span<Sample> out);
  [[nodiscard]] bool silent() const { return sounds_.empty(); }
  /// Neither sounds nor names to take.
  [[nodiscard]] bool idle() const { return sounds_.empty() && ended_.empty(); }
  /// Names of the sounds that ended since the last call.
  [[nodiscard]] std::vector<SoundId> takeEnded();

 private:
  struct Sound {
    SoundId id;
    std::string file;  // empty: speech
    bool afresh;
    Track track;
  };
  template <class Condition>
  void end(Condition which);

  std::list<Sound> sounds_;
  std::vector<SoundId> ended_;
  std::vector<Frame> sum_;
};

}  // namespace darwinop::audio
