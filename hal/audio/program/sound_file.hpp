// A sound file as a source: WAV, MP3, FLAC, Ogg, whatever libsndfile reads.
#pragma once

#include <memory>
#include <string>

#include "hal/audio/sound_source.hpp"

namespace darwinop::audio {

struct SoundFile {
  std::unique_ptr<SoundSource> source;
  double seconds;  // NaN: the file does not tell
};

/// Reads as it plays, not before. Throws std::runtime_error that says what is wrong with which file.
SoundFile openSoundFile(const std::string& file);

}  // namespace darwinop::audio
