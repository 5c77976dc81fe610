// Without a board: the servo that is read first opens the exchange and carries the request tag.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "core/conversions.hpp"
#include "hal/cm730/read_list.hpp"
#include "hal/cm730/reply_decoder.hpp"
#include "hal/cm730/request_tag.hpp"

namespace darwinop::cm730 {
namespace {

using Entry = ReadList::Entry;

std::vector<std::uint8_t> pollOf(std::size_t bytes, std::uint16_t ticks) {
  std::vector<std::uint8_t> block(bytes, 0xEE);
  const std::size_t at = bytes - kServoPoll.count;  // of register 24
  for (std::size_t i = at; i < bytes; ++i) block[i] = 0;
  block[at] = 1;                                                      // 24 torque enable
  block[at + 12] = lowByte(ticks), block[at + 13] = highByte(ticks);  // 36
  block[at + 18] = 118;                                               // 42
  return block;
}

TEST(FirstServoTag, ItsLengthsAreThoseOfNoOtherServo) {
  RequestTag tag{false, false};
  std::set<int> calm, all;
  for (int i = 0; i < 40; ++i) {
    calm.insert(tag.bytes());
    const int before = tag.bytes();
    tag.note(false);
    EXPECT_NE(tag.bytes(), before);
  }
  for (int i = 0; i < 40; ++i) {
    all.insert(tag.bytes());
    tag.note(true);
  }
  EXPECT_EQ(calm, (std::set<int>{21, 22, 23, 24}));
  EXPECT_EQ(all.size(), 24U);
  for (const int bytes : all) {
    EXPECT_NE(bytes, kServoPoll.count);
    EXPECT_NE(bytes, kServoWindow.count);
    const RegisterWindow window = taggedPoll(static_cast<std::uint8_t>(bytes));
    EXPECT_EQ(window.address + window.count, kServoPoll.address + kServoPoll.count);
  }
}

struct FirstServo : ::testing::Test {
  std::array<Entry, 3> list{{{4, true}, {0, false}, {18, true}}};
  BusReadings readings{};
  ReplyDecoder decoder{{}, {}, {}, false};
  void SetUp() override { decoder.begin(list, 22, readings); }
  void take(std::uint8_t id, const std::vector<std::uint8_t>& params) { decoder.take(Frame{id, 0, params}); }
};

TEST_F(FirstServo, OpensTheExchangeAndIsPolled) {
  EXPECT_EQ(decoder.nextFrameBytes(), 22U + kFrameOverhead);
  take(5, pollOf(22, 1500));
  ASSERT_TRUE(decoder.firstAnswered());
  EXPECT_TRUE(readings.servos_answered);
  const ServoReading& servo = readings.servo[4];
  ASSERT_TRUE(servo.answered && servo.polled);
  EXPECT_TRUE(servo.torque_enabled);
  EXPECT_DOUBLE_EQ(servo.position.value, (1500 - 2048) * kRadPerTick);
  EXPECT_NEAR(servo.voltage.value, 11.8, 1e-9);
  EXPECT_FALSE(decoder.complete());
  take(1, std::vector<std::uint8_t>{0, 8, 0, 0, 0, 0});
  take(19, pollOf(20, 2048));
  EXPECT_TRUE(decoder.complete());
  EXPECT_EQ(decoder.answered().count(), 3U);
}

TEST_F(FirstServo, LateRepliesOfAnyServoOpenNothing) {
  take(5, pollOf(21, 1000));  // to the request before
  take(5, pollOf(20, 1000));  // to one in which it was polled
  take(5, std::vector<std::uint8_t>(6, 0));
  take(1, pollOf(22, 1000));  // another servo's turn as the first
  take(19, pollOf(22, 1000));
  take(200, std::vector<std::uint8_t>(22, 0));
  take(1, std::vector<std::uint8_t>(6, 0));
  EXPECT_FALSE(decoder.firstAnswered());
  EXPECT_FALSE(readings.servos_answered);
  EXPECT_TRUE(decoder.answered().none());
  EXPECT_EQ(decoder.lateReplies(), 7U);
}

TEST_F(FirstServo, ALateReplyOfAnEarlierFirstServoDoesNotCount) {
  take(5, pollOf(22, 1500));
  take(1, pollOf(21, 3000));
  EXPECT_FALSE(decoder.answered()[0]);
}

TEST_F(FirstServo, AFrameThatMayBeDamagedOpensNothing) {
  std::array<std::uint8_t, kMaxFrame> room{};
  const auto frame = encodeStatus(room, 5, 0, pollOf(22, 1500));
  std::vector<std::uint8_t> stream(frame.begin(), frame.end());
  stream.push_back(0x12);  // a stray byte: the frame did not end where it seemed to
  FrameReader reader;
  reader.feed(stream);
  decoder.takeAll(reader, false);
  EXPECT_FALSE(decoder.firstAnswered());
  EXPECT_FALSE(decoder.answered()[4]);
  EXPECT_FALSE(readings.servos_answered || readings.servo[4].answered || readings.servo[4].polled);
}

/// As the bus does: nothing arrives in a cycle whose first servo is silent.
struct Chainless {
  ReadList list{Nanos{16'000'000}, kJoints, {}, false};
  ReadList::Mask dead;
  std::vector<int> firsts;

  bool cycle() {
    const auto asked = list.next();
    if (asked.empty()) return false;
    firsts.push_back(asked[0].joint);
    EXPECT_TRUE(asked[0].poll);
    if (dead[asked[0].joint]) {
      list.missedAll();
      list.leaderMissed();
      return false;
    }
    ReadList::Mask answered;
    for (const Entry entry : asked) {
      if (dead[entry.joint]) break;
      answered.set(entry.joint);
    }
    list.leaderAnswered();
    list.answered(answered);
    return true;
  }
};

TEST(FirstServoOfTheList, IsNextOneOfAnotherChain) {
  Chainless bus;
  for (const darwinop::Chain chain :
       {darwinop::Chain::kRightArm, darwinop::Chain::kLeftArm, darwinop::Chain::kHead, darwinop::Chain::kRightLeg})
    bus.dead |= jointsThat([&](std::size_t i) { return kJointTable[i].chain == chain; });
  int missed = 0;
  while (!bus.cycle() && missed < 20) ++missed;
  EXPECT_LE(missed, 4);
  EXPECT_EQ(kJointTable[static_cast<std::size_t>(bus.firsts.back())].chain, darwinop::Chain::kLeftLeg);
}

TEST(FirstServoOfTheList, ComesToEveryServoWhenAllButOneAreDead) {
  for (std::size_t alive = 0; alive < kJoints; ++alive) {
    Chainless bus;
    bus.dead = ReadList::Mask{}.set().reset(alive);
    int missed = 0;
    while (!bus.cycle() && missed < 100) ++missed;
    EXPECT_LT(missed, static_cast<int>(kJoints)) << alive;
  }
}

}  // namespace
}  // namespace darwinop::cm730
