// `darwinop run`: starts a controller, hands signals on, and reports how the loop fared.
#pragma once

#include <string>
#include <vector>

namespace darwinop::runtime {

struct RunRequest {
  std::vector<std::string> command;  // controller and its arguments; a folder means the program of its name in it
  std::string robot;                 // empty: as the environment says
  std::string record;                // empty: no recording
  std::string period_ms;             // empty: as the controller's config.ini says
};

/// The program that `controller` means. Throws std::runtime_error that says what was looked for.
std::string controllerProgram(const std::string& controller);

/// Runs it to its end. Prints the report; the last line is the stable one. Returns the exit status for the shell:
/// the controller's, or 128 + signal.
int runController(const RunRequest& request);

}  // namespace darwinop::runtime
