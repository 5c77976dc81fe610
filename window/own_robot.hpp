// A robot for who has none: the virtual robot, a runtime on it, and perhaps a controller, as processes of their own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "window/child.hpp"
#include "window/private_folder.hpp"

namespace darwinop::window {

class OwnRobot {
 public:
  /// `body`: "twin", "twin:MODEL" or "plain". `controller`: a program and its arguments; empty: nobody drives. Throws
  /// std::runtime_error.
  OwnRobot(const std::string& body, const std::vector<std::string>& controller);
  /// Ends them: controller, runtime, robot.
  ~OwnRobot() { end(); }
  OwnRobot(const OwnRobot&) = delete;
  OwnRobot& operator=(const OwnRobot&) = delete;

  /// Of the runtime: for `darwinop runtime --name`, and DARWINOP_RUNTIME_NAME for controllers.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// File into which it paints what it sees, while somebody looks.
  [[nodiscard]] std::string eyes() const { return folder_.path() + "/eyes"; }
  /// For people: how a controller is started on it, from another terminal.
  [[nodiscard]] std::string howToDrive() const;
  /// A sentence when one of them has ended since the last call; empty: all is well.
  std::string news();

 private:
  void start(const std::string& body, const std::vector<std::string>& controller);
  void end() noexcept;

  PrivateFolder folder_;
  std::string name_;
  std::vector<std::string> eye_settings_;         // with which a controller sees
  std::string untold_;                            // news
  std::vector<std::unique_ptr<Child>> children_;  // ended from the last to the first
};

}  // namespace darwinop::window
