// Recordings of a whole robot that is like its model, and what cannot be recorded.
#include <cerrno>
#include <cstring>

#include "core/faults.hpp"
#include "gap_files.hpp"
#include "gap_recorder.hpp"
#include "system/gap_rig.hpp"

namespace darwinop {
namespace {

class GapRecordShort : public GapRig {};

TEST_F(GapRecordShort, ARobotLikeItsModelHasNothingOpen) {
  record("twin");
  EXPECT_EQ(said_.find(row(Fault::kFell).remedy), std::string::npos) << "on its side because it was asked to be";
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
  EXPECT_FALSE(std::filesystem::exists(file("case/upright.csv"))) << "it would be kept";
  EXPECT_FALSE(std::filesystem::exists(file("case/left_side.csv"))) << "it has gone on";
}

// As after the first of five clampings.
TEST_F(GapRecordShort, WhatWasRecordedBeforeItWasStoppedIsKeptOnRequest) {
  const std::vector<std::string> words{"record", "--robot", "twin", "--out", file("case")};
  {
    Program running{{program("darwinop-gap"), words[0], words[1], words[2], words[3], words[4]}, file("command.txt")};
    ASSERT_TRUE(running.says("2 of ", seconds{60}));
    running.kill(SIGTERM);
    EXPECT_EQ(running.wait(seconds{60}), 130);
  }
  const std::string first = textOf(file("case/upright.csv"));
  EXPECT_EQ(gap(words, seconds{10}), 2);
  EXPECT_THAT(said_, testing::HasSubstr(file("case/upright.csv") + gap::messages::kRecordingExists));
  std::vector<std::string> again = words;
  again.emplace_back("--resume");
  ASSERT_EQ(gap(again, seconds{120}), 0) << said_;
  EXPECT_THAT(said_, testing::HasSubstr(std::string{"upright.csv: "} + gap::messages::kKept));
  EXPECT_EQ(textOf(file("case/upright.csv")), first);
  EXPECT_EQ(json::parse(textOf(file("case/case.json")))["logs"].size(), 5u);
}

TEST_F(GapRecordShort, AFileThatIsNotARecordingIsKept) {
  std::filesystem::create_directories(file("case"));
  std::ofstream{file("case/face_down.csv")} << "mine";
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("case"), "--resume"}, seconds{10}), 2);
  EXPECT_EQ(textOf(file("case/face_down.csv")), "mine");
}

TEST_F(GapRecordShort, AFolderThatCannotBeMadeIsNamedWithTheReason) {
  std::ofstream{file("taken")} << "a file";
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("taken/case")}, seconds{10}), 2);
  EXPECT_THAT(said_, testing::EndsWith(file("taken/case") + ": " + std::strerror(ENOTDIR) + "\n"));
}

// Its size limit stands for a full disk. The shared memory of the loop is a file also, which has to fit.
TEST_F(GapRecordShort, AFullDiskIsTheReasonThatIsReported) {
  const std::string limited = "trap '' XFSZ; ulimit -f 1024; exec \"$0\" \"$@\"";
  Program running{
      {"/bin/bash", "-c", limited, program("darwinop-gap"), "record", "--robot", "twin", "--out", file("case")},
      file("command.txt")};
  EXPECT_EQ(running.wait(seconds{60}), 2);
  EXPECT_THAT(running.output(), testing::HasSubstr(std::strerror(EFBIG)));
  EXPECT_THAT(running.output(), testing::HasSubstr(gap::messages::kRecordedInPart));
}

}  // namespace
}  // namespace darwinop
