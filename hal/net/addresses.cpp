// IPv4 addresses and networks as people write them.
#include "hal/net/addresses.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <charconv>
#include <stdexcept>

namespace darwinop::net {

Ipv4 ipv4FromText(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1)
    throw std::runtime_error("'" + text + "' is no IPv4 address; write four numbers, such as 192.168.123.1");
  return ntohl(address.s_addr);
}

std::string textFromIpv4(Ipv4 address) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += std::to_string(address >> shift & 0xFF) + (shift > 0 ? "." : "");
  return text;
}

Network networkFromText(const std::string& text) {
  const std::size_t slash = text.find('/');
  Network network{.address = ipv4FromText(text.substr(0, slash))};
  if (slash == std::string::npos) return network;
  int bits = -1;
  const char* const first = text.data() + slash + 1;
  const auto [end, error] = std::from_chars(first, text.data() + text.size(), bits);
  if (error != std::errc{} || end != text.data() + text.size() || bits < 0 || bits > 32)
    throw std::runtime_error("'" + text +
                             "' is no network; write it as 192.168.123.0/24, with 0 to 32 behind the slash");
  network.mask = bits == 0 ? 0 : ~Ipv4{0} << (32 - bits);
  return network;
}

}  // namespace darwinop::net
