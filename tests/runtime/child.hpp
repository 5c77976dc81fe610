// A forked process for tests of what happens between processes.
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <stdexcept>

namespace darwinop::runtime {

/// Runs `body` in a process of its own and reports when it is ready; then the process waits to be killed.
class Child {
 public:
  explicit Child(const std::function<void()>& body) {
    int ready[2];
    if (pipe(ready) != 0) throw std::runtime_error("pipe");
    pid_ = fork();
    if (pid_ == 0) {
      body();
      const bool written = write(ready[1], "x", 1) == 1;
      for (;;) written ? (void)pause() : _exit(1);
    }
    close(ready[1]);
    char byte;
    const bool came = read(ready[0], &byte, 1) == 1;
    close(ready[0]);
    if (!came) throw std::runtime_error("the child ended before it was ready");
  }
  ~Child() { kill(SIGKILL); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Sends the signal and waits until the process is gone.
  void kill(int signal) {
    if (pid_ <= 0) return;
    ::kill(pid_, signal);
    waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }
  /// Waits until it ends by itself. 128 + signal, or its exit status.
  int exitStatus() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = 0;
};

}  // namespace darwinop::runtime
