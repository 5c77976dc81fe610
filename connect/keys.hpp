// Keyboard input for a controller: from a window, else from its terminal.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "hal/keyboard.hpp"

namespace darwinop::connect {

// Parts of the messages about keys, without reason and remedy.
inline constexpr const char* kKeysFromTerminal = "keys are read from this terminal";
inline constexpr const char* kNoKeys = "no key is ever pressed";
inline constexpr const char* kKeyWindowClosed = "its window was closed";
inline constexpr const char* kKeyServerGone = "the X server is gone";

struct KeysRequest {
  /// "window", "terminal" or "none"; empty: a window if possible, else the terminal.
  std::string from;
  /// Value of DISPLAY.
  std::string display;
  /// Receives one message if keys do not come from a window, if there are none, and when input ends. Called from
  /// another thread.
  std::function<void(const std::string&)> log = {};
};

/// Opens the input in a separate thread, so this does not wait for a slow X server. `ending` becomes true when the user
/// requests the controller to end; it must outlive all threads. Throws std::runtime_error if `from` is invalid.
std::unique_ptr<KeySource> openKeys(KeysRequest request, const std::atomic<bool>& ending);

}  // namespace darwinop::connect
