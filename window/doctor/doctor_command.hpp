// How the robot of this window is checked: a command on this computer, or why there is none.
#pragma once

#include <string>
#include <vector>

#include "window/view/robot_choice.hpp"

namespace darwinop::window {

struct DoctorCommand {
  std::string program{};                 // path of darwinop-doctor
  std::vector<std::string> arguments{};  // without --json
  std::string elsewhere{};  // the robot's port is on another computer: what to run there; empty: on this one
};

/// `program`: path of darwinop-doctor. `own_port`: port of the window's own virtual robot; empty: another robot, whose
/// port the doctor finds as in a terminal.
[[nodiscard]] DoctorCommand doctorCommand(const RobotChoice& choice, const std::string& program,
                                          const std::string& own_port);

/// As text in a shell: "darwinop doctor --robot /tmp/robot".
[[nodiscard]] std::string typedCommand(const DoctorCommand& command);

}  // namespace darwinop::window
