// What a controller asks for that a daemon does not do for it.
#pragma once

#include <string>

#include "connect/connect.hpp"

namespace darwinop::connect {

/// Settings of [Safety] or [Limits] are given.
bool asksForSafety(const safety::Config& config);

/// The daemon has a period and a recording of its own. One line for each request it does not grant, with what to do;
/// empty: none.
std::string daemonWarnings(const Request& request, Nanos daemons_period);

/// The same of a robot over TCP, whose loop runs on the other computer.
std::string tcpWarnings(const Request& request, Nanos robots_period);

}  // namespace darwinop::connect
