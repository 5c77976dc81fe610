// Encoders against frames written down elsewhere: vendor manuals, and traffic of the 2013 wrapper worked out by hand.
#include "core/packet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/joints.hpp"
#include "core/registers.hpp"
#include "support/hex.hpp"

namespace darwinop {
namespace {

/// One byte after the other: the definition in the manuals.
std::uint8_t plainChecksum(Bytes body) {
  unsigned sum = 0;
  for (const std::uint8_t byte : body) sum += byte;
  return static_cast<std::uint8_t>(~sum);
}

RC_GTEST_PROP(Checksum, IsThatOfThePlainSumForEveryLengthAndAlignment, ()) {
  constexpr std::size_t kLongest = 260, kAlignments = 16;
  const bool full = *rc::gen::weightedElement<bool>({{1, true}, {9, false}});  // carries everywhere
  auto bytes =
      *rc::gen::container<std::vector<std::uint8_t>>(kLongest + kAlignments, rc::gen::arbitrary<std::uint8_t>());
  if (full) std::ranges::fill(bytes, std::uint8_t{0xFF});
  alignas(kAlignments) std::array<std::uint8_t, kLongest + kAlignments> memory{};
  std::ranges::copy(bytes, memory.begin());
  for (std::size_t at = 0; at < kAlignments; ++at)
    for (std::size_t length = 0; length <= kLongest; ++length) {
      const Bytes body{&memory[at], length};
      RC_ASSERT(checksum(body) == plainChecksum(body));
    }
}

class Encoding : public testing::Test {
 protected:
  std::array<std::uint8_t, kMaxFrame> buffer{};
};

TEST_F(Encoding, PingIsTheManualsFrame) {
  EXPECT_EQ(toHex(encodePing(buffer, 1)), "ff ff 01 02 01 fb");
  EXPECT_EQ(toHex(encodePing(buffer, kBoardId)), "ff ff c8 02 01 34");
  EXPECT_EQ(toHex(encodeStatus(buffer, 1, 0, {})), "ff ff 01 02 00 fc");
  EXPECT_EQ(toHex(encodeStatus(buffer, kBoardId, 0, {})), "ff ff c8 02 00 35");
}

TEST_F(Encoding, ReadIsTheManualsFrame) {
  EXPECT_EQ(toHex(encodeRead(buffer, 19, servo::kFirmware, 1)), "ff ff 13 04 02 02 01 e3");
  EXPECT_EQ(toHex(encodeRead(buffer, 1, servo::kPresentPosition, 2)), "ff ff 01 04 02 24 02 d2");
}

TEST_F(Encoding, StatusCarriesItsParameters) {
  EXPECT_EQ(toHex(encodeStatus(buffer, 19, 0, fromHex("24"))), "ff ff 13 03 00 24 c5");
  EXPECT_EQ(toHex(encodeStatus(buffer, 1, 0, fromHex("dc 05"))), "ff ff 01 04 00 dc 05 19");  // 1500 ticks
  EXPECT_EQ(toHex(encodeStatus(buffer, 19, 0, fromHex("02 08 00 00 00 00"))), "ff ff 13 08 00 02 08 00 00 00 00 da");
  EXPECT_EQ(toHex(encodeStatus(buffer, 19, 0, fromHex("ff 03 02 08 00 00 00 00"))),
            "ff ff 13 0a 00 ff 03 02 08 00 00 00 00 d6");
}

TEST_F(Encoding, BoardAtRestRepliesThirtySixBytes) {
  // Power on, both RGB LEDs 1984, gyro 512 512 512, accelerometer 512 512 640, 11.8 V, microphone 512.
  const auto window =
      fromHex("01 00 c0 07 c0 07 00 00 00 00 00 00 00 00 00 02 00 02 00 02 00 02 00 02 80 02 76 00 02 00");
  EXPECT_EQ(toHex(encodeStatus(buffer, kBoardId, 0, window)),
            "ff ff c8 20 00 01 00 c0 07 c0 07 00 00 00 00 00 00 00 00 00 02 00 02 00 02 00 02 00 02 80 02 76 00 02 "
            "00 84");
}

TEST_F(Encoding, WriteIsTheManualsFrame) {
  EXPECT_EQ(toHex(encodeWrite(buffer, kBoardId, board::kDxlPower, fromHex("01"))), "ff ff c8 04 03 18 01 17");
  EXPECT_EQ(toHex(encodeWrite(buffer, kBoardId, board::kDxlPower, fromHex("00"))), "ff ff c8 04 03 18 00 18");
  EXPECT_EQ(toHex(encodeWrite(buffer, kBoardId, 26, fromHex("1f 02"))), "ff ff c8 05 03 1a 1f 02 f4");  // amber
  EXPECT_EQ(toHex(encodeWrite(buffer, kBoardId, 26, fromHex("3f 00"))), "ff ff c8 05 03 1a 3f 00 d6");  // red
  EXPECT_EQ(toHex(encodeWrite(buffer, kBoardId, 28, fromHex("c0 07"))), "ff ff c8 05 03 1c c0 07 4c");  // green
  EXPECT_EQ(toHex(encodeWrite(buffer, 3, servo::kTorqueEnable, fromHex("01"))), "ff ff 03 04 03 18 01 dc");
  EXPECT_EQ(toHex(encodeWrite(buffer, 1, servo::kTorqueEnable, fromHex("00 00"))), "ff ff 01 05 03 18 00 00 de");
  EXPECT_EQ(toHex(encodeWrite(buffer, kBroadcastId, servo::kMovingSpeed, fromHex("00 00"))),
            "ff ff fe 05 03 20 00 00 d9");
}

TEST_F(Encoding, SyncWriteIsTheVendorsExample) {
  SyncWriteEncoder sync{buffer, 0x1E, 4};
  EXPECT_TRUE(sync.add(0, fromHex("10 00 50 01")));
  EXPECT_TRUE(sync.add(1, fromHex("20 02 60 03")));
  EXPECT_EQ(toHex(sync.finish()), "ff ff fe 0e 83 1e 04 00 10 00 50 01 01 20 02 60 03 67");
}

TEST_F(Encoding, SyncWriteOfTheNeckIsTheFrameOf2013) {
  SyncWriteEncoder sync{buffer, servo::kPGain, 8};
  EXPECT_TRUE(sync.add(19, fromHex("20 00 02 08 ff 03 ff 03")));  // P 32, goal 2050, speed and torque 1023
  EXPECT_EQ(toHex(sync.finish()), "ff ff fe 0d 83 1c 08 13 20 00 02 08 ff 03 ff 03 0c");
}

TEST_F(Encoding, SyncWriteOfAllServosHas188Bytes) {
  SyncWriteEncoder sync{buffer, servo::kPGain, 8};
  const std::array<std::uint8_t, 8> data{};
  for (const JointRow& joint : kJointTable) EXPECT_TRUE(sync.add(joint.id, data));
  EXPECT_EQ(sync.finish().size(), 188u);
}

TEST_F(Encoding, EmptySyncWriteIsNotAFrame) {
  SyncWriteEncoder sync{buffer, servo::kPGain, 8};
  EXPECT_TRUE(sync.finish().empty());
}

TEST_F(Encoding, SyncWriteTakesWhatTheLengthByteAllowsAndNoMore) {
  std::array<std::uint8_t, 300> large{};
  SyncWriteEncoder sync{large, servo::kPGain, 8};
  const std::array<std::uint8_t, 8> data{};
  std::uint8_t taken = 0;
  while (taken < 100 && sync.add(taken, data)) ++taken;
  EXPECT_EQ(taken, 27);  // (253 - 2) / 9
  EXPECT_EQ(sync.finish()[3], 2 + 2 + 27 * 9);
}

TEST_F(Encoding, SyncWriteRefusesAnEntryOfAnotherLength) {
  SyncWriteEncoder sync{buffer, servo::kPGain, 8};
  EXPECT_FALSE(sync.add(1, fromHex("01 02 03")));
  EXPECT_TRUE(sync.finish().empty());
}

TEST_F(Encoding, BulkReadIsTheVendorsExample) {
  BulkReadEncoder bulk{buffer};
  EXPECT_TRUE(bulk.add(1, 0x1E, 2));
  EXPECT_TRUE(bulk.add(2, 0x24, 2));
  EXPECT_EQ(toHex(bulk.finish()), "ff ff fe 09 92 00 02 01 1e 02 02 24 1d");
}

TEST_F(Encoding, BulkReadOfBoardAndAllServosIsTheFrameOf2013) {
  for (const auto& [address, count] : {std::pair<std::uint8_t, std::uint8_t>{34, 8}, {36, 6}}) {
    BulkReadEncoder bulk{buffer};
    EXPECT_TRUE(bulk.add(kBoardId, 24, 30));
    for (const JointRow& joint : kJointTable) EXPECT_TRUE(bulk.add(joint.id, address, count));
    const auto frame = bulk.finish();
    ASSERT_EQ(frame.size(), 70u);
    EXPECT_EQ(toHex(frame.first(9)), "ff ff fe 42 92 00 1e c8 18");
    EXPECT_EQ(frame.back(), 0x15);
  }
}

TEST_F(Encoding, BulkReadTakesWhatTheLengthByteAllowsAndNoMore) {
  std::array<std::uint8_t, 300> large{};
  BulkReadEncoder bulk{large};
  std::uint8_t taken = 0;
  while (taken < 100 && bulk.add(taken, 36, 6)) ++taken;
  EXPECT_EQ(taken, 84);  // (253 - 1) / 3
  EXPECT_EQ(bulk.finish().size(), 259u);
}

TEST_F(Encoding, EmptyBulkReadIsNotAFrame) {
  EXPECT_TRUE(BulkReadEncoder{buffer}.finish().empty());
}

TEST_F(Encoding, NothingIsWrittenPastTheBuffer) {
  const std::array<std::uint8_t, 8> data{};
  for (std::size_t room = 0; room < 20; ++room) {
    buffer.fill(0xAA);
    const std::span<std::uint8_t> small{buffer.data(), room};
    EXPECT_EQ(encodePing(small, 1).empty(), room < 6);
    EXPECT_EQ(encodeRead(small, 1, 36, 2).empty(), room < 8);
    EXPECT_EQ(encodeWrite(small, 1, 30, data).empty(), room < 15);
    SyncWriteEncoder sync{small, 28, 8};
    EXPECT_EQ(sync.add(1, data), room >= 17);
    EXPECT_EQ(sync.finish().empty(), room < 17);
    BulkReadEncoder bulk{small};
    EXPECT_EQ(bulk.add(1, 36, 6), room >= 10);
    EXPECT_EQ(bulk.finish().empty(), room < 10);
    EXPECT_THAT(std::span(buffer).subspan(room), testing::Each(0xAA)) << "with room for " << room << " bytes";
  }
}

TEST_F(Encoding, ParametersBeyondTheLengthByteAreRefused) {
  std::array<std::uint8_t, 300> large{};
  const std::vector<std::uint8_t> longest(253), too_long(254);
  EXPECT_EQ(encodeStatus(large, 1, 0, longest).size(), kMaxFrame);
  EXPECT_TRUE(encodeStatus(large, 1, 0, too_long).empty());
  EXPECT_TRUE(encodeWrite(large, 1, 0, longest).empty());  // the address takes one more
}

}  // namespace
}  // namespace darwinop
