// A computer's name to addresses. On a PC only: programs of the robot are static, and cannot look names up.
#include "hal/net/resolve.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <memory>
#include <stdexcept>

namespace darwinop::net {

std::vector<std::uint32_t> addressesOf(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_family = AF_INET;  // as the servers of 2013 and of today
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
    throw std::runtime_error("no computer is called '" + host + "' here (" + gai_strerror(error) +
                             "); give the robot's IPv4 address, such as tcp://192.168.123.1");
  return addresses;
}

}  // namespace darwinop::net
