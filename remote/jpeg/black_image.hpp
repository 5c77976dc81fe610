// What is sent while there is nothing to see: old programs expect a picture in every reply.
#pragma once

#include <cstdint>
#include <vector>

#include "remote/jpeg/encoder.hpp"

namespace darwinop::remote {

[[nodiscard]] std::vector<std::uint8_t> blackImage(JpegEncoder& encoder);

}  // namespace darwinop::remote
