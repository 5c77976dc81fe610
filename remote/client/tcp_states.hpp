// Connection states of TcpLink as a pure function. The server's properties, the times of a loss and the last request
// are data of TcpLink: they persist across states, and no transition depends on them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::remote {

enum class TcpState : std::uint8_t {
  kFirstContact,  // no reply so far
  kOnline,        // the last reply was in time
  kLate,          // connected, but the present reply has missed its grace period
  kLost,          // disconnected, or connected again without a reply so far
  kLeft,          // connected, but left without end of session: the robot holds
  kCount
};
inline constexpr std::size_t kTcpStates = static_cast<std::size_t>(TcpState::kCount);
inline constexpr std::array<std::string_view, kTcpStates> kTcpStateNames{"first_contact", "online", "late", "lost",
                                                                         "left"};

enum class TcpEvent : std::uint8_t {
  kReply,           // a reply has been received
  kReplyLate,       // a reply has missed its grace period
  kConnectionLost,  // the connection has been closed, by either side
  kLeaveHolding,    // the session is left without its end
  kCount
};
inline constexpr std::size_t kTcpEvents = static_cast<std::size_t>(TcpEvent::kCount);
inline constexpr std::array<std::string_view, kTcpEvents> kTcpEventNames{"reply", "reply_late", "connection_lost",
                                                                         "leave_holding"};

/// The present connection has had a reply.
constexpr bool isConnected(TcpState state) {
  return state == TcpState::kOnline || state == TcpState::kLate || state == TcpState::kLeft;
}

/// The state after `event` in `state`.
constexpr TcpState next(TcpState state, TcpEvent event) {
  if (event == TcpEvent::kReply) return TcpState::kOnline;
  if (event == TcpEvent::kConnectionLost) return TcpState::kLost;
  if (event == TcpEvent::kLeaveHolding) return isConnected(state) ? TcpState::kLeft : state;
  return state == TcpState::kOnline ? TcpState::kLate : state;
}

static_assert(next(TcpState::kLost, TcpEvent::kReplyLate) == TcpState::kLost, "only a reply ends a loss");

}  // namespace darwinop::remote
