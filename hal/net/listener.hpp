// Listening TCP socket that can be closed and reopened without giving up its port.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/net/addresses.hpp"
#include "hal/net/socket.hpp"

namespace darwinop::net {

/// First words of the exception, before address, port and reason.
inline constexpr const char* kCannotListen = "cannot listen on ";

/// For a server of one client at a time. While closed, the kernel refuses connections, and clients retry for ten
/// seconds; a client that was accepted and dropped would wait forever for a reply.
class Listener {
 public:
  struct Accepted {
    Socket socket;
    Ipv4 address = 0;
    std::string name;  // "192.168.123.5:40312"
  };

  /// Binds and listens. Port 0: any free port. Throws std::runtime_error with the remedy.
  Listener(Ipv4 address, std::uint16_t port);

  /// Listens again after close(). Throws as the constructor does.
  void open();
  void close() { listening_.close(); }
  [[nodiscard]] bool isOpen() const { return listening_.open(); }
  [[nodiscard]] int descriptor() const { return listening_.descriptor(); }
  [[nodiscard]] std::uint16_t port() const { return port_; }

  /// The next pending connection, non-blocking; nullopt if there is none.
  [[nodiscard]] std::optional<Accepted> accept();

 private:
  [[nodiscard]] Socket makeSocket() const;
  void bindToPort(const Socket& socket) const;

  Ipv4 address_;
  std::uint16_t port_;
  Socket reservation_;  // always bound, never listens: keeps the port while closed
  Socket listening_;
  bool shares_by_user_ = false;  // SO_REUSEPORT is available: the port stays closed to other users while reopening
};

}  // namespace darwinop::net
