// Recordings of a whole robot that is like its model, and what cannot be recorded.
#include "system/gap_rig.hpp"

namespace darwinop {
namespace {

class GapRecordShort : public GapRig {};

TEST_F(GapRecordShort, ARobotLikeItsModelHasNothingOpen) {
  record("twin");
  EXPECT_THAT(openSignals("darwin-op"), testing::IsEmpty());
  ASSERT_EQ(gap({"check", file("case")}, seconds{20}), 0) << said_;
  EXPECT_EQ(said_.find("Odd:"), std::string::npos) << said_;
}

TEST_F(GapRecordShort, WhatCannotBeRecordedIsRefusedBeforeAnythingMoves) {
  EXPECT_EQ(gap({"record", "--robot", "virtual", "--out", file("case")}, seconds{10}), 2);
  EXPECT_EQ(gap({"record", "--robot", "tcp://nowhere", "--out", file("case")}, seconds{10}), 2);
  std::filesystem::create_directories(file("case"));
  std::ofstream{file("case/case.json")} << "{}";
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("case")}, seconds{10}), 2);
  EXPECT_EQ(textOf(file("case/case.json")), "{}");
}

TEST_F(GapRecordShort, RecordingsOfSomebodyElseAreKept) {
  std::filesystem::create_directories(file("case"));
  std::ofstream{file("case/face_down.csv")} << "mine";
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("case")}, seconds{10}), 2);
  EXPECT_EQ(textOf(file("case/face_down.csv")), "mine");
}

TEST_F(GapRecordShort, AKillEndsItAndTheExperimentThatRuns) {
  Program running{{program("darwinop-gap"), "record", "--robot", "twin", "--out", file("case")}, file("command.txt")};
  ASSERT_TRUE(running.says("1 of ", seconds{30}));
  running.kill(SIGTERM);
  EXPECT_EQ(running.wait(seconds{60}), 130);
  EXPECT_FALSE(std::filesystem::exists(file("case/case.json")));
  EXPECT_FALSE(std::filesystem::exists(file("case/left_side.csv"))) << "it has gone on";
}

}  // namespace
}  // namespace darwinop
