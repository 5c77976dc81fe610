// Child process of the supervisor.
#include "supervisor/child.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>
#include <stdexcept>

namespace darwinop::supervisor {
namespace {

/// Everything the child needs, allocated before the fork: between fork and exec of a multi-threaded process only
/// async-signal-safe calls are allowed, hence no allocation.
struct Prepared {
  std::vector<std::string> environment;
  std::vector<char*> arguments, variables;
  const char* folder;
  const char* log;
  const runtime::Account* account;  // null: the supervisor's account
  bool expendable;
  pid_t parent;
  sigset_t signals;  // signal mask of the program: empty
};

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> list;
  list.reserve(words.size() + 1);
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environmentOf(const Start& start) {
  std::vector<std::string> all;
  std::vector<std::pair<std::string, std::string>> given = start.environment;
  if (start.account) std::ranges::copy(runtime::environmentOf(*start.account), std::back_inserter(given));
  for (const auto& [name, value] : given) all.emplace_back(name).append("=").append(value);
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string name{*variable, strcspn(*variable, "=")};
    bool replaced = false;
    for (const auto& added : given) replaced = replaced || added.first == name;
    if (!replaced) all.emplace_back(*variable);
  }
  return all;
}

void writeTo(const char* path, const char* text) {
  const int fd = open(path, O_WRONLY | O_CLOEXEC);
  if (fd < 0) return;
  if (write(fd, text, strlen(text)) < 0) errno = 0;  // best effort
  close(fd);
}

void reportError(const char* what, const char* name) {
  for (const char* text : {"darwinop supervisor: cannot ", what, " ", name, ": ", strerrordesc_np(errno), "\n"})
    if (text != nullptr && write(STDERR_FILENO, text, strlen(text)) < 0) return;
}

/// In the child: resets priority, signals and OOM protection to their defaults.
void becomeOrdinary(const Prepared& with) {
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
  for (int number = 1; number < NSIG; ++number) std::signal(number, SIG_DFL);
  sigprocmask(SIG_SETMASK, &with.signals, nullptr);
  if (with.expendable) {
    writeTo("/proc/self/oom_score_adj", "0");
    writeTo("/proc/self/oom_adj", "0");  // before Linux 2.6.36
  }
  setpgid(0, 0);
}

/// Opened with the supervisor's rights: the program may append to its log, but not replace it. -1: none.
int openLog(const char* path) {
  if (*path == '\0') return -1;
  const int log = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (log < 0) reportError("write to", path);
  return log;
}

[[noreturn]] void become(const Prepared& with) {
  becomeOrdinary(with);
  const int log = openLog(with.log);
  if (with.account != nullptr && !runtime::takeRightsOf(*with.account)) {
    reportError("become user", with.account->name.c_str());
    _exit(126);
  }
  // The kernel clears this setting when a process changes its user.
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  if (getppid() != with.parent) _exit(128 + SIGTERM);  // the parent died before prctl()
  if (log >= 0 && (dup2(log, STDOUT_FILENO) < 0 || dup2(log, STDERR_FILENO) < 0)) _exit(126);
  if (*with.folder != '\0' && chdir(with.folder) != 0) {
    reportError("go to", with.folder);
    _exit(126);
  }
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  execve(with.arguments[0], with.arguments.data(), with.variables.data());
  reportError("run", with.arguments[0]);
  _exit(errno == ENOENT ? 127 : 126);
}

}  // namespace

Child::Child(const Start& start) {
  Prepared with{environmentOf(start),
                pointers(start.command),
                {},
                start.folder.c_str(),
                start.log.c_str(),
                start.account ? &*start.account : nullptr,
                start.expendable,
                getpid(),
                {}};
  with.variables = pointers(with.environment);
  sigemptyset(&with.signals);
  // No handler of the supervisor may run in the child before the child has reset them.
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before);
  const pid_t pid = fork();
  if (pid == 0) become(with);
  const int error = errno;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  if (pid < 0) throw std::runtime_error("cannot start " + start.command.at(0) + ": " + std::strerror(error));
  pid_ = pid;
}

Child::~Child() {
  signal(SIGTERM);
  (void)ended();  // if it has not ended yet, init reaps it
}

std::optional<Ending> Child::ended() {
  if (ending_) return ending_;
  int status = 0;
  const pid_t which = waitpid(pid_, &status, WNOHANG);
  if (which == pid_)
    ending_ = WIFSIGNALED(status) ? Ending{WTERMSIG(status), true} : Ending{WEXITSTATUS(status), false};
  if (which < 0 && errno == ECHILD) ending_ = Ending{SIGKILL, true};  // reaped elsewhere
  return ending_;
}

void Child::signal(int number) {
  if (!ended()) kill(pid_, number);
}

}  // namespace darwinop::supervisor
