#include "hal/process/exec.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "hal/signals.hpp"

namespace darwinop::process {
namespace {

constexpr int kAboveStreams = 10;

void report(const Prepared& with, const char* what, const char* name) {
  if (!with.start.error_prefix) return;
  for (const char* text :
       {with.start.error_prefix->c_str(), "cannot ", what, " ", name, ": ", strerrordesc_np(errno), "\n"})
    if (text != nullptr && write(STDERR_FILENO, text, strlen(text)) < 0) return;
}

[[noreturn]] void fail(const Prepared& with, const char* what, const char* name, int status = 126) {
  const int error = errno;
  if (with.failure >= 0 && write(with.failure, &error, sizeof error) < 0) _exit(status);
  report(with, what, name);
  _exit(status);
}

void writeTo(const char* path, const char* text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  if (write(file, text, strlen(text)) < 0) errno = 0;  // best effort
  close(file);
}

/// No handler of ours can run here: they are blocked until they are gone.
void resetSignals(bool keeps_ignored) {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction now {};
    const bool is_end = std::find(kEndSignals.begin(), kEndSignals.end(), number) != kEndSignals.end();
    if (keeps_ignored && is_end && sigaction(number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN) continue;
    signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void becomeOrdinary(const Start& start) {
  const sched_param none{};
  if (start.ordinary_priority) sched_setscheduler(0, SCHED_OTHER, &none);
  if (start.expendable) {
    writeTo("/proc/self/oom_score_adj", "0");
    writeTo("/proc/self/oom_adj", "0");  // before Linux 2.6.36
  }
  if (start.group == Start::Group::kItsOwn) setpgid(0, 0);
  if (start.group == Start::Group::kItsOwnSession) setsid();
}

/// The descriptor that number `number` becomes a copy of; -1: it stays as inherited.
int sourceOf(const Prepared& with, std::size_t number) {
  const Stream& stream = with.start.streams[number];
  if (stream.kind == Stream::Kind::kNothing) return open("/dev/null", O_RDWR | O_CLOEXEC);
  if (stream.kind != Stream::Kind::kAppended) return with.descriptors[number];
  const int file = open(stream.path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file < 0) report(with, "write to", stream.path.c_str());
  return file;
}

}  // namespace

void execute(Prepared& with) noexcept {
  const Start& start = with.start;
  resetSignals(start.keeps_ignored_signals);
  becomeOrdinary(start);
  // First all out of the way: a source may have the number of another stream.
  std::array<int, Start::kMaxStreams> sources{};
  for (std::size_t i = 0; i < start.streams.size(); ++i) {
    sources[i] = sourceOf(with, i);
    if (sources[i] >= 0) sources[i] = fcntl(sources[i], F_DUPFD_CLOEXEC, kAboveStreams);
  }
  if (with.failure >= 0) with.failure = fcntl(with.failure, F_DUPFD_CLOEXEC, kAboveStreams);
  if (start.account && !takeRightsOf(*start.account)) fail(with, "become user", start.account->name.c_str());
  if (start.ends_with_us) {
    // After that, because the kernel clears this setting when a process changes its user.
    prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
    if (getppid() != with.parent) _exit(128 + SIGTERM);  // the parent died before prctl()
  }
  for (std::size_t i = 0; i < start.streams.size(); ++i)
    if (sources[i] >= 0 && dup2(sources[i], static_cast<int>(i)) < 0) fail(with, "redirect", with.program.c_str());
  if (!start.folder.empty() && chdir(start.folder.c_str()) != 0) fail(with, "go to", start.folder.c_str());
  if (start.closes_others) {
    const int first = std::max(static_cast<int>(start.streams.size()), STDERR_FILENO + 1);
    if (with.failure >= 0) with.failure = dup3(with.failure, first, O_CLOEXEC);
    closefrom(with.failure >= 0 ? first + 1 : first);  // without close_range(), as on the robot, it reads /proc/self/fd
  }
  execve(with.program.c_str(), with.arguments.data(), with.variables.data());
  fail(with, "run", with.program.c_str(), errno == ENOENT ? 127 : 126);
}

}  // namespace darwinop::process
