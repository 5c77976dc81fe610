// Recording as a folder of PNG files.
#pragma once

#include <string>

#include "twin/render/film.hpp"

namespace darwinop::twin {

class PngFolder final : public Film {
 public:
  /// Creates the folder. Throws std::runtime_error on failure, or if it contains pictures of an earlier recording.
  explicit PngFolder(std::string folder);

  void add(const RenderedPicture& picture) override;
  void finish() override {}
  [[nodiscard]] std::string place() const override;

 private:
  std::string folder_;
  int count_ = 0;
};

}  // namespace darwinop::twin
