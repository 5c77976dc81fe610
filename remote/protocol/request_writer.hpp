// Serializes requests byte for byte as the simulator's clients do.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "remote/protocol/request.hpp"

namespace darwinop::remote {

using RequestBuffer = std::array<std::uint8_t, kLongestRequest>;

/// Returns the used part of `buffer`.
[[nodiscard]] std::span<const std::uint8_t> writeRequest(const Request& request, RequestBuffer& buffer);

}  // namespace darwinop::remote
