// Wheel and multi-turn mode, and set-up options of servos and board.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "bench.hpp"
#include "hil-mocks/robot_options.hpp"

namespace darwinop::hil {
namespace {

using testing::HasSubstr;

BoardOptions with(const char* setting) {
  BoardOptions options = Bench::powered();
  setServo(options, setting);
  return options;
}

double turnsOf(Bench& bench, Joint joint, Nanos time) {
  const double before = bench.body.state().joint[index(joint)].position_rad;
  bench.board.advance(bench.board.now() + time);
  return (bench.body.state().joint[index(joint)].position_rad - before) / (2 * std::numbers::pi);
}

TEST(WheelMode, TurnsContinuouslyAtTheSpeedRegisterForAnyGoal) {
  Bench bench{with("Neck=wheel")};
  bench.send(withChecksum("FF FF 13 07 03 1E 02 08 00 02"));  // another goal, speed 512: 58.4 rpm, above the maximum
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().byte(servo::kTorqueEnable), 1);
  EXPECT_GT(turnsOf(bench, Joint::kNeck, 5s), 3);
  EXPECT_LE(bench.board.servo(Joint::kNeck).table().word(servo::kPresentPosition), kTickMax);
  bench.send(withChecksum("FF FF 13 05 03 20 00 06"));  // reverse direction
  turnsOf(bench, Joint::kNeck, 1s);
  EXPECT_LT(turnsOf(bench, Joint::kNeck, 5s), -3);
  bench.send(withChecksum("FF FF 13 05 03 20 00 00"));
  turnsOf(bench, Joint::kNeck, 1s);
  EXPECT_NEAR(turnsOf(bench, Joint::kNeck, 1s), 0, 0.01);
}

TEST(WheelMode, ADirectionInTheSpeedRegisterIsRejectedInJointMode) {
  Bench bench;
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 05 03 20 00 06")), withChecksum("FF FF 13 02 08"));
}

TEST(MultiTurnMode, ReportsPositionsBeyondOneTurn) {
  Bench bench{with("19=multi-turn")};
  bench.body.place(Joint::kNeck, 5);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 02 24 02")),
            withChecksum("FF FF 13 04 00 " + hexOf(bytesOf("BB14"))));  // 2048 + 5 / 0.00153398 = 5307
}

TEST(ServoOptionsText, SetsEachRegister) {
  BoardOptions options;
  for (const char* text : {"Neck=model:12", "Neck=firmware:24", "Neck=id:3", "Neck=return-delay:250",
                           "Neck=status-level:0", "Neck=cw-limit:1000", "Neck=ccw-limit:3000", "Neck=max-torque:0"})
    setServo(options, text);
  const BusDevice& neck = VirtualServo{Joint::kNeck, options.servo[index(Joint::kNeck)]};
  EXPECT_EQ(neck.table().word(0), 12);
  EXPECT_EQ(neck.table().byte(2), 24);
  EXPECT_EQ(neck.id(), 3);
  EXPECT_EQ(neck.table().byte(5), 250);
  EXPECT_EQ(neck.statusLevel(), 0);
  EXPECT_EQ(neck.table().word(6), 1000);
  EXPECT_EQ(neck.table().word(8), 3000);
  EXPECT_EQ(neck.table().word(14), 0);
}

TEST(ServoOptionsText, RejectsUnknownSettingsAndListsTheAllowedOnes) {
  for (const char* text : {"", "Neck", "Nose=wheel", "21=wheel", "0=wheel", "Neck=whel",
                           "Neck=model:", "Neck=cw-limit:4096", "Neck=id:-1"}) {
    BoardOptions options;
    try {
      setServo(options, text);
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& wrong) {
      EXPECT_THAT(wrong.what(), HasSubstr("JOINT=SETTING"));
      EXPECT_THAT(wrong.what(), HasSubstr("multi-turn"));
    }
  }
  BoardOptions options;
  EXPECT_THROW(setBoard(options, "no-such-thing"), std::runtime_error);
}

TEST(BoardOptionsText, RemovesAnInstruction) {
  const std::string bulk_read = withChecksum("FF FF FE 06 92 00 1E C8 18"), one_servo = "FF FF 13";
  BoardOptions options = Bench::powered();
  Bench whole{options};
  EXPECT_THAT(whole.send(bulk_read), HasSubstr("FF FF C8 20"));
  setBoard(options, "no-bulk-read");
  Bench lacking{options};
  EXPECT_EQ(lacking.send(bulk_read), "");
  BoardOptions fixed = Bench::powered();
  setBoard(fixed, "one-block-length");
  Bench one_length{fixed};
  EXPECT_THAT(one_length.send(bulk_read), HasSubstr("FF FF C8 20"));
  EXPECT_EQ(one_length.send(withChecksum("FF FF FE 06 92 00 1F C8 18")), "");
  BoardOptions no_sync = Bench::powered();
  setBoard(no_sync, "no-sync-write");
  Bench no_sync_write{no_sync};
  no_sync_write.send(withChecksum("FF FF FE 06 83 19 01 13 01"));
  EXPECT_EQ(no_sync_write.board.servo(Joint::kNeck).table().byte(25), 0);
}

TEST(BoardOptions, WithoutABoardServosAnswerABulkReadByThemselves) {
  BoardOptions options;
  setBoard(options, "none");
  Bench bench{options};
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 02 01")), "");
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), withChecksum("FF FF 13 02 00")) << "always supplied";
  EXPECT_EQ(bench.send(withChecksum("FF FF FE 09 92 00 01 13 03 01 14 03")),
            withChecksum("FF FF 13 03 00 13") + " | " + withChecksum("FF FF 14 03 00 14"));
  EXPECT_EQ(bench.send(withChecksum("FF FF FE 09 92 00 1E C8 18 01 13 03")), "") << "they wait for the board";
}

TEST(BoardOptions, ABoardIsChosenByItsName) {
  BoardOptions options;
  setBoard(options, "cm-740");
  EXPECT_EQ(options.model, 0x7400);
  setBoard(options, "CM-730");
  EXPECT_EQ(options.model, 0x7300);
  EXPECT_THROW(setBoard(options, "cm-750"), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::hil
