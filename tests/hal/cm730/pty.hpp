// The robot's end of a pseudo terminal.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <vector>

#include "hil-mocks/pty.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::cm730 {

using hil::Pty;

inline void send(Pty& pty, Bytes bytes) {
  ASSERT_EQ(pty.write(bytes), bytes.size());
}

/// What the client has sent, when it is `count` bytes; less when they do not come within seconds.
inline std::vector<std::uint8_t> receive(Pty& pty, std::size_t count) {
  std::vector<std::uint8_t> bytes;
  pollfd file{pty.fd(), POLLIN, 0};
  while (bytes.size() < count && ::poll(&file, 1, 10'000) > 0) {
    std::array<std::uint8_t, 512> some;
    const std::size_t got = pty.read(some);
    if (got == 0) break;
    bytes.insert(bytes.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(got));
  }
  return bytes;
}

}  // namespace darwinop::cm730
