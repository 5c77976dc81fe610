// A network between two of this computer's network namespaces, with a rate and a delay: packets go through two TUN
// devices and this process. Real TCP at both ends, nothing lost, no half-duplex radio.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "hal/net/socket.hpp"

namespace darwinop::bench {

/// Puts the calling thread into a network of its own with one device, whose other end is the descriptor. Throws
/// std::runtime_error when that is not allowed, or the kernel has no such device.
inline net::Socket enterNetwork(std::uint32_t address) {
  const auto must = [](bool done, const std::string& what) {
    if (!done) throw std::runtime_error(what + ": " + std::strerror(errno));
  };
  must(unshare(CLONE_NEWNET) == 0, "a network namespace needs root");
  net::Socket device{open("/dev/net/tun", O_RDWR | O_NONBLOCK)};
  must(device.open(), "/dev/net/tun");
  ifreq asked{};
  std::strncpy(asked.ifr_name, "link", IFNAMSIZ - 1);
  asked.ifr_flags = IFF_TUN | IFF_NO_PI;
  must(ioctl(device.descriptor(), TUNSETIFF, &asked) == 0, "TUNSETIFF");
  const net::Socket any{::socket(AF_INET, SOCK_DGRAM, 0)};
  const auto set = [&](unsigned long what, std::uint32_t value) {
    auto* const name = reinterpret_cast<sockaddr_in*>(&asked.ifr_addr);
    *name = {};
    name->sin_family = AF_INET;
    name->sin_addr.s_addr = htonl(value);
    must(ioctl(any.descriptor(), what, &asked) == 0, "the address of a TUN device");
  };
  set(SIOCSIFADDR, address);
  set(SIOCSIFNETMASK, 0xFFFFFF00);
  asked.ifr_flags = IFF_UP | IFF_RUNNING;
  must(ioctl(any.descriptor(), SIOCSIFFLAGS, &asked) == 0, "a TUN device");
  return device;
}

/// One direction. The last bit leaves when all before it have left at that rate, and arrives after the delay.
class LinkDirection {
 public:
  LinkDirection(int from, int to) : from_{from}, to_{to}, thread_{[this] { run(); }} {}
  ~LinkDirection() {
    stop_ = true;
    thread_.join();
  }
  LinkDirection(const LinkDirection&) = delete;
  LinkDirection& operator=(const LinkDirection&) = delete;

  /// Between two exchanges only.
  void set(double megabits_per_s, std::chrono::microseconds delay) {
    ns_per_byte_ = 8000 / megabits_per_s;
    delay_ns_ = std::chrono::nanoseconds{delay}.count();
  }

 private:
  using Time = std::chrono::steady_clock::time_point;
  struct Packet {
    Time arrives;
    std::vector<char> bytes;
  };

  void run() {
    const sched_param soon{.sched_priority = 50};  // where it is allowed: a late forwarder is not a slow network
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &soon);
    (void)prctl(PR_SET_TIMERSLACK, 1);
    while (!stop_) {
      const Time now = std::chrono::steady_clock::now();
      auto wait = std::chrono::nanoseconds{std::chrono::milliseconds{20}};
      if (!way_.empty()) wait = std::clamp(way_.front().arrives - now, std::chrono::nanoseconds{0}, wait);
      const timespec at_most{0, static_cast<long>(wait.count())};
      pollfd place{from_, POLLIN, 0};
      (void)ppoll(&place, 1, &at_most, nullptr);
      takeWhatCame();
      handOver();
    }
  }
  void takeWhatCame() {
    std::array<char, 2048> bytes;
    for (ssize_t count = 0; (count = read(from_, bytes.data(), bytes.size())) > 0;) {
      const std::chrono::nanoseconds takes{static_cast<long>(static_cast<double>(count) * ns_per_byte_)};
      free_ = std::max(free_, std::chrono::steady_clock::now()) + takes;
      way_.push_back({free_ + std::chrono::nanoseconds{delay_ns_}, {bytes.data(), bytes.data() + count}});
    }
  }
  void handOver() {
    for (; !way_.empty() && way_.front().arrives <= std::chrono::steady_clock::now(); way_.pop_front())
      (void)!write(to_, way_.front().bytes.data(), way_.front().bytes.size());
  }

  int from_, to_;
  std::atomic<double> ns_per_byte_{0};
  std::atomic<long> delay_ns_{0};
  std::deque<Packet> way_;
  Time free_{};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace darwinop::bench
