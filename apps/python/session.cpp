// Guards of the calls that Python makes into the API.
#include "apps/python/session.hpp"

#include <stdexcept>

#include "apps/python/messages.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::python {

namespace {
std::recursive_mutex turns;  // recursive: a garbage collection during a call may run a __del__ that calls
}

std::unique_lock<std::recursive_mutex> takeTurn() {
  std::unique_lock turn{turns, std::try_to_lock};
  if (!turn) {
    const pybind11::gil_scoped_release others_run;
    turn.lock();
  }
  return turn;
}

ApiCall::ApiCall() : turn_{takeTurn()} {
  if (webots_api::currentRobot() == nullptr) throw std::runtime_error(messages::kNoRobot);
}

void endSession() {
  const auto turn = takeTurn();
  const pybind11::gil_scoped_release others_run;
  webots_api::release(webots_api::currentRobot());
}

}  // namespace darwinop::python
