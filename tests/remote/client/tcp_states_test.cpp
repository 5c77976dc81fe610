// The connection states of TcpLink against a literal table of every state and event.
#include "remote/client/tcp_states.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace darwinop::remote {
namespace {

using enum TcpState;

// Rows: states in order; columns: reply reply_late connection_lost leave_holding.
constexpr std::array<std::array<TcpState, kTcpEvents>, kTcpStates> kTable{{
    {kOnline, kFirstContact, kLost, kFirstContact},
    {kOnline, kLate, kLost, kLeft},
    {kOnline, kLate, kLost, kLeft},
    {kOnline, kLost, kLost, kLost},
    {kOnline, kLeft, kLost, kLeft},
}};

TEST(TcpStates, EveryPairOfStateAndEventLeadsWhereTheTableSays) {
  for (std::size_t s = 0; s < kTcpStates; ++s)
    for (std::size_t e = 0; e < kTcpEvents; ++e)
      EXPECT_EQ(next(static_cast<TcpState>(s), static_cast<TcpEvent>(e)), kTable[s][e])
          << kTcpStateNames[s] << " + " << kTcpEventNames[e];
}

TEST(TcpStates, EveryStateCanBeLeftAndAReplyConnects) {
  for (std::size_t s = 0; s < kTcpStates; ++s) {
    std::set<TcpState> reached;
    for (std::size_t e = 0; e < kTcpEvents; ++e)
      reached.insert(next(static_cast<TcpState>(s), static_cast<TcpEvent>(e)));
    EXPECT_GE(reached.size(), 2U) << kTcpStateNames[s];
    EXPECT_TRUE(isConnected(next(static_cast<TcpState>(s), TcpEvent::kReply))) << kTcpStateNames[s];
    EXPECT_FALSE(isConnected(next(static_cast<TcpState>(s), TcpEvent::kConnectionLost))) << kTcpStateNames[s];
  }
}

}  // namespace
}  // namespace darwinop::remote
