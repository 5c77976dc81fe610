// Warnings about ignored requests of a controller.
#include "connect/daemon_warnings.hpp"

#include <string>

#include "safety/layers.hpp"

namespace darwinop::connect {
namespace {

std::string milliseconds(Nanos time) {
  std::string text = std::to_string(std::chrono::duration<double, std::milli>(time).count());
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

bool asksForSafety(const safety::Config& config) {
  return config.named.any() || safety::numbers(config) != safety::numbers(safety::Config{});
}

std::string daemonWarnings(const ConnectRequest& request, Nanos daemons_period) {
  std::string text;
  if (!request.record_path.empty())
    text += "darwinop: " + request.record_path +
            " is not written: the loop runs in the daemon, which records by itself: darwinop runtime --record FILE\n";
  if (request.period && *request.period != daemons_period)
    text += "darwinop: the daemon's period of " + milliseconds(daemons_period) + " ms holds, not the " +
            milliseconds(*request.period) + " ms asked for; restart it with: darwinop runtime --period " +
            milliseconds(*request.period) + "\n";
  return text;
}

std::string tcpWarnings(const ConnectRequest& request, Nanos robots_period) {
  std::string text;
  if (!request.record_path.empty())
    text += "darwinop: " + request.record_path +
            " is not written: the loop runs on the robot, whose daemon records there: darwinop runtime --record FILE\n";
  if (request.period && *request.period != robots_period)
    text += "darwinop: the robot's period of " + milliseconds(robots_period) + " ms holds, not the " +
            milliseconds(*request.period) + " ms asked for\n";
  return text;
}

}  // namespace darwinop::connect
