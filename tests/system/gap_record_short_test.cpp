// Recordings of a whole robot that is like its model, and what cannot be recorded.
#include <cerrno>
#include <cstring>

#include "core/faults.hpp"
#include "gap/record/kept_recording.hpp"
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
  std::vector<std::string> of_another = again;
  of_another[2] = robotWith("", "");
  EXPECT_EQ(gap(of_another, seconds{10}), 2);
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kOfAnotherRobot));
  ASSERT_EQ(gap(again, seconds{120}), 0) << said_;
  EXPECT_THAT(said_, testing::HasSubstr(std::string{"upright.csv: "} + gap::messages::kKept));
  EXPECT_EQ(textOf(file("case/upright.csv")), first);
  EXPECT_EQ(json::parse(textOf(file("case/case.json")))["logs"].size(), 5u);
}

// Recordings of a robot: those of a twin with the head of a robot's. Nothing is left to record, so nothing moves.
TEST_F(GapRecordShort, AResumedSessionHasTheTimesOfItsRecordings) {
  record("twin");
  std::filesystem::remove(file("case/case.json"));
  const auto begin = [this](const std::string& name, const std::string& date,
                            const std::string& robot = "/dev/ttyUSB0") {
    std::string text = textOf(file("case/" + name));
    for (const auto& [key, value] : {std::pair{"# model: ", robot}, std::pair{"# date: ", date}}) {
      const std::size_t at = text.find(key) + std::string{key}.size();
      text.replace(at, text.find('\n', at) - at, value);
    }
    std::ofstream{file("case/" + name)} << text;
  };
  begin("upright.csv", "2026-01-01T10:00:00Z");
  begin("upright_again.csv", "2026-01-01T10:05:00Z");
  begin("left_side.csv", "2026-01-01T10:10:00Z");
  begin("face_down.csv", "2026-01-02T10:00:00Z", "/dev/ttyUSB1");
  begin("right_side.csv", "2026-01-02T10:05:00Z");
  startVirtualRobot();
  const std::vector<std::string> resume{"record", "--robot", port(), "--out", file("case"), "--resume", "--yes"};
  ASSERT_EQ(gap(resume, seconds{60}), 0) << said_;
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kAnotherSession));
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kEarlierOnesAreOf));
  const json logs = json::parse(textOf(file("case/case.json")))["logs"];
  const double first = logs[0]["session_s"];
  EXPECT_NEAR(logs[2]["session_s"].get<double>() - first, 600, 2);
  EXPECT_NEAR(logs[4]["session_s"].get<double>() - first, 86'700, 2);

  std::filesystem::remove(file("case/case.json"));
  std::filesystem::remove(file("case/right_side.csv"));
  begin("face_down.csv", "2100-01-01T10:00:00Z");
  EXPECT_EQ(gap(resume, seconds{60}), 2) << said_;
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kClockSetBack));
  EXPECT_THAT(said_, testing::Not(testing::HasSubstr("5 of 5"))) << "it would move";
}

TEST_F(GapRecordShort, AFileThatIsNotARecordingIsKept) {
  std::filesystem::create_directories(file("case"));
  std::ofstream{file("case/face_down.csv")} << "mine";
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("case"), "--resume"}, seconds{10}), 2);
  EXPECT_EQ(textOf(file("case/face_down.csv")), "mine");
}

TEST_F(GapRecordShort, AResumedOneKeepsTheModelOfTheFirstCommand) {
  std::filesystem::create_directories(file("case"));
  std::filesystem::copy_file(DARWINOP_USUAL_MODEL, file("case/model.ini"));
  std::ofstream{file("case/standing.csv")} << "mine";  // of --floor, and checked before anything moves
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("case"), "--resume"}, seconds{10}), 2);
  EXPECT_THAT(said_, testing::HasSubstr(file("case/model.ini") + gap::messages::kModelOfFirstCommand));
  EXPECT_THAT(said_, testing::HasSubstr("standing.csv"));
}

TEST_F(GapRecordShort, AFolderThatCannotBeMadeIsNamedWithTheReason) {
  std::ofstream{file("taken")} << "a file";
  EXPECT_EQ(gap({"record", "--robot", "twin", "--out", file("taken/case")}, seconds{10}), 2);
  EXPECT_THAT(said_, testing::EndsWith(file("taken/case") + ": " + std::strerror(ENOTDIR) + "\n"));
}

TEST_F(GapRecordShort, AnExperimentThatIsKilledIsReportedWithTheSignal) {
  Program running{{program("darwinop-gap"), "record", "--robot", "twin", "--out", file("case")}, file("command.txt")};
  const std::string pid = std::to_string(running.pid());
  pid_t experiment = 0;
  const auto end = std::chrono::steady_clock::now() + patiently(seconds{60});
  while (!(std::ifstream{"/proc/" + pid + "/task/" + pid + "/children"} >> experiment))
    ASSERT_LT(std::chrono::steady_clock::now(), end) << running.output();
  ::kill(experiment, SIGKILL);
  EXPECT_EQ(running.wait(seconds{60}), 1);
  EXPECT_THAT(running.output(), testing::HasSubstr(gap::messages::kEndedBySignal + std::to_string(SIGKILL)));
}

// Its size limit stands for a full disk. The shared memory of the loop is a file also, which has to fit.
TEST_F(GapRecordShort, AFullDiskIsTheReasonThatIsReported) {
  const std::string limited = "trap '' XFSZ; ulimit -f 1024; exec \"$0\" \"$@\"";
  Program running{
      {"/bin/bash", "-c", limited, program("darwinop-gap"), "record", "--robot", "twin", "--out", file("case")},
      file("command.txt")};
  EXPECT_EQ(running.wait(seconds{60}), 1);
  EXPECT_THAT(running.output(), testing::HasSubstr(std::strerror(EFBIG)));
  EXPECT_THAT(running.output(), testing::HasSubstr(gap::messages::kIncomplete));
}

}  // namespace
}  // namespace darwinop
