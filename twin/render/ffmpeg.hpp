// Video encoder: pipes pictures to ffmpeg.
#pragma once

#include <string>

#include "hal/process/child_process.hpp"
#include "twin/render/film.hpp"

namespace darwinop::twin {

class Ffmpeg final : public Film {
 public:
  /// Starts ffmpeg; an existing file is overwritten. Throws std::runtime_error.
  Ffmpeg(const std::string& program, std::string file, int width, int height, int per_second);
  /// Closes the pipe and waits for ffmpeg.
  ~Ffmpeg() override;
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;

  void add(const RenderedPicture& picture) override;
  void finish() override;
  [[nodiscard]] std::string place() const override { return file_; }

 private:
  int end();  // returns the exit status

  std::string file_;
  process::ChildProcess process_;
};

}  // namespace darwinop::twin
