// A request as bytes, as the simulator's clients write it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "remote/protocol/request.hpp"

namespace darwinop::remote {

using RequestBuffer = std::array<std::uint8_t, kLongestRequest>;

/// The part of `buffer` that holds the request.
[[nodiscard]] std::span<const std::uint8_t> writeRequest(const Request& request, RequestBuffer& buffer);

}  // namespace darwinop::remote
