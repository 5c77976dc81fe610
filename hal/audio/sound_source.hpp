// Something that gives samples: a file, a voice.
#pragma once

#include <cstddef>
#include <span>

namespace darwinop::audio {

/// Left and right, 1 is full scale.
struct Frame {
  float left = 0, right = 0;
};

class SoundSource {
 public:
  virtual ~SoundSource() = default;
  /// Frames a second; does not change.
  [[nodiscard]] virtual int rate() const = 0;
  /// How many it gave. None is the end, or nothing yet.
  virtual std::size_t read(std::span<Frame> frames) = 0;
  [[nodiscard]] virtual bool ended() const = 0;
  /// Back to its beginning; false: it cannot.
  virtual bool rewind() = 0;
};

}  // namespace darwinop::audio
