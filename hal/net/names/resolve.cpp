// Resolves host names. On a PC only: the robot's programs are static, and glibc cannot resolve names in those.
#include "hal/net/names/resolve.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <memory>
#include <stdexcept>

namespace darwinop::net {

std::vector<std::uint32_t> addressesOf(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_family = AF_INET;  // the servers are IPv4 only
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  const int error = getaddrinfo(host.c_str(), nullptr, &wanted, &list);
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner{list, [](addrinfo* all) {
                                                               if (all != nullptr) freeaddrinfo(all);
                                                             }};
  std::vector<std::uint32_t> addresses;
  for (const addrinfo* each = error == 0 ? list : nullptr; each != nullptr; each = each->ai_next)
    addresses.push_back(ntohl(reinterpret_cast<const sockaddr_in*>(each->ai_addr)->sin_addr.s_addr));
  if (addresses.empty())
    throw std::runtime_error("cannot resolve host '" + host + "' (" + gai_strerror(error) +
                             "); give the robot's IPv4 address, such as tcp://192.168.123.1");
  return addresses;
}

}  // namespace darwinop::net
