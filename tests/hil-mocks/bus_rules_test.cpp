// Bus rules: which device answers, in what order, when, and with which error bits.
#include <gtest/gtest.h>

#include "bench.hpp"

namespace darwinop::hil {
namespace {

const std::string kBulkOneTwoThree = "FF FF FE 0C 92 00 02 01 24 02 02 24 02 03 24";

std::vector<std::string> ids(const std::vector<Bench::Reply>& replies) {
  std::vector<std::string> ids;
  ids.reserve(replies.size());
  for (const Bench::Reply& reply : replies) ids.push_back(reply.hex.substr(6, 2));
  return ids;
}
using Ids = std::vector<std::string>;

TEST(BulkRead, EndsAtADeadServo) {
  Bench bench;
  bench.board.setServoDead(Joint::kShoulderL, true);
  EXPECT_EQ(ids(bench.sendAll(withChecksum(kBulkOneTwoThree))), (Ids{"01"}));
  bench.board.setServoDead(Joint::kShoulderL, false);
  EXPECT_EQ(ids(bench.sendAll(withChecksum(kBulkOneTwoThree))), (Ids{"01", "02", "03"}));
}

TEST(BulkRead, EndsAtAnUnusedId) {
  Bench bench;
  EXPECT_EQ(ids(bench.sendAll(withChecksum("FF FF FE 0C 92 00 02 01 24 02 63 24 02 C8 1A"))), (Ids{"01"}));
}

TEST(BulkRead, FollowsTheOrderOfTheList) {
  Bench bench;
  EXPECT_EQ(ids(bench.sendAll(withChecksum("FF FF FE 0C 92 00 02 14 24 01 C8 32 02 01 24"))), (Ids{"14", "C8", "01"}));
}

TEST(BulkRead, CountsOnlyTheFirstEntryOfAnId) {
  Bench bench;
  const auto replies = bench.sendAll(withChecksum("FF FF FE 0C 92 00 01 01 2A 02 01 24 02 02 24"));
  EXPECT_EQ(ids(replies), (Ids{"01", "02"}));
  EXPECT_EQ(replies[0].hex, "FF FF 01 03 00 76 85") << "one byte at 42: 11.8 V";
}

TEST(BulkRead, NeedsStatusLevelOne) {
  BoardOptions options = Bench::powered();
  options.servo[1].status_level = 0;
  options.servo[2].status_level = 1;
  Bench bench{options};
  EXPECT_EQ(ids(bench.sendAll(withChecksum(kBulkOneTwoThree))), (Ids{"01"}));
  EXPECT_EQ(ids(bench.sendAll(withChecksum("FF FF FE 09 92 00 02 01 24 02 03 24"))), (Ids{"01", "03"}));
}

TEST(BulkRead, ARangeErrorDoesNotEndTheChain) {
  Bench bench;
  const auto replies = bench.sendAll(withChecksum("FF FF FE 09 92 00 0A 01 46 02 02 24"));
  ASSERT_EQ(ids(replies), (Ids{"01", "02"}));
  EXPECT_EQ(replies[0].hex, withChecksum("FF FF 01 02 08"));
}

TEST(WireTime, RequestAndReplyTakeTenMicrosecondsPerByte) {
  Bench bench;
  bench.board.advance(1s);
  const auto replies = bench.sendAll("FF FF 01 04 02 24 02 D2");
  ASSERT_EQ(replies.size(), 1u);
  EXPECT_EQ(replies[0].at, 1s + 16 * 10us) << "8 bytes out, 8 bytes in";
}

TEST(WireTime, ReturnDelayCountsTwoMicrosecondsForEveryDevice) {
  BoardOptions options = Bench::powered();
  options.servo[0].return_delay = 250;
  options.servo[2].return_delay = 10;
  Bench bench{options};
  const auto replies = bench.sendAll(withChecksum(kBulkOneTwoThree));
  ASSERT_EQ(replies.size(), 3u);
  const Nanos asked = 16 * 10us;
  EXPECT_EQ(replies[0].at, asked + 500us + 80us);
  EXPECT_EQ(replies[1].at, asked + 500us + 160us);
  EXPECT_EQ(replies[2].at, asked + 520us + 240us);
}

TEST(WireTime, FullCycleOfTheThesisTakes5340Microseconds) {
  Bench bench;
  std::string sync = "FF FF FE B8 83 1C 08", bulk = "FF FF FE 42 92 00 1E C8 18";
  for (int id = 1; id <= 20; ++id) {
    char part[48];
    std::snprintf(part, sizeof part, " %02X 20 00 00 08 FF 03 FF 03", id);
    sync += part;
    std::snprintf(part, sizeof part, " 06 %02X 24", id);
    bulk += part;
  }
  bench.board.receive(bytesOf(withChecksum(sync)), 0us);
  const auto replies = bench.sendAll(withChecksum(bulk));
  ASSERT_EQ(replies.size(), 21u);
  EXPECT_EQ(replies.back().at, 5340us);
}

TEST(WireTime, UnpacedBoardAnswersAtOnce) {
  BoardOptions options = Bench::powered();
  options.byte_time = 0us;
  Bench bench{options};
  EXPECT_EQ(bench.sendAll(withChecksum(kBulkOneTwoThree)).back().at, 0us);
}

TEST(WireTime, ARequestWaitsForEarlierReplies) {
  Bench bench;
  bench.board.receive(bytesOf(withChecksum(kBulkOneTwoThree)), 0us);
  const auto replies = bench.sendAll("FF FF 01 02 01 FB");
  ASSERT_EQ(replies.size(), 4u);
  EXPECT_EQ(replies[3].at, 160us + 240us + 120us);
}

TEST(Power, ServosAreSilentAndResetWithoutIt) {
  Bench bench;
  bench.send("FF FF 01 05 03 20 10 01 C5");
  EXPECT_EQ(bench.board.servo(Joint::kShoulderR).table().word(32), 0x110);
  bench.send("FF FF C8 04 03 18 00 18");
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "");
  EXPECT_EQ(bench.send("FF FF C8 02 01 34"), "FF FF C8 02 00 35") << "the board still answers";
  bench.send("FF FF C8 04 03 18 01 17");
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.board.servo(Joint::kShoulderR).table().word(32), 0) << "RAM has its power-up values";
}

TEST(Power, AServoStartsWithItsPresentPositionAsGoal) {
  Bench bench{BoardOptions{}};
  bench.body.place(Joint::kNeck, 0.5);
  bench.send("FF FF C8 04 03 18 01 17");
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().word(30), 2374);
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().byte(24), 0);
}

TEST(Power, ServosReceiveNothingDuringBoot) {
  BoardOptions options;
  options.servo_boot = 200ms;
  Bench bench{options};
  bench.send("FF FF C8 04 03 18 01 17");
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "");
  bench.board.advance(250ms);
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
}

TEST(Power, ResetButtonCutsItAndRestoresTheDefaults) {
  Bench bench;
  bench.send("FF FF C8 05 03 1A 1F 02 F4");
  bench.board.pressReset();
  EXPECT_FALSE(bench.board.device().servoPower());
  EXPECT_EQ(bench.board.device().table().word(26), 0x03E0);
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "");
}

TEST(Errors, WritesOfHalfAWordAreRejectedEntirely) {
  Bench bench;
  const std::string range = withChecksum("FF FF C8 02 08");
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 03 1B 01")), range) << "starts at a high byte";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 05 03 1B 01 02")), range) << "one half of each of two words";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 05 03 19 01 01")), range) << "ends at a low byte";
  EXPECT_EQ(bench.board.device().table().byte(25), 0);
}

TEST(Errors, RangeIsReportedAndNothingWritten) {
  Bench bench;
  const std::string range = withChecksum("FF FF C8 02 08");
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 03 19 08")), range) << "panel has 3 bits";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 05 03 1A 00 80")), range) << "bit 15 of a colour";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 03 1E 01")), range) << "buttons are read-only";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 03 1F 01")), range) << "no register";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 03 60 01")), range) << "after the table";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 02 50 02")), range) << "read beyond the end";
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 02 10 00")), range) << "read of length 0";
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 04 02 4A 01")), withChecksum("FF FF 01 02 08")) << "servo ends at 73";
}

TEST(Errors, BadChecksumIsReportedExceptForPing) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF 01 04 02 24 02 00"), withChecksum("FF FF 01 02 10"));
  EXPECT_EQ(bench.send("FF FF 01 02 01 00"), "");
  EXPECT_EQ(bench.send("FF FF FE 05 03 20 10 01 00"), "") << "never to a broadcast";
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().word(32), 0) << "and has no effect";
  EXPECT_EQ(bench.board.counters().bad_checksums, 3u);
}

TEST(Errors, UnknownInstructionAndActionWithoutRegisteredWriteAreInstructionErrors) {
  Bench bench;
  const std::string instruction = withChecksum("FF FF 01 02 40");
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 02 07")), instruction);
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 02 05")), instruction);
}

TEST(StatusLevel, ZeroAnswersOnlyPing) {
  BoardOptions options = Bench::powered();
  options.servo[0].status_level = 0;
  options.servo[1].status_level = 1;
  Bench bench{options};
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.send("FF FF 01 04 02 24 02 D2"), "");
  EXPECT_EQ(bench.send(withChecksum("FF FF 02 04 02 02 01")), withChecksum("FF FF 02 03 00 24"));
  EXPECT_EQ(bench.send(withChecksum("FF FF 02 04 03 19 01")), "");
  EXPECT_EQ(bench.board.servo(Joint::kShoulderL).table().byte(25), 1) << "executed, but not answered";
}

TEST(StatusBeforeEffect, TheNewIdIsAcknowledgedUnderTheOldOne) {
  Bench bench;
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 04 03 03 1E")), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "");
  EXPECT_EQ(bench.send(withChecksum("FF FF 1E 02 01")), withChecksum("FF FF 1E 02 00"));
}

TEST(StatusBeforeEffect, LevelAndDelayOfTheOldSettingApply) {
  Bench bench;
  const auto first = bench.sendAll(withChecksum("FF FF 01 04 03 05 FA"));
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].at, (8 + 6) * 10us) << "no delay yet";
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 04 03 10 00")), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 04 03 10 02")), "");
}

TEST(RegisteredWrite, WaitsForAction) {
  Bench bench;
  const ControlTable& servo = bench.board.servo(Joint::kShoulderR).table();
  EXPECT_EQ(bench.send(withChecksum("FF FF 01 05 04 1E 00 08")), "FF FF 01 02 00 FC");
  EXPECT_EQ(servo.word(30), 1500);
  EXPECT_EQ(servo.byte(44), 1);
  EXPECT_EQ(bench.send(withChecksum("FF FF FE 02 05")), "");
  EXPECT_EQ(servo.word(30), 2048);
  EXPECT_EQ(servo.byte(44), 0);
}

TEST(Reset, ResetsAServoToFactoryIdAndBaudButNotTheBoard) {
  Bench bench;
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 06")), withChecksum("FF FF 13 02 00"));
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), "") << "now at 57142 baud";
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().byte(3), 1);
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().byte(5), 250);
  bench.send("FF FF C8 05 03 1A 1F 02 F4");
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 02 06")), "FF FF C8 02 00 35");
  EXPECT_EQ(bench.board.device().table().word(26), 0x021F);
}

TEST(TwoServosWithOneId, GarbleEachOther) {
  BoardOptions options = Bench::powered();
  options.servo[18] = ServoOptions::factoryFresh(1);
  Bench bench{options};
  // 1500 = DC 05 and the neck's 2050 = 02 08 at once: dominant bits win and the checksum is wrong.
  EXPECT_EQ(bench.send("FF FF 01 04 02 24 02 D2"), "FF FF 01 04 00 00 00 10");
}

TEST(Parser, FindsTheFrameAfterGarbage) {
  Bench bench;
  EXPECT_EQ(bench.send("00 12 FF 34 FF FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
}

TEST(Parser, DropsAPartialFrameAfter100Milliseconds) {
  Bench bench;
  bench.sendAll("FF FF 01 20 03", 200ms);
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
}

TEST(Parser, ConsumesAsManyBytesAsAWrongLength) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF 63 0A 03 FF FF 01 02 01 FB"), "");
}

TEST(Stall, AnswersEverythingAfterwards) {
  Bench bench;
  bench.board.stallUntil(1s);
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "");
  EXPECT_EQ(bench.send("FF FF C8 02 01 34"), "");
  const auto replies = bench.sendAll("", 2s);
  ASSERT_EQ(replies.size(), 2u);
  EXPECT_EQ(replies[0].at, 1s + 12 * 10us);
}

}  // namespace
}  // namespace darwinop::hil
