// Warnings about requests of a controller that a daemon or a remote robot ignores.
#pragma once

#include <string>

#include "connect/connect.hpp"

namespace darwinop::connect {

/// True if `config` has settings of [Safety] or [Limits].
bool asksForSafety(const safety::Config& config);

/// The daemon has its own period and recording. One line per request that it ignores, with a remedy; empty: none.
std::string daemonWarnings(const ConnectRequest& request, Nanos daemons_period);

/// The same for a robot over TCP, whose loop runs on the other computer.
std::string tcpWarnings(const ConnectRequest& request, Nanos robots_period);

}  // namespace darwinop::connect
