// Interface of a sample source: a sound file or speech.
#pragma once

#include <cstddef>
#include <span>

namespace darwinop::audio {

/// Left and right; 1 is full scale.
struct AudioFrame {
  float left = 0, right = 0;
};

class SoundSource {
 public:
  virtual ~SoundSource() = default;
  /// Frames per second; constant.
  [[nodiscard]] virtual int rate() const = 0;
  /// Returns the number of frames read; 0: the end, or none yet.
  virtual std::size_t read(std::span<AudioFrame> frames) = 0;
  [[nodiscard]] virtual bool ended() const = 0;
  /// Restarts from the beginning; false: not possible.
  virtual bool rewind() = 0;
};

}  // namespace darwinop::audio
