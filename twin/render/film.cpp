// Selects the recording format by the file name.
#include "twin/render/film.hpp"

#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "hal/process/start.hpp"
#include "twin/render/ffmpeg.hpp"
#include "twin/render/png_folder.hpp"

namespace darwinop::twin {

std::unique_ptr<Film> makeFilm(const std::string& path, int width, int height, int per_second, std::string& note) {
  const std::filesystem::path name{path};
  for (const char* other : {".avi", ".mov", ".webm", ".gif", ".png", ".jpg"})
    if (name.extension() == other)
      throw std::runtime_error("cannot write a film to '" + path + "': give a file name.mp4 or .mkv, or a folder for " +
                               "pictures");
  if (name.extension() != ".mp4" && name.extension() != ".mkv") return std::make_unique<PngFolder>(path);
  if (width % 2 != 0 || height % 2 != 0)
    throw std::runtime_error("cannot encode a video of " + std::to_string(width) + "x" + std::to_string(height) +
                             ": width and height must be even (a folder of pictures accepts any size)");
  const std::string ffmpeg = process::findProgram("ffmpeg");
  if (!ffmpeg.empty()) {
    std::signal(SIGPIPE, SIG_IGN);  // write() returns EPIPE if ffmpeg ends early
    return std::make_unique<Ffmpeg>(ffmpeg, path, width, height, per_second);
  }
  const std::string folder = (name.parent_path() / name.stem()).string();
  note = "ffmpeg is not installed (apt-get install ffmpeg); pictures are written to the folder " + folder +
         "; convert them with ffmpeg -framerate " + std::to_string(per_second) + " -i " + folder + "/frame_%05d.png " +
         path;
  return std::make_unique<PngFolder>(folder);
}

}  // namespace darwinop::twin
