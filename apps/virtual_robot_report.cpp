#include "virtual_robot_report.hpp"

#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "core/joints.hpp"
#include "hil-mocks/pty_host.hpp"

namespace darwinop::app {
namespace {

constexpr Nanos kTooLate = std::chrono::milliseconds{16};  // one cycle of the loop

double ms(Nanos time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

void printJoints(hil::PtyHost& host) {
  const BodyState body = host.withRobot([](hil::VirtualRobot& robot) { return robot.body().state(); });
  std::printf("joints: %.2f s", std::chrono::duration<double>(host.now()).count());
  for (std::size_t i = 0; i < kJoints; ++i)
    std::printf(" %s=%+.3f", std::string{kJointTable[i].name}.c_str(), body.joint[i].position_rad);
  std::printf(" rad");
  if (!std::isnan(body.trunk_m[0]))
    std::printf(" trunk_x=%+.3f trunk_y=%+.3f trunk_z=%+.3f m", body.trunk_m[0], body.trunk_m[1], body.trunk_m[2]);
  std::printf("\n");
  std::fflush(stdout);
}

bool warnOfLag(const hil::PtyHost& host, bool physics) {
  if (host.worstLag() < kTooLate) return false;
  std::fprintf(stderr,
               "darwinop virtual-robot: this machine is too slow or busy: the simulation was %.0f ms behind real time, "
               "and replies were late. Close other programs%s\n",
               ms(host.worstLag()), physics ? ", or use --body plain" : "");
  return true;
}

void report(const hil::VirtualRobot& robot, std::uint64_t torque_on, double seconds, Nanos lag) {
  const hil::BoardCounters& c = robot.board().counters();
  std::printf("\nframes: %" PRIu64 "  %s: %" PRIu64 "  %s: %" PRIu64 "  replies: %" PRIu64 "  checksum errors: %" PRIu64
              "  lost bytes: %" PRIu64 "\n",
              c.frames, kSyncWrites, c.sync_writes, kBulkReads, c.bulk_reads, c.replies, c.bad_checksums, c.lost_bytes);
  std::printf("cycles per second: %.1f over %.1f s\n", static_cast<double>(c.bulk_reads) / seconds, seconds);
  std::printf("%s: %" PRIu64 "\n", kTorqueSwitchedOn, torque_on);
  std::printf("%s: at most %.1f ms\n", kBehindRealTime, ms(lag));
}

}  // namespace darwinop::app
