// The controller that drives the robot which is watched: `darwinop run`, as a child of this process.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace darwinop::twin {

class ControllerProcess {
 public:
  /// `controller`: program or folder, and its arguments. `port`: where the robot is. Throws std::runtime_error.
  ControllerProcess(const std::vector<std::string>& controller, const std::string& port);
  /// Ends it, at once if it does not end by itself.
  ~ControllerProcess();
  ControllerProcess(const ControllerProcess&) = delete;
  ControllerProcess& operator=(const ControllerProcess&) = delete;

  /// Its exit status as a shell has it; nothing: it still runs.
  std::optional<int> ended();
  /// SIGINT lets the robot sit down first.
  void signal(int number) const;

 private:
  pid_t pid_ = 0;
  std::optional<int> status_;
};

}  // namespace darwinop::twin
