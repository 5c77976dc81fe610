// A whole poll (accelerometer, gyroscope, picture, twenty positions and torques) and its reply over the loopback, one
// after the other; beside it the same number of bytes each way from a thread that does nothing but send them, which is
// what the network alone costs.
#include <fcntl.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "served_poll.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::remote;

constexpr int kRounds = 20'000;
constexpr std::size_t kJpegBytes = 11'300;  // thesis of 2013: 320x240 at 65 %

/// In us, the shortest first.
std::vector<double> measure(std::uint16_t port) {
  bench::PollingClient client{bench::connectTo(port)};
  std::vector<double> us;
  for (int round = 0; round < kRounds; ++round) us.push_back(client.exchange(kJpegBytes));
  std::ranges::sort(us);
  return us;
}

std::vector<double> measureServer() {
  bench::ServingThread serving;
  serving.show(std::vector<std::uint8_t>(kJpegBytes, 7));
  return measure(serving.port());
}

std::vector<double> measureBytes() {
  net::Listener echo{INADDR_LOOPBACK, 0};
  std::thread echoing{[&] {
    std::optional<net::Listener::Caller> caller;
    while (!caller) caller = echo.next();
    RequestBuffer buffer;
    std::vector<std::uint8_t> in(writeRequest(bench::wholePoll(), buffer).size());
    std::vector<std::uint8_t> out(kReplyHead + 24 + 4 + kJpegBytes + 8 * kJoints + 1);
    out[0] = kFirstByte;
    (void)fcntl(caller->socket.descriptor(), F_SETFL, 0);
    while (bench::receiveAll(caller->socket, in))
      (void)send(caller->socket.descriptor(), out.data(), out.size(), MSG_NOSIGNAL);
  }};
  const std::vector<double> us = measure(echo.port());
  echoing.join();
  return us;
}

}  // namespace

int main() {
  const std::vector<double> ours = measureServer(), peer = measureBytes();
  const auto print = [&](const char* name, double share) {
    const auto at = static_cast<std::size_t>(share * (kRounds - 1));
    std::printf("bench: remote_round_trip_%s ours=%.1f peer=%.1f ratio=%.3f unit=us\n", name, ours[at], peer[at],
                ours[at] / peer[at]);
  };
  print("p50", 0.5);
  print("p99", 0.99);
}
