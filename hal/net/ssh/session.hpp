// What runs on a robot for as long as a program of this PC needs it, and the ports of this PC that lead there.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace darwinop::ssh {

/// The program that logs in, and everything on the robot, is `darwinop-install --remote`, which lies beside this one;
/// it asks, tells and shows the robot's output on the terminal. Here is its life: started, waited for, ended. One at a
/// time.
///
/// SIGINT, SIGTERM and SIGHUP are its affair until waitUntilReady() returns, and again from end() on; in between they
/// are whose who wants them.
class SshSession {
 public:
  /// `program`: "darwinop run", which begins sentences. `words`: options of darwinop-install and the target.
  SshSession(std::string program, std::vector<std::string> words);
  ~SshSession();
  SshSession(const SshSession&) = delete;
  SshSession& operator=(const SshSession&) = delete;

  /// Ports of this PC's loopback that lead to the robot. None: it has been said why; end() has the status.
  std::vector<std::uint16_t> waitUntilReady();

  /// A signal came that nobody else has caught.
  [[nodiscard]] static bool toldToEnd();
  /// By itself: the link is lost, or the robot's half has ended; it has been said.
  [[nodiscard]] bool ended() const;

  /// The robot is brought to rest; returns when it is. Exit status.
  int end();

 private:
  void start(std::vector<std::string> words);
  [[nodiscard]] std::string hear() const;

  std::string program_;
  pid_t pid_ = 0;
  int say_ = -1;   // its stdin, which tells it that we live
  int hear_ = -1;  // its stdout
};

}  // namespace darwinop::ssh
