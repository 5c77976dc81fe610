// How late the 16 ms loop wakes while the port of remote control is attacked, beside how late it wakes when nobody
// comes. All take turns, a second each, so that what else runs on the machine disturbs all alike. The attackers have
// idle priority: on a robot they would be on other machines, and take none of its CPU time themselves.
//
// "sink" is the worst of the attacks on a thread that does nothing but receive: what the network alone costs.
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "hal/net/listener.hpp"
#include "remote/attackers.hpp"
#include "remote/siege_rig.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::remote;
using runtime::HistogramView;
using runtime::StatsView;

constexpr std::uint32_t kCyclesOfATurn = 63;  // 1 s

void becomeLast() {
  const sched_param none{};
  (void)pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);
}

/// Receives whatever comes, from one client after the other.
class Sink {
 public:
  ~Sink() {
    stop_ = true;
    thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return door_.port(); }

 private:
  void run() {
    std::vector<std::uint8_t> bytes(1024);
    while (!stop_) {
      pollfd place{door_.descriptor(), POLLIN, 0};
      if (poll(&place, 1, 20) != 1) continue;
      const auto caller = door_.next();
      place.fd = caller ? caller->socket.descriptor() : -1;
      while (caller && !stop_)
        if (poll(&place, 1, 20) == 1 && recv(place.fd, bytes.data(), bytes.size(), 0) <= 0) break;
    }
  }

  net::Listener door_{0x7F000001, 0};
  std::atomic<bool> stop_{false};
  std::thread thread_{[this] { run(); }};
};

struct Share {
  HistogramView wake;
  std::uint32_t cycles = 0, overruns = 0;
  double server_s = 0;

  void add(const StatsView& turn, double server) {
    for (std::size_t i = 0; i < wake.count.size(); ++i) wake.count[i] += turn.wake.count[i];
    cycles += turn.cycles;
    overruns += turn.overruns;
    server_s += server;
  }
  /// Of one CPU.
  [[nodiscard]] double serverPercent() const { return 100 * server_s / (cycles * 0.016); }
};

template <class During>
void takeTurn(const SiegeRig& rig, Share& share, During&& during) {
  [[maybe_unused]] const auto lives_till_the_end = during();
  const StatsView before = rig.stats();
  const auto cpu = rig.serverCpu();
  if (!rig.runCycles(kCyclesOfATurn)) throw std::runtime_error("the loop stands still: " + rig.runtime().output());
  share.add(rig.stats().since(before), (rig.serverCpu() - cpu).count());
}

void print(const std::string& rights, const std::string& what, const Share& ours, const Share& idle) {
  const auto line = [&](const char* figure, double value, double peer, const char* unit) {
    std::printf("bench: remote_flood_%s_%s_%s ours=%.1f peer=%.1f ratio=%.3f unit=%s\n", rights.c_str(), what.c_str(),
                figure, value, peer, value / std::max(peer, 1.0), unit);
  };
  line("p50", ours.wake.percentile(0.5), idle.wake.percentile(0.5), "us");
  line("p99", ours.wake.percentile(0.99), idle.wake.percentile(0.99), "us");
  line("overruns", ours.overruns, idle.overruns, "cycles");
  line("server_cpu", ours.serverPercent(), 100, "percent");  // peer: a whole CPU
  std::fflush(stdout);
}

/// Root has the right to real time by a capability, others by a limit: a command that takes it away.
std::vector<std::string> withoutRealTime() {
  if (geteuid() == 0) return {"/usr/bin/setpriv", "--bounding-set", "-sys_nice", "--inh-caps", "-sys_nice"};
  return {"/usr/bin/prlimit", "--rtprio=0"};
}

void besiege(const std::string& programs, const std::string& rights, int rounds) {
  const bool real_time = rights == "realtime";
  setenv("DARWINOP_REALTIME", real_time ? "required" : "if-allowed", 1);
  const SiegeRig rig{programs, real_time ? std::vector<std::string>{} : withoutRealTime()};
  const Sink sink;
  std::map<std::string, Share> shares;
  for (int round = 0; round < rounds; ++round) {
    takeTurn(rig, shares["idle"], [] { return 0; });
    for (const Attack attack : kAttacks)
      takeTurn(rig, shares[nameOf(attack)], [&] { return std::make_unique<Attacker>(attack, rig.port(), becomeLast); });
    takeTurn(rig, shares["sink"],
             [&] { return std::make_unique<Attacker>(Attack::kGarbage, sink.port(), becomeLast); });
  }
  for (const auto& [what, share] : shares)
    if (what != "idle") print(rights, what, share, shares["idle"]);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 3) throw std::runtime_error("usage: remote_flood PROGRAMS ROUNDS [realtime|ordinary]");
  const std::string only = count > 3 ? arguments[3] : "";
  for (const std::string rights : {"realtime", "ordinary"})
    if (only.empty() || only == rights) besiege(arguments[1], rights, std::atoi(arguments[2]));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "remote_flood: %s\n", error.what());
  return 1;
}
