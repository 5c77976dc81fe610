// The bounded send queue of a slow peer.
#include "hal/net/web/send_queue.hpp"

#include <gtest/gtest.h>

namespace darwinop::web {
namespace {

OutgoingMessage message(Lane lane, const std::string& text) {
  return {lane, false, std::make_shared<const std::string>(text)};
}

std::string takeAll(SendQueue& queue) {
  std::string all;
  while (const auto taken = queue.take()) all += *taken->bytes + " ";
  return all;
}

TEST(WebSendQueue, ReplacesAMessageOfTheSameLaneInPlace) {
  SendQueue queue;
  queue.put(message(1, "state1"));
  queue.put(message(2, "picture1"));
  queue.put(message(1, "state2"));
  EXPECT_EQ(queue.lost(), 1u);
  EXPECT_EQ(takeAll(queue), "state2 picture1 ");
}

TEST(WebSendQueue, KeepsAtMostMaxOfEveryMessagesThatDoNotReplaceEachOther) {
  SendQueue queue;
  queue.put(message(0, "who"));
  for (std::size_t i = 0; i < SendQueue::kMaxOfEvery + 2; ++i) queue.put(message(kEvery, std::to_string(i)));
  EXPECT_EQ(queue.size(), SendQueue::kMaxOfEvery + 1);
  EXPECT_EQ(queue.lost(), 2u);
  EXPECT_EQ(takeAll(queue).substr(0, 8), "who 2 3 ");
}

TEST(WebSendQueue, HoldsAtMostOneMessageOfEachLane) {
  SendQueue queue;
  for (int i = 0; i < 10'000; ++i) queue.put(message(static_cast<Lane>(i * 7 % 11), "x"));
  EXPECT_LE(queue.size(), SendQueue::kMaxOfEvery + kLanes);
}

TEST(WebSendQueue, DiscardsQueuedMessagesWithoutCountingThemAsLost) {
  SendQueue queue;
  queue.put(message(1, "state"));
  queue.put(message(kEvery, "notice"));
  queue.discardQueued();
  EXPECT_EQ(queue.lost(), 0u);
  EXPECT_EQ(takeAll(queue), "notice ");
}

}  // namespace
}  // namespace darwinop::web
