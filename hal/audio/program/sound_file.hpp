// Sound files through libsndfile: WAV, MP3, FLAC, Ogg and others.
#pragma once

#include <memory>
#include <string>

#include "hal/audio/sound_source.hpp"

namespace darwinop::audio {

// First words of a message, before the file's name: the file cannot be opened, or its content is not supported.
inline constexpr const char* kCannotReadSoundFile = "cannot read sound file ";
inline constexpr const char* kCannotPlaySoundFile = "cannot play sound file ";

/// A file of floating-point samples can exceed full scale: up to 18 dB are kept, for sounds played at low volume. A
/// sample that is not a number is silence: one NaN or infinity would mute every other sound of the mix.
inline constexpr float kLoudestSample = 8;

struct SoundFile {
  std::unique_ptr<SoundSource> source;
  double seconds;  // NaN: unknown
};

/// Opens for streaming. Throws std::runtime_error that names the file and the error.
SoundFile openSoundFile(const std::string& file);

}  // namespace darwinop::audio
