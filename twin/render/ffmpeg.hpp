// A film that ffmpeg writes: pictures go to it through a pipe.
#pragma once

#include <sys/types.h>

#include <string>

#include "twin/render/film.hpp"

namespace darwinop::twin {

/// The program in PATH; empty: not installed.
std::string findFfmpeg();

class Ffmpeg final : public Film {
 public:
  /// Throws std::runtime_error. An existing file is replaced.
  Ffmpeg(const std::string& program, std::string file, int width, int height, int per_second);
  /// Ends it, whole or not.
  ~Ffmpeg() override;
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;

  void add(const Picture& picture) override;
  void finish() override;
  [[nodiscard]] std::string place() const override { return file_; }

 private:
  int end() noexcept;  // its exit status

  std::string file_;
  int pipe_ = -1;
  pid_t pid_ = 0;
};

}  // namespace darwinop::twin
