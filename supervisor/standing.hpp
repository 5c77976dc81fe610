// Priority, memory locking and OOM protection of the supervisor.
#pragma once

#include <string>

namespace darwinop::supervisor {

/// Above the loop's SCHED_FIFO 80, so that a spinning loop cannot starve the supervisor, and below the kernel's
/// watchdogs (99). A check every 20 ms takes 60 us (debug build on a PC, virtual robot, 2026-11; not measured on an
/// Atom), far below the loop's slack.
inline constexpr int kWatchPriority = 85;

/// Applies to the calling thread and its process. Returns what was refused as a message; empty: nothing.
std::string standFast();
/// Back to normal priority, for the rescue, whose own loop sets its priority. The runtime is dead then, and new threads
/// must not inherit the supervisor's priority.
void standDown();

}  // namespace darwinop::supervisor
