// Recording of pictures: a video encoded by ffmpeg, or a folder of PNG files.
#pragma once

#include <memory>
#include <string>

#include "twin/render/picture.hpp"

namespace darwinop::twin {

class Film {
 public:
  virtual ~Film() = default;
  /// Throws std::runtime_error on a write error.
  virtual void add(const RenderedPicture& picture) = 0;
  /// After the last picture. Throws std::runtime_error if the film is incomplete.
  virtual void finish() = 0;
  /// Output path for messages, e.g. "film.mp4".
  [[nodiscard]] virtual std::string place() const = 0;
};

/// `path` ending in ".mp4" or ".mkv": a video if ffmpeg is installed. Otherwise, and for any other path, a folder with
/// frame_00001.png and so on. `note`: message for the user if the format differs from the requested one. Throws
/// std::runtime_error for an odd size of a video and for a folder that already contains such pictures.
std::unique_ptr<Film> makeFilm(const std::string& path, int width, int height, int per_second, std::string& note);

}  // namespace darwinop::twin
