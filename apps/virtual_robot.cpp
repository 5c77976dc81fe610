// darwinop-virtual-robot: a virtual CM-730 with twenty MX-28 on a pseudo terminal.
#include <signal.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>

#include "core/joints.hpp"
#include "hil-mocks/fault_script.hpp"
#include "hil-mocks/pty_host.hpp"

namespace {

using darwinop::Nanos;
namespace hil = darwinop::hil;

struct Arguments {
  std::string link, faults;
  bool fast = false;
  std::uint64_t seed = 1;
  double for_s = 0, latency_ms = 0;
};

void describe(CLI::App& app, Arguments& a) {
  app.add_option("--link", a.link, "Keep a symbolic link to the port here");
  app.add_flag("--fast", a.fast, "Answer at once instead of at 1 Mbaud");
  app.add_option("--faults", a.faults, "What goes wrong when; format: docs/virtual-robot.md")->check(CLI::ExistingFile);
  app.add_option("--seed", a.seed, "Of everything random")->capture_default_str();
  app.add_option("--for", a.for_s, "End after so many seconds")->check(CLI::Range(0.01, 1e6));
  app.add_option("--latency-timer", a.latency_ms, "Hold replies back as an FTDI bridge does, ms (16 is its default)")
      ->check(CLI::Range(0, 255));
  app.footer(
      "Example:\n  darwinop-virtual-robot --link /tmp/darwin &\n  darwinop run --robot /tmp/darwin "
      "build/release/controllers/01_hello_head\n");
}

/// Where every joint is, in one line: asked for by SIGUSR1.
void printJoints(hil::PtyHost& host) {
  const hil::BodyState body = host.withRobot([](hil::VirtualRobot& robot) { return robot.body().state(); });
  std::printf("joints: %.2f s", std::chrono::duration<double>(host.now()).count());
  for (std::size_t i = 0; i < darwinop::kJoints; ++i)
    std::printf(" %s=%+.3f", std::string{darwinop::kJointTable[i].name}.c_str(), body.joint[i].position_rad);
  std::printf(" rad\n");
  std::fflush(stdout);
}

/// Until SIGINT, SIGTERM, or the time is over. The signals are blocked in every thread.
void waitForEnd(const sigset_t& signals, double for_s, hil::PtyHost& host) {
  const double end_s = for_s > 0 ? for_s : 1e9;
  for (;;) {
    const double left_s = std::max(end_s - std::chrono::duration<double>(host.now()).count(), 0.0);
    const auto seconds = static_cast<time_t>(left_s);
    const timespec time{seconds, static_cast<long>((left_s - static_cast<double>(seconds)) * 1e9)};
    const int signal = sigtimedwait(&signals, nullptr, &time);
    if (signal != SIGUSR1) return;
    printJoints(host);
  }
}

void report(const hil::VirtualRobot& robot, double seconds) {
  const hil::BoardCounters& c = robot.board().counters();
  std::printf("\nframes: %" PRIu64 "  sync writes: %" PRIu64 "  bulk reads: %" PRIu64 "  replies: %" PRIu64
              "  checksum errors: %" PRIu64 "  lost bytes: %" PRIu64 "\n",
              c.frames, c.sync_writes, c.bulk_reads, c.replies, c.bad_checksums, c.lost_bytes);
  std::printf("cycles per second: %.1f over %.1f s\n", static_cast<double>(c.bulk_reads) / seconds, seconds);
}

int serve(const Arguments& a) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // before the first thread, so that only waitForEnd() gets them

  hil::BoardOptions options;
  if (a.fast) options.byte_time = Nanos{0};
  hil::VirtualRobot robot{options, a.seed};
  if (!a.faults.empty()) robot.faults().add(hil::loadFaultScript(a.faults));
  const auto latency = std::chrono::duration_cast<Nanos>(std::chrono::duration<double, std::milli>(a.latency_ms));
  Nanos served{0};
  {
    hil::PtyHost host{robot, {a.link, latency}};
    std::printf("port: %s\n", host.path().c_str());
    if (!a.link.empty()) std::printf("link: %s\n", a.link.c_str());
    if (!a.faults.empty()) std::printf("faults: %s, seed %" PRIu64 "\n", a.faults.c_str(), a.seed);
    std::fflush(stdout);
    waitForEnd(signals, a.for_s, host);
    served = host.now();
  }
  report(robot, std::chrono::duration<double>(served).count());
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"A virtual DARwIn-OP: CM-730 board and twenty MX-28 servos on a pseudo terminal, paced at 1 Mbaud.",
               "darwinop-virtual-robot"};
  Arguments arguments;
  describe(app, arguments);
  app.set_version_flag("--version", DARWINOP_VERSION);
  CLI11_PARSE(app, argc, argv);
  return serve(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop-virtual-robot: %s\n", error.what());
    return 1;
  }
}
