// Runs ffmpeg as a child process and writes raw pictures to its standard input.
#include "twin/render/ffmpeg.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "hal/signals.hpp"

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

std::string findFfmpeg() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders{path == nullptr ? "" : path};
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string program = (folder.empty() ? "." : folder) + "/ffmpeg";
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

Ffmpeg::Ffmpeg(const std::string& program, std::string file, int width, int height, int per_second)
    : file_{std::move(file)} {
  const std::vector<std::string> words = commandLine(program, file_, width, height, per_second);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string{"cannot create a pipe: "} + std::strerror(errno));
  pid_ = fork();
  if (pid_ < 0) {
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error(std::string{"cannot start ffmpeg: "} + std::strerror(errno));
  }
  if (pid_ == 0) {
    setpgid(0, 0);  // Ctrl-C must not end ffmpeg before the video is complete
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    // Not restoreIgnoredSignals(): this code is also part of a shared library that does not contain hal.
    for (const int signal : kIgnoredSignals) std::signal(signal, SIG_DFL);
    dup2(ends[0], STDIN_FILENO);
    execv(program.c_str(), arguments.data());
    _exit(127);
  }
  close(ends[0]);
  pipe_ = ends[1];
}

Ffmpeg::~Ffmpeg() {
  end();
}

void Ffmpeg::add(const Picture& picture) {
  const std::uint8_t* next = picture.rgb.data();
  for (std::size_t left = picture.rgb.size(); left > 0;) {
    const ssize_t written = ::write(pipe_, next, left);
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

int Ffmpeg::end() noexcept {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  if (pid_ <= 0) return 0;
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace darwinop::twin
