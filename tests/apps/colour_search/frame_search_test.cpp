// What observers look for in the frames, and what is found.
#include "apps/colour_search/frame_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "hal/pixels/bgra_to_yuyv.hpp"
#include "monitor/search_message.hpp"
#include "remote/jpeg/live_pictures.hpp"

namespace darwinop::colour_search {
namespace {

using Json = nlohmann::json;
using monitor::foundText;
using monitor::Search;

constexpr int kWide = 320, kHigh = 240;
const Search kRedBall{};  // the search's own thresholds

/// A red box on a green lawn.
std::vector<std::uint8_t> lawnWithBox(int left, int top, int width, int height) {
  std::vector<std::uint8_t> bgra;
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      const bool red = x >= left && x < left + width && y >= top && y < top + height;
      const std::array<std::uint8_t, 4> pixel =
          red ? std::array<std::uint8_t, 4>{10, 10, 200, 255} : std::array<std::uint8_t, 4>{30, 150, 20, 255};
      bgra.insert(bgra.end(), pixel.begin(), pixel.end());
    }
  return bgra;
}

CameraFrame frameOf(const std::vector<std::uint8_t>& bgra, std::uint64_t number) {
  return {.sequence = number, .time = Nanos{0}, .width = kWide, .height = kHigh, .bgra = bgra};
}

TEST(FrameSearch, FindTheBallWhereItIs) {
  FrameSearch search;
  search.want({kRedBall});
  search.look(frameOf(lawnWithBox(100, 60, 41, 21), 7));
  const auto found = search.found(kRedBall, 7);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->centre, (Pixel{120, 70}));
  EXPECT_EQ(found->pixels, 41U * 21U);
  EXPECT_EQ((std::array{found->left, found->top, found->right, found->bottom}), (std::array{100, 60, 140, 80}));
  ASSERT_EQ(found->mask.size(), kWide / 8U * kHigh);
  EXPECT_EQ(found->mask[60 * 40 + 12], 0xF0) << "pixels 100 to 103";
  EXPECT_EQ(found->mask[59 * 40 + 12], 0x00);
  EXPECT_EQ(foundText(*found, false),
            R"({"type":"found","picture":7,"width":320,"height":240,"x":120,"y":70,"pixels":861,"percent":1.12109,)"
            R"("box":[100,60,140,80]})");
  const Json text = Json::parse(foundText(*found, true));
  const std::string mask = text["mask"];
  EXPECT_EQ(mask.size(), 12800U);
  EXPECT_EQ(mask.substr((60 * 40 + 12) / 3 * 4, 4), "8P//") << "f0 ff ff";
}

TEST(FrameSearch, FindInWhatACameraGives) {
  const std::vector<std::uint8_t> bgra = lawnWithBox(100, 60, 41, 21);
  std::vector<std::uint8_t> yuyv(2 * kWide * kHigh);
  pixels::bgraToYuyvRotated(bgra, kWide, kHigh, yuyv, 2 * kWide);
  FrameSearch search;
  search.want({kRedBall});
  search.look({.sequence = 1, .time = Nanos{0}, .width = kWide, .height = kHigh, .yuyv = yuyv});
  ASSERT_TRUE(search.found(kRedBall, 1).has_value());
  EXPECT_NEAR(search.found(kRedBall, 1)->centre.value_or(Pixel{}).x, 120, 1);
  yuyv.resize(100);
  search.look({.sequence = 2, .time = Nanos{0}, .width = kWide, .height = kHigh, .yuyv = yuyv});
  EXPECT_FALSE(search.found(kRedBall, 2).has_value()) << "half a picture";
}

TEST(FrameSearch, SayHowMuchThereIsWhenItIsNoBall) {
  FrameSearch search;
  const Search small{{}, {0, 1}};
  search.want({small});
  search.look(frameOf(lawnWithBox(100, 60, 41, 21), 1));
  EXPECT_FALSE(search.found(small, 1)->centre.has_value());
  EXPECT_EQ(search.found(small, 1)->pixels, 861U);
  search.look(frameOf(lawnWithBox(0, 0, 0, 0), 2));
  EXPECT_EQ(
      foundText(*search.found(small, 2), false),
      R"({"type":"found","picture":2,"width":320,"height":240,"x":null,"y":null,"pixels":0,"percent":0,"box":null})");
}

TEST(FrameSearch, LookForNoMoreThanObserversCanAskFor) {
  std::vector<Search> many;
  for (int hue = 0; hue < 40; ++hue) many.push_back({{.hue = hue / 2}, {}});
  FrameSearch search;
  search.want(many);
  const auto bgra = lawnWithBox(100, 60, 41, 21);
  search.look(frameOf(bgra, 1));
  EXPECT_TRUE(search.found(many[2 * FrameSearch::kMost - 1], 1).has_value()) << "equal ones count once";
  EXPECT_FALSE(search.found(many[2 * FrameSearch::kMost], 1).has_value());
  search.want({});
  search.look(frameOf(bgra, 2));
  EXPECT_FALSE(search.found(many[0], 2).has_value()) << "nobody asks any more";
}

TEST(FrameSearch, RememberThePicturesOfThisMoment) {
  FrameSearch search;
  search.want({kRedBall});
  for (std::uint64_t number = 1; number <= 10; ++number)
    search.look(frameOf(lawnWithBox(static_cast<int>(number) * 10, 60, 9, 9), number));
  EXPECT_EQ(search.found(kRedBall, 10)->left, 100);
  EXPECT_EQ(search.found(kRedBall, 9)->left, 90);
  EXPECT_FALSE(search.found(kRedBall, 2).has_value());
  EXPECT_FALSE(search.found(kRedBall, 0).has_value());
}

/// A camera that gives a picture as often as it is told.
struct ToldCamera final : FrameSource {
  explicit ToldCamera(const std::atomic<std::uint64_t>& told) : number{told} {}
  const std::atomic<std::uint64_t>& number;
  std::vector<std::uint8_t> bgra = lawnWithBox(100, 60, 41, 21);
  CameraFrame newest() override { return frameOf(bgra, number); }
  [[nodiscard]] CameraHealth health() const override { return {.seeing = true, .frames = number}; }
};

TEST(FrameSearch, KnowAPictureBeforeItCanBeShown) {
  FrameSearch search;
  search.want({kRedBall});
  std::atomic<std::uint64_t> number{1};
  remote::LivePictures pictures{std::make_unique<ToldCamera>(number),
                                {.now = [] { return Nanos{0}; },
                                 .say = {},
                                 .look_at = [&search](const CameraFrame& frame) { search.look(frame); }}};
  for (; number <= 3; ++number) {
    while (pictures.newest().sequence != number) std::this_thread::yield();
    EXPECT_TRUE(search.found(kRedBall, number).has_value()) << number;
  }
}

}  // namespace
}  // namespace darwinop::colour_search
