// The states of the transfer against a literal table of every state and event.
#include "window/transfer/transfer_states.hpp"

#include <gtest/gtest.h>

#include <array>

namespace darwinop::window {
namespace {

using enum TransferState;

// Rows: states in order; columns: started not_started cancel_asked exited.
constexpr std::array<std::array<TransferState, kTransferEvents>, kTransferStates> kTransferTable{{
    {kRunning, kIdle, kIdle, kIdle},
    {kRunning, kRunning, kCancelling, kEnded},
    {kCancelling, kCancelling, kCancelling, kCancelled},
    {kRunning, kIdle, kEnded, kEnded},
    {kRunning, kIdle, kCancelled, kCancelled},
}};

TEST(TransferStates, EveryPairOfStateAndEventLeadsWhereTheTableSays) {
  for (std::size_t s = 0; s < kTransferStates; ++s)
    for (std::size_t e = 0; e < kTransferEvents; ++e)
      EXPECT_EQ(next(static_cast<TransferState>(s), static_cast<TransferEvent>(e)), kTransferTable[s][e])
          << kTransferStateNames[s] << " + " << kTransferEventNames[e];
}

TEST(TransferStates, OnlyARunCanBeCancelledAndStaysSo) {
  for (std::size_t s = 0; s < kTransferStates; ++s) {
    const auto state = static_cast<TransferState>(s);
    const TransferState cancelled = next(state, TransferEvent::kCancelAsked);
    EXPECT_EQ(isCancelled(cancelled), runs(state) || isCancelled(state)) << kTransferStateNames[s];
    EXPECT_EQ(isCancelled(next(cancelled, TransferEvent::kExited)), isCancelled(cancelled)) << kTransferStateNames[s];
  }
}

}  // namespace
}  // namespace darwinop::window
