// Runs ffmpeg as a child process and writes raw pictures to its standard input.
#include "twin/render/ffmpeg.hpp"

#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <vector>

namespace darwinop::twin {
namespace {

std::vector<std::string> commandLine(const std::string& program, const std::string& file, int width, int height,
                                     int per_second) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  return {program, "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24",
          "-video_size", size, "-framerate", std::to_string(per_second), "-i", "pipe:0", "-an", "-c:v", "libx264",
          "-preset", "veryfast", "-crf", "20", "-pix_fmt", "yuv420p",
          // The prefix makes ffmpeg accept names that begin with a dash or look like a protocol.
          "file:" + file};
}

}  // namespace

Ffmpeg::Ffmpeg(const std::string& program, std::string file, int width, int height, int per_second)
    : file_{std::move(file)},
      process_{{.command = commandLine(program, file_, width, height, per_second),
                .streams = {process::Stream::pipe()},
                .group = process::Start::Group::kItsOwn,  // Ctrl-C must not end it before the video is complete
                .keeps_ignored_signals = true}} {}

Ffmpeg::~Ffmpeg() {
  end();
}

void Ffmpeg::add(const RenderedPicture& picture) {
  const std::uint8_t* next = picture.rgb.data();
  for (std::size_t left = picture.rgb.size(); left > 0;) {
    const ssize_t written = ::write(process_.stream(STDIN_FILENO), next, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw std::runtime_error("ffmpeg ended before the video was complete; see its output above. File: " + file_);
    next += written;
    left -= static_cast<std::size_t>(written);
  }
}

void Ffmpeg::finish() {
  const int status = end();
  if (status != 0)
    throw std::runtime_error("ffmpeg could not complete " + file_ + " (exit status " + std::to_string(status) + ")");
}

int Ffmpeg::end() {
  process_.closeStream(STDIN_FILENO);
  return process_.wait().shellStatus();
}

}  // namespace darwinop::twin
