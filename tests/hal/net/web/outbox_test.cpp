// What waits for a slow peer.
#include "hal/net/web/outbox.hpp"

#include <gtest/gtest.h>

namespace darwinop::web {
namespace {

Parcel parcel(Lane lane, const std::string& text) {
  return {lane, false, std::make_shared<const std::string>(text)};
}

std::string takeAll(Outbox& outbox) {
  std::string all;
  while (const auto taken = outbox.take()) all += *taken->bytes + " ";
  return all;
}

TEST(WebOutbox, KeepsTheNewestOfALaneInTheTurnOfTheFirst) {
  Outbox outbox;
  outbox.put(parcel(1, "state1"));
  outbox.put(parcel(2, "picture1"));
  outbox.put(parcel(1, "state2"));
  EXPECT_EQ(outbox.lost(), 1u);
  EXPECT_EQ(takeAll(outbox), "state2 picture1 ");
}

TEST(WebOutbox, KeepsMessagesThatDoNotReplaceEachOtherUpToABound) {
  Outbox outbox;
  outbox.put(parcel(0, "who"));
  for (std::size_t i = 0; i < Outbox::kMostOfEvery + 2; ++i) outbox.put(parcel(kEvery, std::to_string(i)));
  EXPECT_EQ(outbox.size(), Outbox::kMostOfEvery + 1);
  EXPECT_EQ(outbox.lost(), 2u);
  EXPECT_EQ(takeAll(outbox).substr(0, 8), "who 2 3 ");
}

TEST(WebOutbox, NeverHoldsMoreThanOneOfEachLane) {
  Outbox outbox;
  for (int i = 0; i < 10'000; ++i) outbox.put(parcel(static_cast<Lane>(i * 7 % 11), "x"));
  EXPECT_LE(outbox.size(), Outbox::kMostOfEvery + kLanes);
}

TEST(WebOutbox, ForgetsWhatHasBecomeWrongWithoutCountingItAsLost) {
  Outbox outbox;
  outbox.put(parcel(1, "state"));
  outbox.put(parcel(kEvery, "notice"));
  outbox.forgetNewest();
  EXPECT_EQ(outbox.lost(), 0u);
  EXPECT_EQ(takeAll(outbox), "notice ");
}

}  // namespace
}  // namespace darwinop::web
