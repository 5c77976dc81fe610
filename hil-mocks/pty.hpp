// Pseudo terminal in raw mode with an optional symbolic link; stands in for the robot's serial port.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/packet.hpp"

namespace darwinop::hil {

/// The destructor closes both ends and removes the link. The constructor throws std::runtime_error on failure.
class Pty {
 public:
  /// `link`: path of a symbolic link to the terminal; empty: none.
  explicit Pty(std::string link = {});
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  /// Path for clients, such as /dev/pts/3.
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] int fd() const noexcept { return master_; }
  /// Bytes written by a client; 0: none.
  std::size_t read(std::span<std::uint8_t> into) noexcept;
  /// Bytes that no client reads are lost, as on a wire. Returns the number of bytes written.
  std::size_t write(Bytes bytes) noexcept;
  /// Clears an exclusive claim (TIOCEXCL) left by a client.
  void dropStaleClaim() noexcept;

 private:
  void makeLink() const;

  std::string link_, path_;
  int master_ = -1;
  int slave_ = -1;  // kept open: otherwise the last client's close would hang up the master
};

}  // namespace darwinop::hil
