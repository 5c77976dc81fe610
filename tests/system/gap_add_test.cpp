// A case of the whole robot that gets more recordings, and what is not replaced.
#include "gap/record/kept_recording.hpp"
#include "gap_files.hpp"
#include "gap_recorder.hpp"
#include "system/gap_rig.hpp"

namespace darwinop {
namespace {

namespace fs = std::filesystem;

class GapAdd : public GapRig {
 protected:
  json caseJson() { return json::parse(textOf(file("case/case.json"))); }
};

TEST_F(GapAdd, AnotherDirectionAndTheFloorAreAddedToACase) {
  record("twin");
  json before = caseJson();
  before["note"] = "mine";
  std::ofstream{file("case/case.json")} << before;
  ASSERT_EQ(gap({"record", "--robot", "twin", "--add", "body_triangles", "--up", "-0.6,-0.8,0", "--out", file("case")},
                seconds{60}),
            0)
      << said_;
  json added = caseJson();
  ASSERT_EQ(added["logs"].size(), 6u);
  EXPECT_EQ(added["logs"][5]["file"], "body_triangles.csv");
  EXPECT_EQ(added["logs"][5]["up"], json::parse("[-0.6, -0.8, 0.0]"));
  added["logs"].erase(5);
  EXPECT_EQ(added, before) << "the rest is as it was";
  EXPECT_THAT(openSignals("darwin-op"), testing::IsEmpty());

  const std::vector<std::string> again{"record", "--robot", "twin", "--resume", "--floor", "--out", file("case")};
  ASSERT_EQ(gap(again, seconds{60}), 0) << said_;
  EXPECT_EQ(caseJson()["logs"][6]["setup"], "floor");
  EXPECT_EQ(caseJson()["note"], "mine");
  const std::string whole = textOf(file("case/case.json"));
  ASSERT_EQ(gap(again, seconds{60}), 0) << said_;
  EXPECT_EQ(textOf(file("case/case.json")), whole) << "nothing is missing";
}

TEST_F(GapAdd, ARecordingOfAnotherRobotIsNotAdded) {
  fs::create_directories(file("case"));
  const std::vector<std::string> words{"record", "--robot", "twin",  "--add",     "body_chirp",
                                       "--up",   "0,1,0",   "--out", file("case")};
  EXPECT_EQ(gap(words, seconds{10}), 2) << "there is no case";
  startVirtualRobot();
  recordUpright("/dev/ttyUSB0");
  EXPECT_EQ(gap(words, seconds{10}), 2);
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kOfAnotherRobot));
  std::vector<std::string> standing = words;
  standing[4] = "body_stand", standing[2] = port();
  EXPECT_EQ(gap(standing, seconds{10}), 2);
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kNotClamped));
  std::vector<std::string> flat = words;
  flat[6] = "0,0,0";
  EXPECT_EQ(gap(flat, seconds{10}), 2);
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kNotADirection));
}

// A robot that was not turned: the experiment always delivers the same recording.
TEST_F(GapAdd, WithoutQuestionsABadRecordingOfAPhysicalRobotIsNotAdded) {
  recordUpright("/dev/ttyUSB0");
  const std::string before = textOf(file("case/case.json"));
  fs::create_directories(file("bin"));
  fs::copy_file(program("darwinop-gap"), file("bin/darwinop-gap"));
  fs::create_directory_symlink(fs::path{program("")}.parent_path().parent_path() / "share", file("share"));
  const std::string experiment = file("bin/darwinop-experiment");
  std::ofstream{experiment} << "#!/bin/sh\nwhile [ \"$1\" != --record ]; do shift; done\ncp \"" << file("case/up.csv")
                            << "\" \"$2\"\n";
  fs::permissions(experiment, fs::perms::owner_all);
  startVirtualRobot();
  const auto add = [&](const std::string& up) {
    Program running{{"/usr/bin/env", "DARWINOP_MODELS=" + fs::path{DARWINOP_USUAL_MODEL}.parent_path().string(),
                     file("bin/darwinop-gap"), "record", "--robot", port(), "--add", "body_chirp", "--up", up, "--yes",
                     "--out", file("case")},
                    file("command.txt")};
    const int status = running.wait(seconds{20}).value_or(-1);
    said_ = running.output();
    return status;
  };
  EXPECT_EQ(add("1,0,0"), 1);
  EXPECT_THAT(said_, testing::HasSubstr(gap::messages::kUnusable));
  EXPECT_EQ(textOf(file("case/case.json")), before);
  EXPECT_EQ(add("0,1,0"), 0) << said_;
  EXPECT_EQ(caseJson()["logs"].size(), 2u);
}

TEST_F(GapAdd, AModelThatIsThereIsNotReplaced) {
  fs::create_directories(file("case"));
  std::ofstream{file("case/face_down.csv")} << "mine";  // ends the command before anything moves
  const auto refusal = [&](const std::string& model) {
    EXPECT_EQ(gap({"record", "--robot", "twin", "--resume", "--model", model, "--out", file("case")}, seconds{10}), 2);
    return said_;
  };
  robotWith("", "");  // writes hidden.ini
  const std::string model = textOf(file("hidden.ini"));
  std::ofstream{file("case/model.ini")} << model << "; mine\n";
  EXPECT_THAT(refusal(file("hidden.ini")), testing::HasSubstr(file("case/model.ini") + gap::messages::kOtherModel));
  EXPECT_EQ(textOf(file("case/model.ini")), model + "; mine\n");
  EXPECT_THAT(refusal(file("case/model.ini")), testing::HasSubstr("face_down.csv")) << "it is the model";
  std::ofstream{file("case/model.ini")} << model;
  EXPECT_THAT(refusal(file("hidden.ini")), testing::HasSubstr("face_down.csv")) << "it is the same";

  std::ofstream{file("darwin-op.xml")} << "<mujoco/>";  // beside hidden.ini
  std::ofstream{file("case/darwin-op.xml")} << "<mujoco model=\"mine\"/>";
  EXPECT_THAT(refusal(file("hidden.ini")), testing::HasSubstr(file("case/darwin-op.xml")));
  EXPECT_EQ(textOf(file("case/darwin-op.xml")), "<mujoco model=\"mine\"/>");
}

}  // namespace
}  // namespace darwinop
