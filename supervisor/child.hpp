// Child process of the supervisor, from fork to exit.
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
  std::string folder;                // working directory; empty: the supervisor's
  std::string log;                   // both outputs are appended here; empty: the supervisor's outputs
  std::vector<std::pair<std::string, std::string>> environment;  // added to the supervisor's
  std::optional<runtime::Account> account;                       // account to run as; empty: the supervisor's
  bool expendable = false;                                       // preferred victim of the kernel's OOM killer
};

class Child {
 public:
  /// The program runs without real-time priority in its own process group, so that Ctrl-C in a terminal reaches only
  /// the supervisor. If the supervisor dies, the kernel sends it SIGTERM. Throws std::runtime_error if fork() fails; a
  /// program that cannot be executed ends with code 126 or 127.
  explicit Child(const Start& start);
  /// Sends SIGTERM if it still runs, without waiting: a killed runtime would leave the robot under torque.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Exit status, once it has ended. Never blocks.
  [[nodiscard]] std::optional<Ending> ended();
  /// Sends to the process only; no effect after its end.
  void signal(int number);

 private:
  pid_t pid_ = 0;
  std::optional<Ending> ending_;
};

}  // namespace darwinop::supervisor
