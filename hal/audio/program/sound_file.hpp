// Sound files through libsndfile: WAV, MP3, FLAC, Ogg and others.
#pragma once

#include <memory>
#include <string>

#include "hal/audio/sound_source.hpp"

namespace darwinop::audio {

struct SoundFile {
  std::unique_ptr<SoundSource> source;
  double seconds;  // NaN: unknown
};

/// Opens for streaming. Throws std::runtime_error that names the file and the error.
SoundFile openSoundFile(const std::string& file);

}  // namespace darwinop::audio
