// Mixes all active sounds into one stereo stream.
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

inline constexpr int kMixRate = 44100;          // Hz; the rate of most sound files
inline constexpr std::size_t kMostSounds = 32;  // at once; a further one is rejected

/// One sample pair in the format of the sound card.
struct Sample {
  std::int16_t left = 0, right = 0;
};

/// Used by one thread, or under one lock.
class Mixer {
 public:
  /// If `file` is already playing and must not restart, gives it the new id and parameters and returns true; the file
  /// need not be opened again.
  [[nodiscard]] bool change(const PlaySound& play);
  /// Returns false if kMostSounds are active.
  [[nodiscard]] bool play(const PlaySound& play, std::unique_ptr<SoundSource> source);
  /// Replaces the current speech.
  void speak(const Speak& speak, std::unique_ptr<SoundSource> voice);
  void stop(const StopSound& stop);

  /// Writes the next block; clips at full scale.
  void mix(std::span<Sample> out);
  [[nodiscard]] bool silent() const { return sounds_.empty(); }
  /// No sounds, and no ended ids to fetch.
  [[nodiscard]] bool idle() const { return sounds_.empty() && ended_.empty(); }
  /// Ids of the sounds that ended since the last call.
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
  std::vector<AudioFrame> sum_;
};

}  // namespace darwinop::audio
