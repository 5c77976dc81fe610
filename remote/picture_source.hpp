// Where a reply takes its picture from.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hal/byte_line.hpp"

namespace darwinop::remote {

struct JpegPicture {
  /// Of the frame it was made of: the same number, the same picture. 0: there is none, or the camera has been blind for
  /// 2 s; `jpeg` is black then.
  std::uint64_t sequence = 0;
  Nanos age{0};  // since the camera took it; 0 with sequence 0
  /// A whole file of the size that was agreed on, whatever the sequence.
  std::span<const std::uint8_t> jpeg;
};

/// Used by one thread.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// The newest one. Its bytes stay as they are until the next call.
  virtual JpegPicture newest() = 0;
  /// Why there will be none, when that is known; else empty.
  [[nodiscard]] virtual std::string trouble() const { return {}; }
};

}  // namespace darwinop::remote
