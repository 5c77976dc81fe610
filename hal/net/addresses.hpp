// IPv4 addresses and networks as people write them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace darwinop::net {

/// In the order of the bytes as written: 127.0.0.1 is 0x7F000001.
using Ipv4 = std::uint32_t;

/// Throws std::runtime_error with an example when it is none.
[[nodiscard]] Ipv4 ipv4FromText(const std::string& text);
[[nodiscard]] std::string textFromIpv4(Ipv4 address);

[[nodiscard]] constexpr bool isLoopback(Ipv4 address) {
  return address >> 24 == 127;
}

/// "192.168.123.0/24"; one address alone is a network of one.
struct Network {
  Ipv4 address = 0, mask = 0xFFFFFFFF;
  [[nodiscard]] constexpr bool has(Ipv4 other) const { return (other & mask) == (address & mask); }
};

/// Throws std::runtime_error with an example when it is none.
[[nodiscard]] Network networkFromText(const std::string& text);

}  // namespace darwinop::net
