// Output of the installer: line splitting, classification, limits, progress.
#include "window/transfer/console.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "window/transfer/installer_step.hpp"
#include "window/transfer/line_splitter.hpp"

namespace darwinop {
namespace {

using testing::ElementsAre;
using window::LineKind;

TEST(TransferConsole, SplitsLinesInAnyFragmentation) {
  window::LineSplitter cutter;
  std::vector<std::string> lines;
  const auto take = [&lines](std::string_view line) { lines.emplace_back(line); };
  for (const char* piece : {"one\ntw", "o", "\r\n", "10 %\r20 %\n\nlast"}) cutter.add(piece, take);
  EXPECT_THAT(lines, ElementsAre("one", "two", "20 %", ""));
  cutter.end(take);
  EXPECT_EQ(lines.back(), "last");
  lines.clear();
  for (int i = 0; i < 10; ++i) cutter.add(std::string(1000, 'a'), take);
  cutter.add("\nshort\n", take);
  EXPECT_THAT(lines, ElementsAre(std::string(window::LineSplitter::kLongest, 'a') + "…", "short"));
}

TEST(TransferConsole, DistinguishesErrorsFromMessages) {
  const auto kind = [](const char* line, LineKind before = LineKind::kMessage) {
    return window::classifyStderrLine(line, before);
  };
  EXPECT_EQ(kind("darwinop install: sending 12 kB"), LineKind::kMessage);
  EXPECT_EQ(kind("darwinop install: error: there is no folder"), LineKind::kError);
  EXPECT_EQ(kind("robot: walker runs. Ctrl-C stops it"), LineKind::kMessage);
  EXPECT_EQ(kind("robot: error: the robot's disk is too full"), LineKind::kError);
  EXPECT_EQ(kind("walker.cpp:3:7: warning: unused variable 'x'"), LineKind::kWarning);
  EXPECT_EQ(kind("    3 |   int x;", LineKind::kWarning), LineKind::kWarning);
  EXPECT_EQ(kind("walker.cpp:4:1: error: expected ';'"), LineKind::kError);
  EXPECT_EQ(kind("walker.cpp: In function 'int main()':"), LineKind::kMessage);
  EXPECT_EQ(kind("output of a controller on stderr"), LineKind::kError);
}

TEST(TransferConsole, KeepsTheLastLinesOnly) {
  window::Console console;
  for (std::size_t i = 0; i < window::Console::kMostLines + 10; ++i) console.add(LineKind::kOutput, std::to_string(i));
  EXPECT_EQ(console.begin(), 10U);
  EXPECT_EQ(console.at(10).text, "10");
  EXPECT_EQ(console.at(console.end() - 1).text, "2009");
  for (int i = 0; i < 2000; ++i) console.add(LineKind::kOutput, std::string(2000, 'a'));
  EXPECT_LE((console.end() - console.begin()) * 2000, window::Console::kMostBytes);
}

TEST(TransferConsole, ParsesValidStepsOnly) {
  const window::InstallerStep sending{.number = 4, .of = 5, .part = 0.42, .name = "sending 12 kB"};
  EXPECT_EQ(window::readStep("progress 4 5 0.420 sending 12 kB"), sending);
  const auto connecting = window::readStep("progress 2 5 - connecting to darwin@r");
  ASSERT_TRUE(connecting);
  EXPECT_EQ(connecting->part, std::nullopt);
  for (const char* line : {"", "progress", "progress 4", "progress 6 5 - x", "progress 0 5 - x", "progress 4 5 1.1 x",
                           "progress 4 5 nan x", "progress a 5 - x", "Progress 4 5 - x"})
    EXPECT_FALSE(window::readStep(line)) << line;
  const std::string key = "SHA256:" + std::string(43, 'A');
  EXPECT_EQ(window::readHostKey("host-key " + key), key);
  EXPECT_EQ(window::readHostKey("host-key " + key + "A"), "");
}

}  // namespace
}  // namespace darwinop
