// A pseudo terminal in raw mode, with an optional link to it: stands for the robot's serial port.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/packet.hpp"

namespace darwinop::hil {

/// Both ends are closed, and the link removed, when it goes. Throws std::runtime_error if it cannot be made.
class Pty {
 public:
  /// `link`: path of a symbolic link to keep pointing here; empty: none.
  explicit Pty(std::string link = {});
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  /// What a client opens, such as /dev/pts/3.
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] int fd() const noexcept { return master_; }
  /// Bytes a client wrote; 0: none now.
  std::size_t read(std::span<std::uint8_t> into) noexcept;
  /// What no client takes is lost, as on a wire; returns how many went.
  std::size_t write(Bytes bytes) noexcept;
  /// Ends an exclusive claim (TIOCEXCL) that a client left behind.
  void dropStaleClaim() noexcept;

 private:
  void makeLink() const;

  std::string link_, path_;
  int master_ = -1;
  int slave_ = -1;  // kept open: without it the last client's close would hang the master up
};

}  // namespace darwinop::hil
