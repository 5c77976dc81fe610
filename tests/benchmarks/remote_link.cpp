// How good a link has to be: the round trip of a whole poll through the server, over networks of several rates and
// delays, for pictures of several sizes. Prints a table: median, and the share of steps that keep to 16 ms.
#include <algorithm>
#include <cstdio>

#include "served_poll.hpp"
#include "slow_link.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::remote;

constexpr net::Ipv4 kController = 0x0A090001, kServer = 0x0A090002;  // 10.9.0.1, 10.9.0.2
constexpr int kSteps = 50;

// 320x240 and 160x120: thesis of 2013. The smaller ones: 0.6 kB of tables, and a quarter of the rest each time.
struct Picture {
  const char* name;
  std::size_t bytes;
};
constexpr std::array kPictures{Picture{"no picture", 0}, Picture{"40x30", 930}, Picture{"80x60", 1870},
                               Picture{"160x120", 5600}, Picture{"320x240", 11300}};

ServerConfig everywhere() {
  ServerConfig config = bench::ServingThread::anyPort();
  config.address = 0;
  config.allowed = {net::networkFromText("10.9.0.0/24")};
  return config;
}

void measureLink(bench::ServingThread& serving, bench::PollingClient& client) {
  for (const Picture& picture : kPictures) {
    serving.show(std::vector<std::uint8_t>(picture.bytes, 7));
    std::vector<double> ms;
    for (int i = 0; i < kSteps; ++i) ms.push_back(client.exchange(picture.bytes) / 1000);
    const auto in_time = std::ranges::count_if(ms, [](double each) { return each <= 16; });
    std::ranges::sort(ms);
    std::printf(" %.1f, %ld %% |", ms[kSteps / 2], static_cast<long>(in_time * 100 / kSteps));
    std::fflush(stdout);
  }
  std::puts("");
}

void printTable() {
  const net::Socket client_end = bench::enterNetwork(kController);
  net::Socket server_end;
  bench::ServingThread serving{everywhere(), [&] { server_end = bench::enterNetwork(kServer); }};
  bench::LinkDirection there{client_end.descriptor(), server_end.descriptor()};
  bench::LinkDirection back{server_end.descriptor(), client_end.descriptor()};
  bench::PollingClient client{bench::connectTo(serving.port(), kServer)};

  std::printf("| Mbit/s | ping, ms |");
  for (const Picture& picture : kPictures) std::printf(" %s |", picture.name);
  std::puts("\n|---:|---:|---:|---:|---:|---:|---:|");
  for (const int rate : {100, 54, 11, 2})
    for (const int ping : {0, 1, 5, 20}) {
      for (bench::LinkDirection* const way : {&there, &back}) way->set(rate, std::chrono::microseconds{500 * ping});
      std::printf("| %d | %d |", rate, ping);
      measureLink(serving, client);
    }
}

}  // namespace

int main() try {
  printTable();
  return 0;
} catch (const std::exception& refused) {
  std::fprintf(stderr, "remote_link: not measured: %s\n", refused.what());
  return 0;
}
