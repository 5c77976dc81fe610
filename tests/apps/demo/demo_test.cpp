// `darwinop demo walk`: records a film on a PC without a display.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "apps/demo/walk.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"
#include "system/program.hpp"
#include "twin/render/png.hpp"

namespace darwinop::demo {
namespace {

using testing::HasSubstr;

/// Fraction of pixels that differ by more than video noise.
double changed(const twin::RenderedPicture& a, const twin::RenderedPicture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) count += std::abs(a.rgb[i] - b.rgb[i]) > 60 ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(a.rgb.size());
}

TEST(WalkDemo, RecordsTheRobotInSimulatedTime) {
  const TemporaryFolder folder;
  const std::string film = folder / "walk.mp4";
  const Outcome made = shell(
      "env -u DISPLAY -u WAYLAND_DISPLAY " DARWINOP_DEMO " walk --seconds 2 --fps 10 --size 160x120 --record " + film);
  ASSERT_EQ(made.status, 0) << made.said;
  EXPECT_THAT(made.said, HasSubstr("2.0 s simulated in"));

  ASSERT_EQ(shell("ffmpeg -v error -i " + film + " " + (folder / "frame_%02d.png")).status, 0);
  EXPECT_EQ(shell("ls " + (folder / "") + " | grep -c png").said, "20\n") << "10 per second of simulated time";
  const auto frame = [&](const char* number) {
    return twin::readPng(folder / ("frame_" + std::string{number} + ".png"));
  };
  EXPECT_GT(changed(frame("01"), frame("20")), 0.02) << "the robot stood up";
  EXPECT_GT(changed(frame("10"), frame("20")), 0.01) << "moving until the end";
}

/// A film that takes longer to make than a test to read what was printed.
std::vector<std::string> longFilm(const TemporaryFolder& folder) {
  return {"/usr/bin/env", "-u", "DISPLAY", "-u",      "WAYLAND_DISPLAY", DARWINOP_DEMO,      "walk",
          "--fps",        "25", "--size",  "160x120", "--record",        folder / "pictures"};
}

/// It receives SIGINT, where the default action would end it.
bool receivesCtrlC(const Program& running) {
  std::ifstream status{"/proc/" + std::to_string(running.pid()) + "/status"};
  for (std::string name; status >> name;)
    if (unsigned long long caught = 0; name == "SigCgt:" && status >> std::hex >> caught)
      return (caught >> (SIGINT - 1) & 1) != 0;
  return false;
}

TEST(WalkDemo, CtrlCEndsItAsStopped) {
  const TemporaryFolder folder;
  Program walk{longFilm(folder), folder / "walk.txt"};
  ASSERT_TRUE(walk.says(kStanceReached, std::chrono::seconds{60})) << walk.output();
  walk.kill(SIGINT);
  EXPECT_EQ(walk.wait(std::chrono::seconds{60}), 130) << walk.output();
  EXPECT_TRUE(std::filesystem::exists(folder / "pictures"));
}

TEST(WalkDemo, CtrlCBeforeTheRobotIsReadyEndsItAsStopped) {
  const TemporaryFolder folder;
  Program walk{longFilm(folder), folder / "walk.txt"};
  const auto end = std::chrono::steady_clock::now() + patiently(std::chrono::seconds{60});
  while (!receivesCtrlC(walk)) ASSERT_LT(std::chrono::steady_clock::now(), end) << walk.output();
  walk.kill(SIGINT);
  EXPECT_EQ(walk.wait(std::chrono::seconds{60}), 130) << walk.output();
}

TEST(WalkDemo, WithoutDisplayAWindowSuggestsAFilm) {
  const Outcome refused = shell("env -u DISPLAY -u WAYLAND_DISPLAY " DARWINOP_DEMO " walk --view");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr("--record"));
}

}  // namespace
}  // namespace darwinop::demo
