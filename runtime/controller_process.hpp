// The process of a controller under `darwinop run`: signals, and its end after the terminal was closed.
#pragma once

#include <chrono>
#include <functional>

#include "hal/process/ending.hpp"
#include "hal/process/start.hpp"

namespace darwinop::runtime {

/// A closed terminal (SIGHUP) sends no second Ctrl-C. A controller that has not ended after `grace`,
/// or once its joints have no torque if that is later, gets SIGINT, and SIGKILL after `last_grace`.
struct HangUp {
  std::chrono::milliseconds grace{10'000};
  std::chrono::milliseconds last_grace{3'000};
};

/// Runs it to its end. Ending signals that other processes send to this process are forwarded to it. `keeps_torque`:
/// whether joints might keep torque if the process were killed now.
process::Ending runControllerProcess(const process::Start& start, const HangUp& hang_up,
                                     const std::function<bool()>& keeps_torque);

}  // namespace darwinop::runtime
