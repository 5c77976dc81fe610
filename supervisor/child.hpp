// A program that the supervisor has started, from fork to the end.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/users.hpp"
#include "supervisor/restart_policy.hpp"

namespace darwinop::supervisor {

struct Start {
  std::vector<std::string> command;  // the first is a path
  std::string folder;                // to work in; empty: the supervisor's
  std::string log;                   // both outputs are appended here; empty: they go where the supervisor's go
  std::vector<std::pair<std::string, std::string>> environment;  // added to the supervisor's
  std::optional<runtime::Account> account;                       // whose rights it has; empty: the supervisor's
  bool expendable = false;  // when memory runs out, the kernel may end this one first
};

class Child {
 public:
  /// The program runs as an ordinary process in a group of its own, so that Ctrl-C in a terminal reaches the
  /// supervisor alone. When the supervisor dies, however it dies, the kernel sends it SIGTERM. Throws
  /// std::runtime_error when no process can be made; a program that cannot be run ends with code 126 or 127.
  explicit Child(const Start& start);
  /// Tells it to end if it still runs, and does not wait: a runtime that is killed leaves the robot stiff.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// How it ended, once it has. Never waits.
  [[nodiscard]] std::optional<Ending> ended();
  /// To the process itself; nothing when it has ended.
  void signal(int number);

 private:
  pid_t pid_ = 0;
  std::optional<Ending> ending_;
};

}  // namespace darwinop::supervisor
