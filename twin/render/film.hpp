// Pictures one after the other: an MP4 made by ffmpeg, or a folder of PNG files.
#pragma once

#include <memory>
#include <string>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

class Film {
 public:
  virtual ~Film() = default;
  /// Throws std::runtime_error when it cannot be written.
  virtual void add(const Picture& picture) = 0;
  /// After the last picture. Throws std::runtime_error when the film is not whole.
  virtual void finish() = 0;
  /// What to tell the user about where it is; "film.mp4".
  [[nodiscard]] virtual std::string place() const = 0;
};

/// `path` ending in ".mp4" or ".mkv": a video when ffmpeg is there. Without it, and for any other path, a folder with
/// frame_00001.png and so on. `note` gets a sentence when it became something else than was asked for. Throws
/// std::runtime_error: odd size of a video, a folder that already holds such pictures.
std::unique_ptr<Film> makeFilm(const std::string& path, int width, int height, int per_second, std::string& note);

}  // namespace darwinop::twin
