// Black JPEG, sent while there is no picture: clients of 2013 expect one in every reply.
#pragma once

#include <cstdint>
#include <vector>

#include "remote/jpeg/encoder.hpp"

namespace darwinop::remote {

[[nodiscard]] std::vector<std::uint8_t> blackImage(JpegEncoder& encoder);

}  // namespace darwinop::remote
