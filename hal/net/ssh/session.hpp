// SSH session: runs a program on a robot for the lifetime of a local program, with forwarded ports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/process/child_process.hpp"

namespace darwinop::ssh {

/// Starts, awaits and ends `darwinop-install --remote`, installed beside this program, which logs in, runs everything
/// on the robot and uses the terminal for questions and output. One session at a time. Handles SIGINT, SIGTERM and
/// SIGHUP until waitUntilReady() returns and again from end() on; in between the program may install its own handlers.
class SshSession {
 public:
  /// `program`: prefix of messages, such as "darwinop run". `words`: options of darwinop-install and the target.
  SshSession(std::string program, std::vector<std::string> words);
  ~SshSession();
  SshSession(const SshSession&) = delete;
  SshSession& operator=(const SshSession&) = delete;

  /// Forwarded ports on this PC's loopback. Empty: failed, and the reason has been printed; end() returns the status.
  std::vector<std::uint16_t> waitUntilReady();

  /// An end signal was received by the session's own handler.
  [[nodiscard]] static bool isEndRequested();
  /// The child has exited: connection lost or remote program ended; it has printed the reason.
  [[nodiscard]] bool ended();

  /// Brings the robot to rest and waits for that. Returns the exit status.
  int end();

 private:
  void start(std::vector<std::string> words);
  [[nodiscard]] std::string readLine() const;

  std::string program_;
  std::optional<process::ChildProcess> process_;  // end of file of its stdin means that this process has ended
};

}  // namespace darwinop::ssh
