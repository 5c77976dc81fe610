// Guards of the calls that Python makes into the API.
#pragma once

#include <pybind11/pybind11.h>

#include <mutex>

namespace darwinop::python {

/// Held during a call into the API, which is not thread-safe: Python threads take turns. Throws std::runtime_error,
/// RuntimeError in Python, while there is no robot: devices live as long as it.
class ApiCall {
 public:
  ApiCall();
  ~ApiCall() = default;
  ApiCall(const ApiCall&) = delete;
  ApiCall& operator=(const ApiCall&) = delete;

 private:
  std::unique_lock<std::recursive_mutex> turn_;
};

/// Waits for its turn; the interpreter runs other threads meanwhile, so that the one whose turn it is can end it.
std::unique_lock<std::recursive_mutex> takeTurn();

/// For calls that return at once.
inline constexpr pybind11::call_guard<ApiCall> kQuick{};
/// For calls that may wait: other Python threads run meanwhile.
inline constexpr pybind11::call_guard<ApiCall, pybind11::gil_scoped_release> kWaiting{};

/// Ends the session, which brings the robot to rest and may take seconds. Without effect when it has ended.
void endSession();

}  // namespace darwinop::python
