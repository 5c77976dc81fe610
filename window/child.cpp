// Start and end of the window's child processes.
#include "window/child.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace darwinop::window {
namespace {

// A background child has its own process group, so that Ctrl-C in the terminal does not reach it: it is ended in order.
// A captured child has its own session, so that ssh cannot ask questions on the terminal, and none of our descriptors,
// such as connections of browsers.
process::Start startOf(const std::string& program, const std::vector<std::string>& arguments, Child::Stdio stdio,
                       char* secret, std::vector<std::string> environment) {
  using process::Start;
  using process::Stream;
  if (access(program.c_str(), X_OK) != 0)
    throw std::runtime_error("cannot run " + program + ": " + std::strerror(errno) +
                             "; the window requires it, install it as well");
  Start start{.command = {program},
              .environment = std::move(environment),
              .without_variable = "DARWINOP_PASSWORD",  // of our own login
              .secret = secret,
              .ends_with_us = true,
              .keeps_ignored_signals = true};
  start.command.insert(start.command.end(), arguments.begin(), arguments.end());
  if (stdio == Child::Stdio::kBackground) {
    start.streams = {Stream::nothing(), Stream::nothing()};
    start.group = Start::Group::kItsOwn;
  }
  if (stdio == Child::Stdio::kCaptured) {
    start.streams = {Stream::nothing(), Stream::pipe(), Stream::pipe(), Stream::pipe()};
    start.group = Start::Group::kItsOwnSession;
    start.closes_others = true;
    start.keeps_ignored_signals = false;
  }
  return start;
}

}  // namespace

Child::Child(std::string noun, const std::string& program, const std::vector<std::string>& arguments,
             std::chrono::milliseconds grace, Stdio stdio, char* secret, std::vector<std::string> environment)
    : noun_{std::move(noun)},
      grace_{grace},
      stdio_{stdio},
      process_{startOf(program, arguments, stdio, secret, std::move(environment))} {
  for (std::size_t i = 0; i < kStreams; ++i)
    if (stream(i) >= 0) fcntl(stream(i), F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  stdio_ == Stdio::kCaptured ? process_.signalGroup(SIGINT) : process_.signal(SIGTERM);
  (void)process_.waitOrKill(grace_);  // not its group: processes that are still cleaning up end by themselves
}

std::optional<int> Child::ended() {
  const std::optional<process::Ending> ending = process_.ended();
  return ending ? std::optional{ending->shellStatus()} : std::nullopt;
}

}  // namespace darwinop::window
