// Interface of a source of JPEG pictures.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::remote {

struct JpegPicture {
  /// Sequence number of the frame. 0: no picture, or the camera has given no frame for 2 s; `jpeg` is black then.
  std::uint64_t sequence = 0;
  Nanos age{0};  // since capture; 0 with sequence 0
  /// A complete file of the configured size, also with sequence 0.
  std::span<const std::uint8_t> jpeg;
};

/// Not thread-safe.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// The newest picture. Its bytes are valid until the next call.
  virtual JpegPicture newest() = 0;
  /// Why there are no pictures, if known; otherwise empty.
  [[nodiscard]] virtual std::string error() const { return {}; }
};

}  // namespace darwinop::remote
