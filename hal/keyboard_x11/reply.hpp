// Replies of the X server.
#pragma once

#include <poll.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include <chrono>
#include <cstdlib>
#include <memory>

namespace darwinop::x11 {

struct Free {
  void operator()(void* reply) const { std::free(reply); }
};
template <class T>
using Reply = std::unique_ptr<T, Free>;

/// The reply to a request; none if the server does not answer within half a second: over a stalled network a wait
/// without end would leave keys pressed.
template <class T>
Reply<T> replyInTime(xcb_connection_t* connection, unsigned sequence) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::milliseconds{500};
  ::xcb_flush(connection);
  for (;;) {
    void* reply = nullptr;
    xcb_generic_error_t* error = nullptr;
    const bool answered = ::xcb_poll_for_reply(connection, sequence, &reply, &error) != 0;
    std::free(error);
    if (answered) return Reply<T>{static_cast<T*>(reply)};
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0 || ::xcb_connection_has_error(connection) != 0) break;
    pollfd file{::xcb_get_file_descriptor(connection), POLLIN, 0};
    ::poll(&file, 1, static_cast<int>(left.count()));
  }
  ::xcb_discard_reply(connection, sequence);
  return {};
}

}  // namespace darwinop::x11
