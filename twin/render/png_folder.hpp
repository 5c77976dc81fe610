// A film as a folder of pictures.
#pragma once

#include <string>

#include "twin/render/film.hpp"

namespace darwinop::twin {

class PngFolder final : public Film {
 public:
  /// Makes the folder. Throws std::runtime_error when it cannot, or when pictures of an earlier film lie in it.
  explicit PngFolder(std::string folder);

  void add(const Picture& picture) override;
  void finish() override {}
  [[nodiscard]] std::string place() const override;

 private:
  std::string folder_;
  int count_ = 0;
};

}  // namespace darwinop::twin
