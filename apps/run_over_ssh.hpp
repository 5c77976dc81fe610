// `darwinop run --robot tcp://USER@HOST`: remote control on the robot for one run, through ssh.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace darwinop {

/// USER@HOST of "tcp://USER@HOST"; nothing: another robot is meant. Throws std::runtime_error for one with a port.
std::optional<std::string> sshTarget(const std::string& robot);

/// The program that logs in, and everything on the robot, is `darwinop-install --remote`; it asks, tells and shows the
/// robot's output on the terminal. Here is its life: started, waited for, ended.
class RunOverSsh {
 public:
  /// `words`: options of darwinop-install and the target.
  RunOverSsh(const std::string& installer, const std::vector<std::string>& words);
  ~RunOverSsh();
  RunOverSsh(const RunOverSsh&) = delete;
  RunOverSsh& operator=(const RunOverSsh&) = delete;

  /// Port of this PC's loopback that leads to the robot. Nothing: it has been said why; end() has the status.
  std::optional<std::uint16_t> waitUntilReady();

  /// The robot is brought to rest; returns when it is. Exit status.
  int end();

 private:
  void start(const std::string& installer, const std::vector<std::string>& words);

  pid_t pid_ = 0;
  int say_ = -1;   // its stdin, which tells it that we live
  int hear_ = -1;  // its stdout
};

}  // namespace darwinop
