// `darwinop run`: starts a controller, forwards signals to it, and reports the loop's timing statistics.
#pragma once

#include <string>
#include <vector>

#include "runtime/controller_process.hpp"

namespace darwinop::runtime {

struct RunRequest {
  std::vector<std::string> command;  // controller and its arguments; of a folder, the program with the folder's name
  std::string robot;                 // empty: as set in the environment
  std::string record;                // CSV file; empty: no recording
  std::string period_ms;             // empty: as set in the controller's config.ini
  std::string python_modules = {};   // their folder, for a controller NAME.py
  HangUp hang_up = {};
};

/// Path of the program for `controller`, a program, a Python script NAME.py or a folder. Throws std::runtime_error with
/// the path that was tried.
std::string controllerProgram(const std::string& controller);

/// Runs the controller to its end and prints the report; its last line has a stable format (reportLine()). Returns the
/// exit status for the shell: the controller's, or 128 + signal; never 0 if joints may have torque without a loop.
int runController(const RunRequest& request);

}  // namespace darwinop::runtime
