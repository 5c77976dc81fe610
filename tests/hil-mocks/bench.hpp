// Test bench for a virtual board: sends bytes as hex and returns replies as hex.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "hil-mocks/plain_body.hpp"
#include "hil-mocks/virtual_board.hpp"

namespace darwinop::hil {

using namespace std::chrono_literals;

inline std::vector<std::uint8_t> bytesOf(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < hex.size();) {
    if (hex[i] == ' ') {
      ++i;
      continue;
    }
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    i += 2;
  }
  return bytes;
}

inline std::string hexOf(Bytes bytes) {
  std::string hex;
  for (const std::uint8_t byte : bytes) {
    char two[4];
    std::snprintf(two, sizeof two, hex.empty() ? "%02X" : " %02X", static_cast<unsigned>(byte));
    hex += two;
  }
  return hex;
}

/// `hex` followed by its checksum; for frames without a printed source.
inline std::string withChecksum(const std::string& hex) {
  const auto bytes = bytesOf(hex);
  unsigned sum = 0;
  for (std::size_t i = 2; i < bytes.size(); ++i) sum += bytes[i];
  const std::uint8_t check = static_cast<std::uint8_t>(~sum & 0xFF);
  return hex + " " + hexOf(Bytes{&check, 1});
}

struct Bench {
  struct Reply {
    std::string hex;
    Nanos at;
  };

  explicit Bench(BoardOptions options = powered()) : board{options, body} {}

  static BoardOptions powered() {
    BoardOptions options;
    options.servo_power = true;
    return options;
  }

  /// Sends now and waits 20 ms by default.
  std::vector<Reply> sendAll(const std::string& hex, Nanos wait = 20ms) {
    board.receive(bytesOf(hex), board.now());
    board.advance(board.now() + wait);
    std::vector<Reply> replies;
    for (ChunkRing& out = board.output(); !out.empty(); out.pop())
      replies.push_back({hexOf(out.front().bytes()), out.front().at});
    return replies;
  }
  /// The only reply; "" if there is none.
  std::string send(const std::string& hex) {
    std::string all;
    for (const Reply& reply : sendAll(hex)) all += (all.empty() ? "" : " | ") + reply.hex;
    return all;
  }

  PlainBody body;
  VirtualBoard board;
};

}  // namespace darwinop::hil
