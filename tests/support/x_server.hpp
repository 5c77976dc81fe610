// An X server of a test's own, without a screen that anybody sees.
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace darwinop {

class XServer {
 public:
  XServer() {
    int ends[2];
    if (pipe(ends) != 0) return;
    pid_ = fork();
    if (pid_ == 0) {
      const std::string end = std::to_string(ends[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", end.c_str(), "-screen", "0", "800x600x24", "-nolisten", "tcp",
             static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    // It writes the number first and the end of the line later.
    std::string number;
    for (char next = 0; read(ends[0], &next, 1) == 1 && next != '\n';) number += next;
    close(ends[0]);
    if (!number.empty()) name_ = ":" + number;
  }
  ~XServer() { end(); }
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// For DISPLAY; empty: it did not start.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// As behind a network that hangs: connected, and silent.
  void hang() const { kill(pid_, SIGSTOP); }
  void end() {
    if (pid_ <= 0) return;
    kill(pid_, SIGTERM);
    kill(pid_, SIGCONT);
    waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }

 private:
  pid_t pid_ = 0;
  std::string name_;
};

}  // namespace darwinop
