// darwinop motion: output, files, exit codes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "experiments/run/recorded.hpp"
#include "hal/text_file.hpp"
#include "managers/motion/pages.hpp"
#include "managers/motion_text/motion_file.hpp"
#include "managers/motion_watch/motion_watch.hpp"
#include "managers/motion_watch/posture.hpp"
#include "motion_messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"
#include "system/program.hpp"

namespace darwinop::motion {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class MotionCommand : public testing::Test {
 protected:
  /// Returns the exit code; the output is in `output_`.
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), DARWINOP_MOTION);
    Program program{words, folder_ / "output"};
    const int code = program.wait(std::chrono::seconds{60}).value_or(-1);
    output_ = program.output();
    return code;
  }
  /// A binary file with one page, 12.
  std::string binaryFile() {
    PageFile pages = emptyFile();
    pages[12] = pageOf({stepTo(2048, 125), stepTo(2048, 125)}, 32);
    pages[12].name = {'r', 'k'};
    writeMotionFile(folder_ / "motion.bin", {pages, false});
    return folder_ / "motion.bin";
  }
  static std::vector<std::uint8_t> bytesOf(const std::string& path) { return readBytes(path); }

  TemporaryFolder folder_;
  std::string output_;
};

TEST_F(MotionCommand, ListsAndShows) {
  const std::string file = binaryFile();
  EXPECT_EQ(run({"list", file}), 0);
  EXPECT_THAT(output_, EndsWith("\n  12  rk                 2       1     -     -     2.048 s\n"));
  EXPECT_EQ(std::ranges::count(output_, '\n'), 2) << "a heading and one page";
  EXPECT_EQ(run({"show", file, "12"}), 0);
  EXPECT_THAT(output_,
              HasSubstr("page 12 \"rk\": 2.048 s, repeat 1, next -, exit -, acceleration 0.256 s, speed 32\n"));
  EXPECT_THAT(output_, HasSubstr("move, s           1.000    1.000\n"));
  EXPECT_THAT(output_, HasSubstr("Head               0.00     0.00      32\n"));
  EXPECT_EQ(run({"show", file, "13"}), 2);
  EXPECT_THAT(output_, HasSubstr("page 13 is empty"));
}

TEST_F(MotionCommand, ConvertsThereAndBack) {
  const std::string file = binaryFile(), text = folder_ / "a", back = folder_ / "b";
  EXPECT_EQ(run({"convert", file, text}), 0) << output_;
  EXPECT_EQ(run({"convert", text, back}), 0) << output_;
  EXPECT_TRUE(isText(bytesOf(text)));
  EXPECT_EQ(bytesOf(back), bytesOf(file));
  EXPECT_EQ(run({"convert", file, folder_ / "no such folder/a"}), 2);
  EXPECT_THAT(output_, AllOf(HasSubstr(folder_ / "no such folder/a"), HasSubstr(std::strerror(ENOENT))));
}

TEST_F(MotionCommand, ConvertsTheVendorsFileThereAndBack) {
  if (!std::filesystem::exists(vendorsFile())) GTEST_SKIP() << "the vendor's motion file is not available";
  ASSERT_EQ(run({"convert", vendorsFile(), folder_ / "a"}), 0) << output_;
  ASSERT_EQ(run({"convert", folder_ / "a", folder_ / "b"}), 0) << output_;
  EXPECT_EQ(bytesOf(folder_ / "b"), bytesOf(vendorsFile()));
}

TEST_F(MotionCommand, CheckReportsByItsExitCode) {
  const std::string file = binaryFile();
  EXPECT_EQ(run({"check", file}), 0);
  EXPECT_THAT(output_, StartsWith(file + ": 1 "));
  std::vector<std::uint8_t> bytes = bytesOf(file);
  bytes[12 * kPageBytes + 70] ^= 1U;
  std::ofstream{file, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<std::streamsize>(bytes.size()));
  EXPECT_EQ(run({"check", file}), 1);
  EXPECT_THAT(output_, HasSubstr("page 12, byte 6175: wrong checksum"));
  std::ofstream{file} << "darwinop motion 1\n[page 1]\nNeck = x\n";
  EXPECT_EQ(run({"check", file}), 1);
  EXPECT_THAT(output_, HasSubstr(file + ", line 3, page 1: Neck, step 1: 'x' is not an angle"));
  EXPECT_EQ(run({"check", folder_ / "none"}), 2);
}

TEST_F(MotionCommand, CreatesAndMirrorsAPage) {
  const std::string file = folder_ / "bow.txt", both = folder_ / "both.txt";
  EXPECT_EQ(run({"new", "--name", "bow", "--out", file}), 0) << output_;
  EXPECT_EQ(run({"check", file}), 0) << output_;
  EXPECT_EQ(run({"new", "--name", "bow", "--out", file}), 2) << "exists";
  EXPECT_THAT(output_, HasSubstr(file + ": "));
  EXPECT_EQ(run({"new", "--name", "a\"b", "--out", folder_ / "c"}), 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c"));
  EXPECT_EQ(run({"mirror", file, "1", "--to", "2", "--out", both}), 0) << output_;
  const PageFile pages = readMotionFile(both).pages;
  EXPECT_TRUE(isText(bytesOf(both)));
  EXPECT_EQ(pages[1].nameText(), "bow");
  for (const JointRow& joint : kJointTable) EXPECT_EQ(pages[1].step[0].position.at(joint.id), joint.start);
  EXPECT_EQ(pages[2].step[0].position[1], 4096 - row(Joint::kShoulderL).start);
  EXPECT_EQ(run({"mirror", both, "1", "--out", both}), 0) << "onto itself";
  EXPECT_EQ(readMotionFile(both).pages[1], pages[2]);
}

TEST_F(MotionCommand, OwnSelectsTheBuiltInPages) {
  EXPECT_EQ(run({"list", "own"}), 0);
  EXPECT_THAT(output_, HasSubstr("\n   9  "));
  EXPECT_EQ(run({"check", "own"}), 0) << output_;
  EXPECT_THAT(output_, StartsWith("own: "));
  EXPECT_EQ(run({"convert", "own", folder_ / "own.bin"}), 0) << output_;
  EXPECT_FALSE(isText(bytesOf(folder_ / "own.bin")));
  EXPECT_EQ(run({"convert", "own", folder_ / "own.txt"}), 0) << output_;
  EXPECT_TRUE(isText(bytesOf(folder_ / "own.txt"))) << "as the name of the file says";
  EXPECT_EQ(run({"mirror", "own", "9", "--to", "200", "--out", folder_ / "own.txt"}), 0) << output_;
  EXPECT_EQ(readMotionFile(folder_ / "own.txt").pages[9], readMotionFile(folder_ / "own.bin").pages[9]);
  EXPECT_EQ(run({"show", "own", "9"}), 0) << output_;
}

TEST_F(MotionCommand, PlotDrawsThePageAndItsSuccessors) {
  PageFile pages = emptyFile();
  pages[12] = pageOf({stepTo(2048, 125), stepTo(2148, 125)}, 32);
  pages[12].next = 13;
  pages[13] = pageOf({stepTo(2048, 50)});
  pages[13].slopes[19] = 0x77;
  writeMotionFile(folder_ / "two.bin", {pages, false});
  const std::string out = folder_ / "two.html";
  if (!DARWINOP_CAN_PLOT) {
    EXPECT_EQ(run({"plot", folder_ / "two.bin", "12", "--out", out}), 2);
    EXPECT_THAT(output_, HasSubstr("PC"));
    return;
  }
  ASSERT_EQ(run({"plot", folder_ / "two.bin", "12", "--out", out}), 0) << output_;
  const std::string page = darwinop::textOf(out);
  EXPECT_THAT(page, HasSubstr("\"Neck, P 32 8\""));
  EXPECT_THAT(page, HasSubstr("\"marks\":[0,1.024,2.048]")) << "starts of steps";
  EXPECT_EQ(run({"plot", folder_ / "two.bin", "12", "--out", folder_ / "two.txt"}), 2);
  EXPECT_THAT(output_, AllOf(HasSubstr(folder_ / "two.txt"), HasSubstr(".png"), HasSubstr(".html")));
  EXPECT_EQ(run({"plot", folder_ / "two.bin", "14", "--out", out}), 2);
}

/// Runs separate programs, because there is one robot per process.
class MotionPlay : public MotionCommand {
 protected:
  MotionPlay() {
    unsetenv("DARWINOP_ROBOT");
    // No terminal for interactive questions.
    EXPECT_NE(std::freopen("/dev/null", "r", stdin), nullptr);
  }
};

TEST_F(MotionPlay, PrintsPlanAndResult) {
  EXPECT_EQ(run({"play", "own", "9", "--robot", "virtual", "--record", folder_ / "log.csv"}), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("page 9 \""));
  EXPECT_THAT(output_, HasSubstr("(LegLower"));
  EXPECT_THAT(output_, HasSubstr("on: virtual\n"));
  EXPECT_THAT(output_, HasSubstr("\nLegLowerR  "));
  EXPECT_THAT(output_,
              AllOf(HasSubstr(MotionWatch::kNoFaults), HasSubstr(" " + std::string{textOf(Posture::kStands)} + "\n")));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "log.csv"));
}

// Its size limit stands for a full disk. The shared memory of the loop is a file also, which has to fit.
TEST_F(MotionPlay, AMotionThatCouldNotBeRecordedInFullFails) {
  const std::string limited = "trap '' XFSZ; ulimit -f 256; exec \"$0\" \"$@\"", log = folder_ / "log.csv";
  Program program{{"/bin/bash", "-c", limited, DARWINOP_MOTION, "play", "own", "9", "9", "9", "9", "--robot", "virtual",
                   "--record", log},
                  folder_ / "output"};
  EXPECT_EQ(program.wait(std::chrono::seconds{60}), 1);
  EXPECT_THAT(program.output(), AllOf(HasSubstr(experiments::kRecordedInPart + log), HasSubstr(std::strerror(EFBIG))));
}

TEST_F(MotionPlay, ReportsTheLeadInOfADistantPage) {
  PageFile pages = emptyFile();
  pages[1] = pageOf({stepTo(2048, 2)});
  writeMotionFile(folder_ / "far.bin", {pages, false});
  EXPECT_EQ(run({"play", folder_ / "far.bin", "1", "--robot", "virtual"}), 0) << output_;
  EXPECT_THAT(output_, AllOf(HasSubstr("129.8"), HasSubstr("(LegLowerL)"), HasSubstr("2.8 s\n")));
  EXPECT_THAT(output_, HasSubstr(MotionWatch::kNoFaults)) << "slow enough for the safety layer";
}

TEST_F(MotionPlay, PlaysAMotionFile) {
  const std::string file = folder_ / "nod";
  std::ofstream{file} << "#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,1\n00:00:500,B,0.5\n";
  EXPECT_EQ(run({"play", file, "--robot", "virtual"}), 0) << output_;
  EXPECT_THAT(output_, AllOf(HasSubstr("nod: 0.5 s"), HasSubstr("57.1"), HasSubstr("(Neck)")));
  EXPECT_THAT(output_, HasSubstr(" 1.8 s"));
  EXPECT_EQ(run({"play", file, "3", "--robot", "virtual"}), 2) << "it has no pages";
}

TEST_F(MotionPlay, NothingMovesAfterAnError) {
  EXPECT_EQ(run({"play", "own", "--robot", "virtual"}), 2);
  EXPECT_THAT(output_, AllOf(HasSubstr("PAGE"), HasSubstr("darwinop motion list own")));
  EXPECT_EQ(run({"play", binaryFile(), "12", "13", "--robot", "virtual"}), 2);
  EXPECT_THAT(output_, HasSubstr("page 13 is empty"));
  EXPECT_EQ(run({"play", "own", "9", "--robot", "nonsense"}), 2);
  EXPECT_THAT(output_, HasSubstr("twin[:MODEL]"));
  EXPECT_EQ(run({"play", "own", "9", "--robot", "virtual", "--record", folder_ / "none/log.csv"}), 2);
}

TEST_F(MotionPlay, ARealRobotNeedsYesAndReceivesNothing) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master) + unlockpt(master), 0);
  EXPECT_EQ(run({"play", "own", "9", "--robot", ptsname(master)}), 3);
  EXPECT_THAT(output_, HasSubstr("page 9 \""));
  EXPECT_THAT(output_, HasSubstr("--yes"));
  char byte = 0;
  EXPECT_LT(read(master, &byte, 1), 1) << "a byte was sent";
  close(master);
}

TEST_F(MotionPlay, CtrlCEndsAPageThatNeverEnds) {
  PageFile pages = emptyFile();
  pages[1] = pageOf({stepTo(2048, 125), stepTo(2000, 125)});
  pages[1].next = 1;
  writeMotionFile(folder_ / "ring.bin", {pages, false});
  Program program{{DARWINOP_MOTION, "play", folder_ / "ring.bin", "1", "--robot", "virtual"}, folder_ / "output"};
  ASSERT_TRUE(program.says(kReady, std::chrono::seconds{60}));
  program.kill(SIGINT);
  EXPECT_EQ(program.wait(std::chrono::seconds{60}), 130);
  EXPECT_THAT(program.output(), HasSubstr(kRepeatsForever));
  EXPECT_THAT(program.output(), HasSubstr(kStoppedOnRequest));
}

TEST_F(MotionCommand, InvalidArgumentsAreReported) {
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"show", "x", "256"}), 2);
  EXPECT_EQ(run({"list", folder_ / "none"}), 2);
  EXPECT_THAT(output_, EndsWith((folder_ / "none") + kCannotOpenFile + "\n"));
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(run({"list", folder_ / "pipe"}), 2);
  EXPECT_THAT(output_, AllOf(HasSubstr(folder_ / "pipe"), HasSubstr(kPipeInsteadOfFile)));
  EXPECT_EQ(run({"mirror", "--help"}), 0);
  EXPECT_THAT(output_, HasSubstr("Example:"));
}

}  // namespace
}  // namespace darwinop::motion
