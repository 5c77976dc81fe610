// How the robot of this window is checked.
#include "window/doctor/doctor_command.hpp"

#include "window/messages.hpp"

namespace darwinop::window {

DoctorCommand doctorCommand(const RobotChoice& choice, const std::string& program, const std::string& own_port) {
  DoctorCommand command{.program = program};
  if (!own_port.empty()) command.arguments = {"--robot", own_port};
  if (!choice.logged_in_to.empty()) {
    command.elsewhere =
        messages::kDoctorElsewhere + ("`ssh " + choice.logged_in_to + ' ') + messages::kDoctorThere + '`';
  } else if (isRemote(choice)) {
    command.elsewhere = std::string{messages::kDoctorElsewhere} + '`' + messages::kDoctorThere + '`';
  }
  return command;
}

std::string typedCommand(const DoctorCommand& command) {
  std::string text = "darwinop doctor";
  for (const std::string& word : command.arguments) text += ' ' + word;
  return text;
}

}  // namespace darwinop::window
