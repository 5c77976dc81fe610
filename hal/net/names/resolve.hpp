// Host name resolution.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace darwinop::net {

/// IPv4 addresses of a name or of dotted-quad text, host byte order; at least one. Blocks on the system's resolver,
/// possibly for seconds. Throws std::runtime_error.
[[nodiscard]] std::vector<std::uint32_t> addressesOf(const std::string& host);

}  // namespace darwinop::net
