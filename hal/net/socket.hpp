// RAII owner of a socket descriptor, and errors that need no new connection.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace darwinop::net {

/// Whether a transfer with this errno value may succeed later on the same connection.
constexpr bool isTemporary(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

class Socket {
 public:
  Socket() = default;
  explicit Socket(int descriptor) : descriptor_{descriptor} {}
  Socket(Socket&& other) noexcept : descriptor_{std::exchange(other.descriptor_, -1)} {}
  Socket& operator=(Socket&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~Socket() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] bool open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  void close() { const Socket ended{std::exchange(descriptor_, -1)}; }

 private:
  int descriptor_ = -1;
};

}  // namespace darwinop::net
