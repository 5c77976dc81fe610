// Starts and ends `darwinop run` as a child process.
#include "twin/view/controller_process.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>

namespace darwinop::twin {
namespace {

constexpr std::chrono::milliseconds kGrace{2000};

process::Start startOf(const std::vector<std::string>& controller, const std::string& port) {
  const std::string program = process::programBeside("darwinop-run");
  if (access(program.c_str(), X_OK) != 0)
    throw std::runtime_error("cannot start the controller: " + program + " is not installed");
  process::Start start{
      .command = {program, "--robot", port, "--"}, .ends_with_us = true, .keeps_ignored_signals = true};
  start.command.insert(start.command.end(), controller.begin(), controller.end());
  return start;
}

}  // namespace

ControllerProcess::ControllerProcess(const std::vector<std::string>& controller, const std::string& port)
    : process_{startOf(controller, port)} {}

ControllerProcess::~ControllerProcess() {
  signal(SIGTERM);
  (void)process_.waitOrKill(kGrace);
}

std::optional<int> ControllerProcess::ended() {
  const std::optional<process::Ending> ending = process_.ended();
  return ending ? std::optional{ending->shellStatus()} : std::nullopt;
}

}  // namespace darwinop::twin
