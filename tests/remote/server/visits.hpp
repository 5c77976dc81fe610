// Clients of several tests: one that floods the server, and one who comes next and only wants an answer.
#pragma once

#include "remote/protocol/examples.hpp"
#include "served.hpp"

namespace darwinop::remote {

/// Many requests at once; the server gets its turns.
inline void flood(Served& served, TestClient& client, const char* request, int times) {
  const ByteList one = fromHex(request);
  ByteList all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), one.begin(), one.end());
  client.send(all);
  served.attend(100);
}

inline bool nextIsAnswered(Served& served) {
  return TestClient{served}.ask(kEmptyRequest) == kEmptyReply;
}

}  // namespace darwinop::remote
