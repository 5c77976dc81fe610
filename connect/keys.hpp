// Keys for a controller: from a window, or else from its terminal.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "hal/keyboard.hpp"

namespace darwinop::connect {

// What the messages about keys say, with the reason or the remedy around it.
inline constexpr const char* kKeysFromTerminal = "keys are read from this terminal";
inline constexpr const char* kNoKeys = "no key is ever pressed";
inline constexpr const char* kKeyWindowClosed = "its window was closed";
inline constexpr const char* kKeyServerGone = "the X server is gone";

struct KeysRequest {
  /// "window", "terminal" or "none"; empty: a window, or a terminal where there can be none.
  std::string from;
  /// The text of DISPLAY.
  std::string display;
  /// Receives one message if keys come from elsewhere than a window, if there are none, and when they end. From another
  /// thread.
  std::function<void(const std::string&)> log = {};
};

/// A thread of its own looks for keys, so this does not wait for an X server that is slow. `ending` becomes true when
/// the user asks the controller to end; it must outlive the process' threads. Throws std::runtime_error when `from` is
/// something else.
std::unique_ptr<KeySource> openKeys(KeysRequest request, const std::atomic<bool>& ending);

}  // namespace darwinop::connect
