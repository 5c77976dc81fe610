// A program that the supervisor has started.
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

/// Everything the child needs, made before the fork: between fork and exec of a process with threads only calls that
/// are async-signal-safe are allowed, and memory is none of them.
struct Prepared {
  std::vector<std::string> environment;
  std::vector<char*> arguments, variables;
  const char* folder;
  const char* log;
  const runtime::Account* account;  // null: the supervisor's
  bool expendable;
  pid_t parent;
  sigset_t signals;  // that shall be blocked in the program: none
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

void complain(const char* what, const char* name) {
  for (const char* text : {"darwinop supervisor: cannot ", what, " ", name, ": ", strerrordesc_np(errno), "\n"})
    if (text != nullptr && write(STDERR_FILENO, text, strlen(text)) < 0) return;
}

/// In the child. Priority, signals and protection of the supervisor are its own.
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

/// With the supervisor's rights: the program may append to its log, not replace it. -1: none.
int openLog(const char* path) {
  if (*path == '\0') return -1;
  const int log = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (log < 0) complain("write to", path);
  return log;
}

[[noreturn]] void become(const Prepared& with) {
  becomeOrdinary(with);
  const int log = openLog(with.log);
  if (with.account != nullptr && !runtime::takeRightsOf(*with.account)) {
    complain("become user", with.account->name.c_str());
    _exit(126);
  }
  // The kernel forgets this when a process changes its user.
  prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGTERM), 0UL, 0UL, 0UL);
  if (getppid() != with.parent) _exit(128 + SIGTERM);  // it died before the line above
  if (log >= 0 && (dup2(log, STDOUT_FILENO) < 0 || dup2(log, STDERR_FILENO) < 0)) _exit(126);
  if (*with.folder != '\0' && chdir(with.folder) != 0) {
    complain("go to", with.folder);
    _exit(126);
  }
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  execve(with.arguments[0], with.arguments.data(), with.variables.data());
  complain("run", with.arguments[0]);
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
  // No handler of the supervisor may run in the child before it has put them away.
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
  (void)ended();  // one that takes its time is left to init
}

std::optional<Ending> Child::ended() {
  if (ending_) return ending_;
  int status = 0;
  const pid_t which = waitpid(pid_, &status, WNOHANG);
  if (which == pid_)
    ending_ = WIFSIGNALED(status) ? Ending{WTERMSIG(status), true} : Ending{WEXITSTATUS(status), false};
  if (which < 0 && errno == ECHILD) ending_ = Ending{SIGKILL, true};  // somebody else reaped it
  return ending_;
}

void Child::signal(int number) {
  if (!ended()) kill(pid_, number);
}

}  // namespace darwinop::supervisor
