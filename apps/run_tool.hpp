// Runs a program that drives a robot, and turns what it throws into its exit code.
#pragma once

#include <exception>
#include <iostream>

#include "exit_codes.hpp"
#include "webots/stop_signals.hpp"
#include "webots/tool_robot.hpp"

namespace darwinop::app {

/// Exit code of `command`. `program`: "darwinop motion", before the message.
template <class Command>
int runTool(const char* program, const Command& command) {
  const auto print = [program](const std::exception& error) { std::cerr << program << ": " << error.what() << '\n'; };
  try {
    return command();
  } catch (const webots_api::EndedBeforeReady& error) {
    print(error);
    return webots_api::stopRequested() ? kStopped : kFailed;
  } catch (const std::exception& error) {
    print(error);
    return kWrong;
  }
}

}  // namespace darwinop::app
