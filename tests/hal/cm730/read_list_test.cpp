// Isolation of silent servos: who is asked, in what order, and how soon a returning one is back.
#include "hal/cm730/read_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace darwinop::cm730 {
namespace {

constexpr Nanos kRound{16'000'000};

/// Devices on a daisy chain of replies: a dead one silences all behind it in the list.
struct Chain {
  ReadList list{kRound};
  ReadList::Mask dead;
  ReadList::Mask answered;
  std::vector<int> order;

  void cycle() {
    answered.reset();
    order.clear();
    bool broken = false;
    for (const auto entry : list.next()) {
      order.push_back(entry.joint);
      if (dead[entry.joint]) broken = true;
      if (!broken) answered.set(entry.joint);
    }
    list.answered(answered);
  }
  void cycles(int n) {
    for (int i = 0; i < n; ++i) cycle();
  }
};

TEST(ReadList, ReadsAllTwentyInIdOrderNormally) {
  Chain chain;
  chain.cycle();
  ASSERT_EQ(chain.order.size(), kJoints);
  EXPECT_TRUE(std::ranges::is_sorted(chain.order));
}

TEST(ReadList, NeverReadsAnAbsentServoAndDoesNotCountItAsSilent) {
  ReadList list{kRound, kJoints, ReadList::Mask{}.set(3).set(19)};
  for (int cycle = 0; cycle < 200; ++cycle) {
    ReadList::Mask answered;
    for (const auto entry : list.next()) {
      EXPECT_TRUE(entry.joint != 3 && entry.joint != 19);
      answered.set(entry.joint);
    }
    EXPECT_EQ(answered.count(), kJoints - 2);
    list.answered(answered);
  }
  EXPECT_TRUE(list.silent().none());
}

TEST(ReadList, PollsEveryServoWithinTwentyCycles) {
  ReadList list{kRound};
  ReadList::Mask seen;
  for (std::size_t i = 0; i < kJoints; ++i) {
    int polls = 0;
    for (const auto entry : list.next()) {
      if (entry.poll) seen.set(entry.joint), ++polls;
    }
    EXPECT_EQ(polls, 1);
    list.answered(ReadList::Mask{}.set());
  }
  EXPECT_TRUE(seen.all());
}

class DeadServo : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(AnywhereInTheChain, DeadServo, ::testing::Range(std::size_t{0}, kJoints));

TEST_P(DeadServo, AffectsOthersForOneCycleOnly) {
  Chain chain;
  chain.cycles(5);
  chain.dead.set(GetParam());
  chain.cycle();  // the one that is lost
  for (int i = 0; i < 500; ++i) {
    chain.cycle();
    EXPECT_EQ(chain.answered, ~chain.dead) << "cycle " << i;
  }
  EXPECT_TRUE(chain.list.silent()[GetParam()]);
}

TEST_P(DeadServo, IsBackWithinASecondOfItsReturn) {
  Chain chain;
  chain.dead.set(GetParam());
  chain.cycles(100);
  chain.dead.reset();
  int cycles = 0;
  while (!chain.answered[GetParam()]) {
    chain.cycle();
    ASSERT_LT(++cycles, 1'000'000'000 / kRound.count());
  }
  EXPECT_TRUE(chain.list.silent().none());
}

TEST(ReadList, SixServosBehindABrokenLeadAreAllBackWithinASecond) {
  Chain chain;
  for (int i = 6; i < 12; ++i) chain.dead.set(static_cast<std::size_t>(i));
  chain.cycles(200);
  EXPECT_EQ(chain.list.silent(), chain.dead);
  chain.dead.reset();
  chain.cycles(static_cast<int>(1'000'000'000 / kRound.count()));
  EXPECT_TRUE(chain.list.silent().none());
}

TEST(ReadList, AChainWithoutSupplyAffectsOthersForOneCycleOnly) {
  for (const darwinop::Chain which : {darwinop::Chain::kRightArm, darwinop::Chain::kLeftArm, darwinop::Chain::kHead,
                                      darwinop::Chain::kRightLeg, darwinop::Chain::kLeftLeg}) {
    Chain chain;
    chain.cycles(5);
    for (std::size_t i = 0; i < kJoints; ++i) chain.dead[i] = kJointTable[i].chain == which;
    chain.cycle();  // the one that is lost
    for (int i = 0; i < 100; ++i) {
      chain.cycle();
      EXPECT_EQ(chain.answered, ~chain.dead) << "cycle " << i;
    }
    EXPECT_EQ(chain.list.silent(), chain.dead);
  }
}

TEST(ReadList, AServoIsPolledAtItsFirstReplyAfterALoss) {
  ReadList list{kRound};
  list.next();
  list.answered(~ReadList::Mask{}.set(4).set(11));
  int polls = 0;
  for (const auto entry : list.next()) {
    polls += entry.poll ? 1 : 0;
    EXPECT_TRUE(entry.poll || (entry.joint != 4 && entry.joint != 11));
  }
  EXPECT_LE(polls, 3);
  list.answered(ReadList::Mask{}.set());
  polls = 0;
  for (const auto entry : list.next()) polls += entry.poll ? 1 : 0;
  EXPECT_EQ(polls, 1) << "once";
}

TEST(ReadList, AfterALostBoardReplyAllAreRecheckedAsFastAsThePeriodAllows) {
  for (const std::size_t most : {std::size_t{4}, kJoints}) {
    ReadList list{kRound, most};
    list.next();
    list.missedAll();
    ReadList::Mask polled;
    for (std::size_t cycle = 0; cycle < kJoints / most; ++cycle) {
      std::size_t polls = 0;
      for (const auto entry : list.next()) {
        if (!entry.poll) continue;
        polled.set(entry.joint);
        ++polls;
      }
      EXPECT_LE(polls, most + 1);
      list.answered(ReadList::Mask{}.set());
    }
    EXPECT_TRUE(polled.all());
  }
}

TEST(ReadList, OneDamagedFrameDoesNotChangeTheOrder) {
  ReadList list{kRound};
  list.next();
  list.answered(~ReadList::Mask{}.set(4));  // its neighbours received it: only our copy was damaged
  EXPECT_TRUE(list.silent().none());
  EXPECT_EQ(list.next()[4].joint, 4);
}

TEST(ReadList, AnIntermittentServoAffectsOnlyItself) {
  Chain chain;
  int others_lost = 0;
  for (int i = 0; i < 1000; ++i) {
    chain.dead.set(3, i % 3 == 0);
    chain.cycle();
    if ((chain.answered | ReadList::Mask{}.set(3)).count() < kJoints) ++others_lost;
  }
  EXPECT_EQ(others_lost, 1);
}

TEST(ReadList, NoServoIsReadWithoutServoPowerAndForATimeAfter) {
  ReadList list{kRound};
  list.next();
  list.powerIsOff();
  EXPECT_TRUE(list.next().empty());
  int cycles = 0;
  while (list.next().empty()) {
    list.powerIsOn();
    ASSERT_LT(++cycles, 100);
  }
  EXPECT_GE(cycles * kRound, Nanos{300'000'000});
  EXPECT_EQ(list.next().size(), kJoints);
}

}  // namespace
}  // namespace darwinop::cm730
