// Pictures handed to replies: by a thread in real time, in lockstep without one.
#include <gmock/gmock.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "remote/jpeg/live_pictures.hpp"
#include "remote/jpeg/lockstep_pictures.hpp"
#include "remote/jpeg/scenes.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;

/// What a test does to the camera, from its own thread.
struct CameraControls {
  std::atomic<std::uint64_t> sequence{0};
  std::atomic<bool> seeing{true};
  std::atomic<int> width{kWholeImage.width};
  std::atomic<int> frames_taken{0}, looks{0};
};

/// A frame is grey all over, and its number tells the shade; the bytes are written anew for each, as a camera's are.
class GreyCamera final : public FrameSource {
 public:
  explicit GreyCamera(CameraControls& controls) : controls_{controls}, yuyv_(2 * pixelsOf(kWholeImage), 128) {}
  static int shadeOf(std::uint64_t sequence) { return 16 + static_cast<int>(sequence * 37 % 224); }

  CameraFrame newest() override {
    const std::uint64_t sequence = controls_.sequence;
    ++controls_.looks;
    if (sequence != painted_) {
      for (std::size_t luma = 0; luma < yuyv_.size(); luma += 2)
        yuyv_[luma] = static_cast<std::uint8_t>(shadeOf(sequence));
      painted_ = sequence;
      ++controls_.frames_taken;
    }
    return {sequence, 10ms * sequence, controls_.width, kWholeImage.height, {}, yuyv_};
  }
  [[nodiscard]] CameraHealth health() const override { return {controls_.seeing, controls_.sequence, 0, 0, 0}; }

 private:
  CameraControls& controls_;
  std::uint64_t painted_ = 0;
  PixelBytes yuyv_;
};

template <class Condition>
bool comesTrue(Condition&& condition) {
  const auto limit = std::chrono::steady_clock::now() + 20s;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

/// Pixels that are not of the one shade.
int pixelsOffShade(std::span<const std::uint8_t> jpeg, int shade, ImageSize size) {
  const PixelBytes bgra = decoded({jpeg.begin(), jpeg.end()}, size);
  int off = 0;
  for (std::size_t i = 0; i < bgra.size(); i += 4)
    if (std::abs(bgra[i] - shade) > 2 || std::abs(bgra[i + 1] - shade) > 2 || std::abs(bgra[i + 2] - shade) > 2) ++off;
  return off;
}

constexpr ImageSize kSmall{80, 60};
constexpr Nanos kNow = 1h;

struct LivePicturesTest : testing::Test {
  CameraControls camera;
  std::mutex mutex;
  std::vector<std::string> said;
  LivePictures pictures{std::make_unique<GreyCamera>(camera),
                        {.size = kSmall,
                         .quality = qualityOf(kSmall),
                         .now = [] { return kNow; },
                         .say =
                             [this](const std::string& sentence) {
                               const std::lock_guard lock{mutex};
                               said.push_back(sentence);
                             },
                         .look_every = 100us}};

  bool shows(std::uint64_t sequence) {
    return comesTrue([&] { return pictures.newest().sequence == sequence; });
  }
};

TEST_F(LivePicturesTest, AreBlackAndOfNoNumberBeforeTheFirst) {
  const JpegPicture picture = pictures.newest();
  EXPECT_EQ(picture.sequence, 0u);
  EXPECT_EQ(pixelsOffShade(picture.jpeg, 0, kSmall), 0);
}

TEST_F(LivePicturesTest, AreTheNewestWithItsNumberAndAge) {
  for (const std::uint64_t sequence : {1, 2, 7}) {
    camera.sequence = sequence;
    ASSERT_TRUE(shows(sequence));
    const JpegPicture picture = pictures.newest();
    EXPECT_EQ(picture.age, kNow - 10ms * sequence);
    EXPECT_EQ(pixelsOffShade(picture.jpeg, GreyCamera::shadeOf(sequence), kSmall), 0);
  }
}

TEST_F(LivePicturesTest, AreTheSameOneWhileNothingIsNew) {
  camera.sequence = 3;
  ASSERT_TRUE(shows(3));
  const JpegPicture first = pictures.newest();
  const int looks = camera.looks;
  ASSERT_TRUE(comesTrue([&] { return camera.looks >= looks + 3; }));
  const JpegPicture again = pictures.newest();
  EXPECT_EQ(again.sequence, 3u);
  EXPECT_EQ(again.jpeg.data(), first.jpeg.data());
}

TEST_F(LivePicturesTest, AreBlackAgainWhenTheCameraIsBlindAndNotWhenItSees) {
  camera.sequence = 3;
  ASSERT_TRUE(shows(3));
  camera.seeing = false;
  ASSERT_TRUE(shows(0));
  EXPECT_EQ(pixelsOffShade(pictures.newest().jpeg, 0, kSmall), 0);
  camera.sequence = 9;
  camera.seeing = true;
  EXPECT_TRUE(shows(9));
}

TEST_F(LivePicturesTest, AreNeverTornNorOlderThanTheLast) {
  constexpr std::uint64_t kFrames = 100;
  std::atomic<bool> done{false};
  std::thread painter{[&] {
    while (camera.sequence < kFrames) {
      const int taken = camera.frames_taken;
      ++camera.sequence;
      while (camera.frames_taken == taken) std::this_thread::yield();
    }
    done = true;
  }};
  std::uint64_t last = 0;
  int wrong = 0, older = 0, seen = 0;
  while (!done) {
    const JpegPicture picture = pictures.newest();
    if (picture.sequence == 0) continue;
    if (picture.sequence < last) ++older;
    if (picture.sequence != last) ++seen;
    last = picture.sequence;
    wrong += pixelsOffShade(picture.jpeg, GreyCamera::shadeOf(picture.sequence), kSmall);
  }
  painter.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(older, 0);
  EXPECT_GT(seen, 1);
}

TEST_F(LivePicturesTest, AreBlackAndSaySoOnceWhenTheCameraHasAnotherSize) {
  camera.width = 640;
  camera.sequence = 1;
  const auto told = [&] {
    const std::lock_guard lock{mutex};
    return said;
  };
  ASSERT_TRUE(comesTrue([&] { return !told().empty(); }));
  camera.sequence = 2;
  ASSERT_TRUE(comesTrue([&] { return camera.frames_taken == 2; }));
  EXPECT_EQ(pictures.newest().sequence, 0u);
  EXPECT_THAT(told(), testing::ElementsAre(testing::HasSubstr("640x240")));
}

TEST(LockstepPictures, AreThereAtOnce) {
  CameraControls camera;
  Nanos now = 1s;
  LockstepPictures pictures{std::make_unique<GreyCamera>(camera), kSmall, 80, [&now] { return now; }};
  EXPECT_EQ(pictures.newest().sequence, 0u);
  EXPECT_EQ(pixelsOffShade(pictures.newest().jpeg, 0, kSmall), 0);
  camera.sequence = 5;
  EXPECT_EQ(pictures.newest().sequence, 5u);
  now = 2s;
  const JpegPicture picture = pictures.newest();
  EXPECT_EQ(picture.age, 2s - 50ms);
  EXPECT_EQ(pixelsOffShade(picture.jpeg, GreyCamera::shadeOf(5), kSmall), 0);
  camera.seeing = false;
  EXPECT_EQ(pictures.newest().sequence, 0u);
}

}  // namespace
}  // namespace darwinop::remote
