// `darwinop twin view` as a user runs it: films without a display, a window on one.
#include <gmock/gmock.h>
#include <signal.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "hal/process/child_process.hpp"
#include "safety/start_pose.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"
#include "support/x_server.hpp"
#include "twin/render/png.hpp"
#include "twin/render/support.hpp"

namespace darwinop::twin {
namespace {

using testing::HasSubstr;

const std::string kTwin = DARWINOP_BIN "/darwinop-twin";

class View : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(View, RecordsAVideoOfTheRequestedLength) {
  const std::string film = folder_ / "film.mp4";
  const Outcome made = shell(kTwin + " view --record " + film + " --seconds 2 --fps 25 --size 160x120");
  EXPECT_EQ(made.status, 0) << made.said;
  EXPECT_THAT(made.said, HasSubstr("50 pictures"));
  const Outcome probed =
      shell("ffprobe -v error -count_frames -show_entries stream=nb_read_frames,duration -of csv=p=0 " + film);
  EXPECT_EQ(probed.said, "2.000000,50\n");
}

TEST_F(View, ShowsTheMotionOfTheController) {
  const std::string film = folder_ / "film";
  const Outcome made =
      shell(kTwin + " view --record " + film + " --seconds 3 --camera head --fps 10 --size 64x48 " DARWINOP_CONTROLLER);
  EXPECT_EQ(made.status, 0) << made.said;
  EXPECT_THAT(made.said, HasSubstr("30 pictures"));
  EXPECT_THAT(made.said, HasSubstr("report: "));  // the controller ran and ended normally
  EXPECT_THAT(made.said, testing::Not(HasSubstr(safety::kNotUpright))) << "the body lies still when the port opens";
  EXPECT_NE(readPng(film + "/frame_00001.png").rgb, readPng(film + "/frame_00030.png").rgb);  // the head moved
}

TEST_F(View, HandsWhatFollowsTheDashesToTheController) {
  const std::string film = folder_ / "film";
  EXPECT_THAT(shell(kTwin + " view --record " + film + " --seconds 1 --size 32x32 /bin/echo -- --seconds 60").said,
              HasSubstr("--seconds 60\n"));
}

TEST_F(View, EndsWithTheStatusOfAControllerThatCannotRun) {
  const Outcome made = shell(kTwin + " view --record " + (folder_ / "film") + " --size 32x32 /no/such/controller");
  EXPECT_EQ(made.status, 2) << made.said;
  EXPECT_THAT(made.said, HasSubstr("there is no controller /no/such/controller"));
}

TEST_F(View, WithoutDisplaySuggestsARecording) {
  const Outcome made = shell("env -u DISPLAY -u WAYLAND_DISPLAY " + kTwin + " view");
  EXPECT_EQ(made.status, 2);
  EXPECT_THAT(made.said, HasSubstr("--record"));
  EXPECT_EQ(std::count(made.said.begin(), made.said.end(), '\n'), 1) << made.said;
}

TEST_F(View, WithoutOpenGlNamesTheReason) {
  const Outcome made = shell("DARWINOP_TWIN_GL=off " + kTwin + " view --record " + (folder_ / "film"));
  EXPECT_EQ(made.status, 2);
  EXPECT_THAT(made.said, HasSubstr("DARWINOP_TWIN_GL"));
}

TEST_F(View, ExplainsAWrongArgument) {
  EXPECT_THAT(shell(kTwin + " view --size 640").said, HasSubstr("WIDTHxHEIGHT"));
  EXPECT_THAT(shell(kTwin + " view --camera nose").said, HasSubstr("head"));
  EXPECT_THAT(shell(kTwin + " view --model nonesuch --record " + (folder_ / "f")).said, HasSubstr("webots-2013"));
  EXPECT_THAT(shell(kTwin + " picture robot.jpg").said, HasSubstr(".png"));
}

std::size_t colours(const RenderedPicture& p) {
  std::set<std::array<std::uint8_t, 3>> seen;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) seen.insert({p.at(x, y)[0], p.at(x, y)[1], p.at(x, y)[2]});
  return seen.size();
}

TEST_F(View, OpensAWindowThatShowsTheRobotAndCloses) {
  const XServer display;
  ASSERT_NE(display.name(), "") << "Xvfb does not start";
  // Mesa's window driver leaks 112 bytes when it is unloaded; an unloaded module has no name to suppress.
  process::ChildProcess view{{.command = {kTwin, "view", "--size", "800x600"},
                              .environment = {"DISPLAY=" + display.name(), "ASAN_OPTIONS=detect_leaks=0"}}};
  const std::string shot = folder_ / "shot.png";
  std::size_t seen = 0;
  for (int attempt = 0; attempt < 40 && seen < 100; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds{250});
    shell("ffmpeg -y -loglevel error -f x11grab -video_size 800x600 -i " + display.name() + " -frames:v 1 " + shot);
    if (std::filesystem::exists(shot)) seen = colours(readPng(shot));
  }
  EXPECT_GE(seen, 100U);  // the screen of a server without windows is black
  if (const char* const keep = std::getenv("DARWINOP_KEEP_SHOT")) std::filesystem::copy_file(shot, keep);
  view.signal(SIGINT);
  EXPECT_EQ(describe(view.wait()), "with exit code 0");
}

}  // namespace
}  // namespace darwinop::twin
