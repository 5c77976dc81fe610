// Recording of films: folder of pictures, ffmpeg, error messages.
#include "twin/render/film.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"
#include "twin/render/png.hpp"
#include "twin/render/support.hpp"
#include "twin/render/test_pattern.hpp"
#include "twin/view/screen.hpp"
#include "twin/view/watched_body.hpp"

namespace darwinop::twin {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& path, int width, int height) {
  std::string note;
  try {
    makeFilm(path, width, height, 30, note);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "taken";
}

TEST(Film, OfAnUnsupportedTypeIsRefused) {
  EXPECT_THAT(refusal("run.avi", 640, 480), HasSubstr("'run.avi': give a file name.mp4 or .mkv, or a folder"));
  EXPECT_FALSE(std::filesystem::exists("run.avi"));
}

TEST(Film, AFolderGetsANumberedPictureForEveryPose) {
  const TemporaryFolder folder;
  std::string note;
  const auto film = makeFilm(folder / "deep/film", 16, 16, 30, note);
  for (unsigned i = 0; i < 3; ++i) film->add(testPattern(16, 16, "", i));
  film->finish();
  EXPECT_EQ(note, "");
  EXPECT_EQ(readPng(folder / "deep/film/frame_00003.png").rgb, testPattern(16, 16, "", 2).rgb);
  EXPECT_FALSE(std::filesystem::exists(folder / "deep/film/frame_00004.png"));
}

TEST(Film, TwoFilmsDoNotMixInOneFolder) {
  const TemporaryFolder folder;
  std::string note;
  makeFilm(folder / "film", 16, 16, 30, note)->add(testPattern(16, 16, ""));
  EXPECT_THAT(refusal(folder / "film", 16, 16),
              testing::AllOf(HasSubstr(folder / "film"), HasSubstr("frame_00001.png")));
}

TEST(Film, AVideoOfOddSizeIsRefusedAndAFolderIsNot) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "film.mp4", 33, 16), HasSubstr("even"));
  EXPECT_EQ(refusal(folder / "film", 33, 16), "taken");
}

TEST(Film, WithoutFfmpegTheVideoBecomesAFolderWithANote) {
  const TemporaryFolder folder;
  const Environment none{"PATH", folder / ""};
  std::string note;
  const auto film = makeFilm(folder / "film.mp4", 16, 16, 25, note);
  film->add(testPattern(16, 16, ""));
  film->finish();
  EXPECT_THAT(note, testing::AllOf(HasSubstr("apt-get install ffmpeg"), HasSubstr("-framerate 25")));  // no message
  EXPECT_TRUE(std::filesystem::exists(folder / "film/frame_00001.png"));
}

TEST(Film, AVideoThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  std::string note;
  const auto film = makeFilm(folder / "no/such/folder.mp4", 16, 16, 25, note);
  EXPECT_THROW(
      {
        for (int i = 0; i < 10'000; ++i) film->add(testPattern(16, 16, ""));
        film->finish();
      },
      std::runtime_error);
}

TEST(Film, IsFinishedByTheRobotsClockHoweverLateItIsDrawn) {
  const TemporaryFolder folder;
  RobotBody body = usualBody();
  ShowOptions options;
  options.record = folder / "film";
  options.seconds = 0.1;  // 3 pictures
  options.width = options.height = 32;
  const auto screen = makeScreen(options, *body.mujocoModel(), {});
  const auto ring = std::make_unique<PoseRing>();
  for (int i = 0; i < 2; ++i) ring->push(poseOf(body));
  screen->draw(*ring, "");
  EXPECT_FALSE(screen->isFinished());
  for (int i = 0; i < 2; ++i) ring->push(poseOf(body));  // two are pending, the requested time has passed
  screen->draw(*ring, "");
  EXPECT_TRUE(screen->isFinished());
  screen->finish(*ring, [] { return false; });
  EXPECT_TRUE(std::filesystem::exists(folder / "film/frame_00003.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "film/frame_00004.png"));
}

TEST(WatchedBody, PushesAPoseForEveryPictureOfTheFilm) {
  auto body = std::make_unique<RobotBody>(readModel(findModel("darwin-op")));
  WatchedBody watched{std::move(body), 25};
  for (int i = 0; i < 500; ++i) watched.step(std::chrono::milliseconds{2}, Drives{});
  Pose pose;
  int count = 0;
  for (; watched.poses().pop(pose); ++count) EXPECT_NEAR(pose.time_s, count / 25.0, 0.0021);  // one step late at most
  EXPECT_EQ(count, 26);
}

TEST(PoseRing, DropsAndCountsWhatDoesNotFit) {
  const auto ring = std::make_unique<PoseRing>();
  for (std::uint32_t i = 0; i < PoseRing::kCapacity + 2; ++i) ring->push(Pose{.time_s = i * 1.0});
  EXPECT_EQ(ring->dropped(), 2U);
  Pose pose;
  ASSERT_TRUE(ring->pop(pose));
  EXPECT_EQ(pose.time_s, 0);
}

}  // namespace
}  // namespace darwinop::twin
