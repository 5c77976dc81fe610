// A JPEG that came over the network to what a controller gets.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "remote/jpeg/image_size.hpp"

namespace darwinop::remote {

/// What a file says of its size; nothing when it is no JPEG, or of a size that no client can have.
[[nodiscard]] std::optional<ImageSize> imageSizeOf(std::span<const std::uint8_t> jpeg);

/// `bgra`: 4 * width * height bytes of `expected`; A is 255. Null: it is done. Else what is wrong with the file, a few
/// words; `bgra` may have been written to by then. The bytes are not trusted: nothing is taken from the heap for a
/// picture of another size, and one that is coded in many passes, which could cost any time, is refused.
[[nodiscard]] const char* decodeJpeg(std::span<const std::uint8_t> jpeg, ImageSize expected,
                                     std::span<std::uint8_t> bgra);

}  // namespace darwinop::remote
