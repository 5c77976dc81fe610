// Clients shared by several tests: one that floods the server, and a next one that makes a single request.
#pragma once

#include "remote/protocol/examples.hpp"
#include "served.hpp"

namespace darwinop::remote {

/// Sends many requests at once and lets the server handle events.
inline void flood(Served& served, TestClient& client, const char* request, int times) {
  const ByteList one = fromHex(request);
  ByteList all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), one.begin(), one.end());
  client.send(all);
  served.poll(100);
}

inline bool nextIsAnswered(Served& served) {
  return TestClient{served}.ask(kEmptyRequest) == kEmptyReply;
}

}  // namespace darwinop::remote
