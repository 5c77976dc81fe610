// Virtual board against frames printed by other sources, byte for byte: detects errors that encoder and board share.
#include <gtest/gtest.h>

#include "bench.hpp"

namespace darwinop::hil {
namespace {

BoardOptions unpowered() {
  return {};
}

TEST(GoldenFrames, ServoAndBoardAnswerAPing) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.send("FF FF C8 02 01 34"), "FF FF C8 02 00 35");
}

TEST(GoldenFrames, PowerOnAndOffAreAnsweredByTheBoard) {
  Bench bench{unpowered()};
  EXPECT_FALSE(bench.board.device().servoPower());
  EXPECT_EQ(bench.send("FF FF C8 04 03 18 01 17"), "FF FF C8 02 00 35");
  EXPECT_TRUE(bench.board.device().servoPower());
  EXPECT_EQ(bench.send("FF FF C8 04 03 18 00 18"), "FF FF C8 02 00 35");
  EXPECT_FALSE(bench.board.device().servoPower());
}

TEST(GoldenFrames, LedFramesOfTheWrapperAreAccepted) {
  Bench bench;
  const char* ok = "FF FF C8 02 00 35";
  EXPECT_EQ(bench.send("FF FF C8 05 03 1A 1F 02 F4"), ok);
  EXPECT_EQ(bench.board.device().table().word(26), 0x021F);
  EXPECT_EQ(bench.send("FF FF C8 05 03 1A 3F 00 D6"), ok);
  EXPECT_EQ(bench.send("FF FF C8 05 03 1C 3F 00 D4"), ok);
  EXPECT_EQ(bench.board.device().table().word(28), 63);
  EXPECT_EQ(bench.send("FF FF C8 05 03 1A C0 07 4E"), ok);
  EXPECT_EQ(bench.send("FF FF C8 05 03 1C C0 07 4C"), ok);
  EXPECT_EQ(bench.board.device().table().word(28), 1984);
  EXPECT_EQ(bench.send("FF FF C8 05 03 1A E0 03 32"), ok);
}

TEST(GoldenFrames, ServoNineteenHasFirmware36) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF 13 04 02 02 01 E3"), "FF FF 13 03 00 24 C5");
}

TEST(GoldenFrames, PresentPositionOfServoOneIsItsStartPose) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF 01 04 02 24 02 D2"), "FF FF 01 04 00 DC 05 19");
}

TEST(GoldenFrames, TorqueOffByATwoByteWriteAlsoSwitchesTheLedOff) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF 01 05 03 18 01 01 DC"), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.send("FF FF 01 05 03 18 00 00 DE"), "FF FF 01 02 00 FC");
  EXPECT_EQ(bench.board.servo(Joint::kShoulderR).table().byte(24), 0);
  EXPECT_EQ(bench.board.servo(Joint::kShoulderR).table().byte(25), 0);
}

TEST(GoldenFrames, ABroadcastOfMovingSpeedReachesEveryServoWithoutReply) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF FE 05 03 20 10 01 C8"), "");
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().word(32), 0x110);
  EXPECT_EQ(bench.send("FF FF FE 05 03 20 00 00 D9"), "");
  for (const JointRow& row : kJointTable)
    EXPECT_EQ(bench.board.servo(*findJoint(row.name)).table().word(32), 0) << row.name;
}

TEST(GoldenFrames, StepSyncWriteOf2013SetsTheNeckOnly) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF FE 0D 83 1C 08 13 20 00 02 08 FF 03 FF 03 0C"), "");
  const ControlTable& neck = bench.board.servo(Joint::kNeck).table();
  EXPECT_EQ(neck.byte(28), 32);
  EXPECT_EQ(neck.word(30), 2050);
  EXPECT_EQ(neck.word(32), 1023);
  EXPECT_EQ(neck.word(34), 1023);
  EXPECT_EQ(neck.byte(24), 1) << "a goal write enables torque";
  EXPECT_EQ(bench.board.servo(Joint::kHead).table().byte(24), 0);
}

TEST(GoldenFrames, AnEmptySyncWriteIsAccepted) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF FE 04 83 1C 08 56"), "");
  EXPECT_EQ(bench.board.counters().sync_writes, 1u);
}

TEST(GoldenFrames, VendorsSyncWriteExampleSetsTwoServos) {
  Bench bench;
  EXPECT_EQ(bench.send("FF FF FE 0E 83 1E 04 00 10 00 50 01 01 20 02 60 03 67"), "");
  EXPECT_EQ(bench.board.servo(Joint::kShoulderR).table().word(30), 0x220);
  EXPECT_EQ(bench.board.servo(Joint::kShoulderR).table().word(32), 0x360);
}

TEST(GoldenFrames, VendorsBulkReadExampleIsAnsweredInListOrder) {
  Bench bench;
  // Two bytes at 30 (goal 1500, as power-up leaves it) of servo 1, then two at 36 (2517) of servo 2.
  EXPECT_EQ(bench.send("FF FF FE 09 92 00 02 01 1E 02 02 24 1D"), "FF FF 01 04 00 DC 05 19 | FF FF 02 04 00 D5 09 1B");
}

std::string bulkRequest(const std::string& head, int count, int address, const std::string& check) {
  std::string hex = head;
  for (int id = 1; id <= 20; ++id) {
    char triplet[16];
    std::snprintf(triplet, sizeof triplet, " %02X %02X %02X", count, id, address);
    hex += triplet;
  }
  return hex + check;
}

TEST(GoldenFrames, BulkReadOfTheThesisIsAnsweredByAllInOrder) {
  Bench bench;
  bench.send("FF FF C8 05 03 1A C0 07 4E");
  bench.send("FF FF C8 05 03 1C C0 07 4C");
  bench.body.place(Joint::kNeck, (2050 - 2048) * 2 * 3.14159265358979 / 4096);
  const auto replies = bench.sendAll(bulkRequest("FF FF FE 42 92 00 1E C8 18", 6, 36, " 15"));
  ASSERT_EQ(replies.size(), 21u);
  EXPECT_EQ(replies[0].hex,
            "FF FF C8 20 00 01 00 C0 07 C0 07 00 00 00 00 00 00 00 00 00 02 00 02 00 02 00 02 00 02 80 02 76 00 02 "
            "00 84");
  EXPECT_EQ(replies[19].hex, "FF FF 13 08 00 02 08 00 00 00 00 DA");
}

TEST(GoldenFrames, BulkReadOf2013CarriesTheTorqueLimit) {
  Bench bench;
  const auto replies = bench.sendAll(bulkRequest("FF FF FE 42 92 00 1E C8 18", 8, 34, " 15"));
  ASSERT_EQ(replies.size(), 21u);
  EXPECT_EQ(replies[19].hex, "FF FF 13 0A 00 FF 03 02 08 00 00 00 00 D6");
}

}  // namespace
}  // namespace darwinop::hil
