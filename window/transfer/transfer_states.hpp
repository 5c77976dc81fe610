// States of the transfer as a pure function.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::window {

enum class TransferState : std::uint8_t {
  kIdle,        // no run so far, or the last one could not be started
  kRunning,     // the installer runs
  kCancelling,  // interrupted: it completes or rolls back its work
  kEnded,       // all its output has been read
  kCancelled,   // the same after an interrupt
  kCount
};
inline constexpr std::size_t kTransferStates = static_cast<std::size_t>(TransferState::kCount);
inline constexpr std::array<std::string_view, kTransferStates> kTransferStateNames{"idle", "running", "cancelling",
                                                                                   "ended", "cancelled"};

enum class TransferEvent : std::uint8_t { kStarted, kNotStarted, kCancelAsked, kExited, kCount };
inline constexpr std::size_t kTransferEvents = static_cast<std::size_t>(TransferEvent::kCount);
inline constexpr std::array<std::string_view, kTransferEvents> kTransferEventNames{"started", "not_started",
                                                                                   "cancel_asked", "exited"};

/// One run at a time: no other starts meanwhile.
constexpr bool runs(TransferState state) {
  return state == TransferState::kRunning || state == TransferState::kCancelling;
}

/// A page has cancelled the present or the last run.
constexpr bool isCancelled(TransferState state) {
  return state == TransferState::kCancelling || state == TransferState::kCancelled;
}

/// The state after `event` in `state`.
constexpr TransferState next(TransferState state, TransferEvent event) {
  if (event == TransferEvent::kStarted) return runs(state) ? state : TransferState::kRunning;
  if (event == TransferEvent::kNotStarted) return runs(state) ? state : TransferState::kIdle;
  if (event == TransferEvent::kCancelAsked) return runs(state) ? TransferState::kCancelling : state;
  if (!runs(state)) return state;
  return isCancelled(state) ? TransferState::kCancelled : TransferState::kEnded;
}

}  // namespace darwinop::window
