// Ctrl-C in a Python controller: the first one makes Robot.step() return -1, as in C++; the second one raises
// KeyboardInterrupt, so that it also ends a controller that does not look at step().
#pragma once

namespace darwinop::python {

/// Puts our handler of SIGINT in front of that of webots/stop_signals.hpp. A third Ctrl-C, and a second one after
/// Python's end, are the latter's second one: they kill the process. An ignored SIGINT stays ignored.
void installInterrupt();

}  // namespace darwinop::python
