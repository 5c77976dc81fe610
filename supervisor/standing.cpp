// Priority, memory locking and OOM protection of the supervisor.
#include "supervisor/standing.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "hal/descriptor.hpp"

namespace darwinop::supervisor {
namespace {

bool tryWriteTo(const char* path, const char* text) {
  const Descriptor file{open(path, O_WRONLY | O_CLOEXEC)};
  return file.fd() >= 0 && write(file.fd(), text, strlen(text)) > 0;
}

}  // namespace

std::string standFast() {
  std::string refused;
  sched_param parameter{};
  parameter.sched_priority = kWatchPriority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0) refused = "real-time priority";
  // Present memory only. The rescue allocates more, and may have page faults: it is not time-critical.
  if (mlockall(MCL_CURRENT) != 0) refused += refused.empty() ? "locked memory" : " and locked memory";
  // Protection from the OOM killer. The second name is that before Linux 2.6.36.
  if (!tryWriteTo("/proc/self/oom_score_adj", "-1000")) (void)tryWriteTo("/proc/self/oom_adj", "-17");
  if (refused.empty()) return {};
  return "the kernel refused " + refused + "; a hanging loop may be detected late; run as root";
}

void standDown() {
  const sched_param none{};
  (void)sched_setscheduler(0, SCHED_OTHER, &none);
}

}  // namespace darwinop::supervisor
