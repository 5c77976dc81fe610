// Priority, locked memory and protection of the supervisor's process.
#pragma once

#include <string>

namespace darwinop::supervisor {

/// Above the loop's SCHED_FIFO 80, so that a loop that spins cannot keep the one away who is to end it, and below the
/// kernel's own watchdogs (99). A look every 20 ms takes 60 us (debug build on a PC, virtual robot, 2026-11; not
/// measured on an Atom), far less than the loop has to spare.
inline constexpr int kWatchPriority = 85;

/// Of the calling thread and its process. Returns what was refused, a sentence; empty: nothing.
std::string standFast();
/// An ordinary thread again: for the rescue, whose own loop takes a priority for itself. The runtime is dead then, and
/// threads that are made must not inherit the priority of a watch.
void standDown();

}  // namespace darwinop::supervisor
