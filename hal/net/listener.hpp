// The door: open while a client may come in, closed while one is inside.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/net/addresses.hpp"
#include "hal/net/socket.hpp"

namespace darwinop::net {

/// A closed door refuses connections, which every client understands; those of 2013 and of today then try again for ten
/// seconds. One that was let in and shown out would wait for ever for its answer.
class Listener {
 public:
  struct Caller {
    Socket socket;
    Ipv4 address = 0;
    std::string name;  // "192.168.123.5:40312"
  };

  /// Opens the door. Port 0: any that is free. Throws std::runtime_error with what to do.
  Listener(Ipv4 address, std::uint16_t port);

  /// Throws as the constructor does.
  void open();
  void close() { door_.close(); }
  [[nodiscard]] bool isOpen() const { return door_.open(); }
  [[nodiscard]] int descriptor() const { return door_.descriptor(); }
  [[nodiscard]] std::uint16_t port() const { return port_; }

  /// Who waits at the door; nothing when nobody does.
  [[nodiscard]] std::optional<Caller> next();

 private:
  [[nodiscard]] Socket made() const;
  void bindToPort(const Socket& socket) const;

  Ipv4 address_;
  std::uint16_t port_;
  Socket place_;  // bound for life, never listens: keeps the port while the door is closed
  Socket door_;
  bool shares_by_user_ = false;  // no other user's socket may be bound beside place_, not even while the door opens
};

}  // namespace darwinop::net
