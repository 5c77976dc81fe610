// Pictures drawn by gnuplot, checked by their pixels.
#include <gmock/gmock.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "experiments/logs/plot/gnuplot.hpp"
#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/plot/plot.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"
#include "support/unprivileged.hpp"

namespace darwinop::plot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

#define DARWINOP_NEEDS_GNUPLOT() \
  if (process::findProgram("gnuplot").empty()) GTEST_SKIP() << messages::kGnuplotMissing

struct Size {
  int width, height;
};
/// Size from the first chunk of a PNG.
Size sizeOf(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(png.at(at + i));
    return value;
  };
  EXPECT_EQ(png.substr(1, 3), "PNG");
  return {number(16), number(20)};
}

/// Pixel count per colour, from every fourth pixel. gnuplot decodes the PNG file, so no other library is needed.
std::map<std::string, int> coloursOf(const std::string& path) {
  const std::string command = "gnuplot -e \"set table '" + path + ".txt'; plot '" + path +
                              "' binary filetype=png every 2:2 using 1:2:3 with rgbimage\" 2>/dev/null";
  EXPECT_EQ(shell(command).status, 0);
  std::ifstream table{path + ".txt"};
  std::map<unsigned long, int> numbers;
  for (std::string line; std::getline(table, line);) {
    if (line.size() < 5 || line.front() == '#') continue;
    char* at = line.data();
    for (int i = 0; i < 2; ++i) (void)std::strtod(at, &at);  // position
    unsigned long colour = 0;
    for (int i = 0; i < 3; ++i) colour = colour * 256 + std::strtoul(at, &at, 10);
    ++numbers[colour];
  }
  std::map<std::string, int> count;
  for (const auto& [colour, pixels] : numbers) {
    char text[16];
    (void)std::snprintf(text, sizeof text, "#%06lX", colour);
    count[text] = 4 * pixels;
  }
  return count;
}

/// One wave per colour, for the first `colours` colours, each with another phase.
Figure waves(std::size_t colours, const std::string& text = "wave") {
  Figure figure{text, text, {{text, text, text, text, text, text}}, {}, {{text, text, {}}}};
  for (std::size_t c = 0; c < colours; ++c) {
    Curve curve;
    curve.label = text;
    curve.colour = c;
    for (int i = 0; i <= 200; ++i) {
      curve.x.push_back(0.01 * i);
      curve.y.push_back(std::sin(0.05 * i + static_cast<double>(c)));
    }
    figure.panels[0].curves.push_back(curve);
  }
  return figure;
}

TEST(Picture, HasItsSizeAndEveryCurveInItsColour) {
  DARWINOP_NEEDS_GNUPLOT();
  const TemporaryFolder folder;
  const Figure figure = waves(3);
  ASSERT_EQ(drawPicture(figure, folder / "a.png"), "");
  const Size size = sizeOf(textOf(folder / "a.png"));
  EXPECT_EQ(size.width, kPictureWidth);
  EXPECT_EQ(size.height, pictureHeight(figure));
  const auto colours = coloursOf(folder / "a.png");
  // A curve is 860 pixels wide and about 2 high; text in its colour has fewer than 100 pixels.
  for (const char* colour : {"#0072B2", "#E69F00", "#000000"}) {
    ASSERT_TRUE(colours.contains(colour)) << colour;
    EXPECT_GT(colours.at(colour), 400) << colour;
  }
  EXPECT_FALSE(colours.contains("#009E73")) << "no fourth curve";
}

TEST(Picture, DrawsALineAtAMark) {
  Figure figure = waves(1);
  EXPECT_THAT(gnuplotScript(figure), Not(HasSubstr("set arrow")));  // no message
  figure.marks = {0.5, 1};
  EXPECT_THAT(gnuplotScript(figure), HasSubstr("set arrow from 1, graph 0 to 1, graph 1 nohead"));
}

TEST(Picture, LeavesGaps) {
  DARWINOP_NEEDS_GNUPLOT();
  const TemporaryFolder folder;
  Figure figure = waves(1);
  ASSERT_EQ(drawPicture(figure, folder / "whole.png"), "");
  for (std::size_t i = 50; i < 150; ++i) figure.panels[0].curves[0].y[i] = NAN;
  ASSERT_EQ(drawPicture(figure, folder / "gap.png"), "");
  const double share =
      coloursOf(folder / "gap.png").at("#0072B2") / static_cast<double>(coloursOf(folder / "whole.png").at("#0072B2"));
  // Half of the samples are missing. A line across the gap would keep more than 0.8 of the pixels.
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.65);
}

TEST(Picture, TextsOfALogAreNotInterpreted) {
  DARWINOP_NEEDS_GNUPLOT();
  const TemporaryFolder folder;
  const std::string flag = folder / "flag";
  for (const std::string& text :
       {"`touch " + flag + "`", "'; system('touch " + flag + "'); '", "\"; !touch " + flag, "a\n!touch " + flag + "\n",
        std::string{"it's {/Symbol a}_2 \\ @a $d0 %s EOD \xFF"}, "\\'; system('touch " + flag + "') #"}) {
    EXPECT_EQ(drawPicture(waves(1, text), folder / "a.png"), "") << text;
    EXPECT_FALSE(std::filesystem::exists(flag)) << text;
    EXPECT_EQ(sizeOf(textOf(folder / "a.png")).width, kPictureWidth);
  }
}

TEST(Picture, DrawsAFigureWithoutAnyValue) {
  DARWINOP_NEEDS_GNUPLOT();
  const TemporaryFolder folder;
  Figure figure = waves(1);
  for (double& y : figure.panels[0].curves[0].y) y = NAN;
  EXPECT_EQ(drawPicture(figure, folder / "a.png"), "");
}

TEST(Picture, ReplacesAFileInAFolderThatIsNotWritable) {
  DARWINOP_NEEDS_GNUPLOT();
  const TemporaryFolder folder;
  if (geteuid() == 0) {
    ASSERT_EQ(chown((folder / ".").c_str(), Unprivileged::kUser, Unprivileged::kUser), 0);
  }
  const Unprivileged user;
  std::ofstream{folder / "a.png"} << "old";
  ASSERT_EQ(chmod((folder / ".").c_str(), 0555), 0);
  EXPECT_EQ(drawPicture(waves(1), folder / "a.png"), "");
  EXPECT_EQ(sizeOf(textOf(folder / "a.png")).width, kPictureWidth);
  EXPECT_EQ(chmod((folder / ".").c_str(), 0755), 0);
}

/// Two logs and the output of plotCommand.
class PlotCommand : public testing::Test {
 protected:
  PlotCommand() {
    write("a.csv", 1);
    write("b.csv", -1);
  }
  void write(const std::string& name, int sign) const {
    std::ofstream file{folder_ / name};
    file << "t_s,pos_rad\n";
    for (int i = 0; i < 50; ++i) file << 0.1 * i << ',' << sign * 0.02 * i << '\n';
  }
  [[nodiscard]] PlotOptions options(const std::string& output = "") const {
    return {{folder_ / "a.csv", folder_ / "b.csv"}, output, {}, ""};
  }
  TemporaryFolder folder_;
};

TEST_F(PlotCommand, OverlaysLogsInPictureAndPage) {
  DARWINOP_NEEDS_GNUPLOT();
  testing::internal::CaptureStdout();
  EXPECT_EQ(plotCommand(options(folder_ / "both.png")), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), folder_ / "both.html" + "\n" + (folder_ / "both.png") + "\n");
  const auto colours = coloursOf(folder_ / "both.png");
  EXPECT_GT(colours.at("#0072B2"), 400);
  EXPECT_GT(colours.at("#E69F00"), 400);
  EXPECT_THAT(textOf(folder_ / "both.html"), HasSubstr("\"label\":\"b\",\"log\":1,\"colour\":1"));
}

TEST_F(PlotCommand, WithoutGnuplotWritesThePageAndNamesThePackage) {
  const std::string path = getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  std::ofstream{folder_ / "old.png"} << "old";
  testing::internal::CaptureStderr();
  EXPECT_EQ(plotCommand(options(folder_ / "old.png")), 1);
  EXPECT_EQ(textOf(folder_ / "old.png"), "old");
  EXPECT_EQ(plotCommand(options()), 1);
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(messages::kGnuplotMissing));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "a.html")) << "named after the first log";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

TEST_F(PlotCommand, ReportsAWriteError) {
  try {
    (void)plotCommand(options(folder_ / "none/a"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("none/a.html: No such file or directory; choose another path with -o"));
  }
}

TEST_F(PlotCommand, WritesNothingForAnInvalidLog) {
  std::ofstream{folder_ / "b.csv"} << "t_s,pos_rad\n0,zero\n";
  EXPECT_THROW((void)plotCommand(options(folder_ / "both")), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "both.html"));
}

}  // namespace
}  // namespace darwinop::plot
