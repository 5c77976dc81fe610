// Connects to the X server named by DISPLAY.
#pragma once

#include <xcb/xcb.h>

#include <memory>
#include <string>

namespace darwinop::x11 {

inline constexpr const char* kDisplayNotSet = "DISPLAY is not set";

/// "[host]:number[.screen]". No host: a Unix socket.
struct DisplayName {
  std::string host;
  int number = 0, screen = 0;
  bool operator==(const DisplayName&) const = default;
};

/// Throws std::runtime_error.
[[nodiscard]] DisplayName parseDisplay(const std::string& text);

struct Disconnect {
  void operator()(xcb_connection_t* connection) const { xcb_disconnect(connection); }
};
using Connection = std::unique_ptr<xcb_connection_t, Disconnect>;

/// Throws std::runtime_error with the reason. The socket is opened here, not by libxcb: a static program cannot resolve
/// host names, and libxcb's resolver must not be linked. TCP timeout: 3 s.
[[nodiscard]] Connection connectTo(const DisplayName& display);

}  // namespace darwinop::x11
