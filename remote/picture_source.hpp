// Where the pictures of a reply come from: whoever encodes them does so before they are asked for.
#pragma once

#include <cstdint>
#include <span>

namespace darwinop::remote {

/// A camera picture as JPEG.
struct JpegPicture {
  std::uint64_t sequence = 0;          // 0: there is none yet; grows with each picture
  std::span<const std::uint8_t> jpeg;  // empty: there is none
};

/// Used by one thread.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// The newest picture; the same one again when nothing newer is encoded. Its bytes stay as they are until the next
  /// call. Never waits.
  virtual JpegPicture newest() = 0;
};

}  // namespace darwinop::remote
