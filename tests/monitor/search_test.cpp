// What is looked for in the pictures, and what is found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "hal/pixels/bgra_to_yuyv.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "monitor/messages.hpp"
#include "monitor/search_message.hpp"

namespace darwinop::monitor {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

constexpr int kWide = 320, kHigh = 240;
const Search kRedBall{};  // the finder's own thresholds

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

TEST(MonitorSearch, IsReadMemberByMember) {
  std::string why;
  const auto wishes = readWishes(
      R"({"camera": 10, "find": {"hue": 28, "hueTolerance": 20, "minSaturation": -1, "minValue": 45.0,
          "minPercent": 0.5, "maxPercent": 30, "mask": true, "later": {}}})",
      {}, why);
  ASSERT_TRUE(wishes.has_value()) << why;
  EXPECT_EQ(wishes->find, (Search{{28, 20, -1, 45}, {0.5, 30}}));
  EXPECT_TRUE(wishes->mask);
  const auto same = readWishes(R"({"rate": 5})", *wishes, why);
  EXPECT_EQ(same->find, wishes->find) << "what is left out stays";
  const auto usual = readWishes(R"({"find": {}})", *wishes, why);
  EXPECT_EQ(usual->find, kRedBall);
  EXPECT_FALSE(usual->mask);
  EXPECT_FALSE(readWishes(R"({"find": null})", *wishes, why)->find.has_value());
  EXPECT_EQ(readWishes("{\"find\": " + searchJson(*wishes).dump() + "}", {}, why)->find, wishes->find)
      << "as one monitor says it to another";
}

TEST(MonitorSearch, ThatMakesNoSenseChangesNothing) {
  for (const char* find :
       {"7", "\"red\"", "[]", "true", R"({"hue": 361})", R"({"hue": -1})", R"({"hue": 28.5})", R"({"hue": "28"})",
        R"({"hue": null})", R"({"hueTolerance": 181})", R"({"minSaturation": -2})", R"({"minValue": 101})",
        R"({"minPercent": -0.1})", R"({"maxPercent": 100.1})", R"({"maxPercent": []})", R"({"mask": 1})"}) {
    std::string why;
    EXPECT_FALSE(readWishes(std::string{R"({"rate": 5, "find": )"} + find + "}", {}, why).has_value()) << find;
    EXPECT_THAT(why, HasSubstr("find")) << find;
  }
  std::string why;
  EXPECT_FALSE(readWishes(R"({"find": {"hue": 400}})", {}, why).has_value());
  EXPECT_EQ(why, "find.hue must be a whole number from 0 to 360");
}

TEST(Finders, FindTheBallWhereItIs) {
  Finders finders;
  finders.want({kRedBall});
  finders.look(frameOf(lawnWithBox(100, 60, 41, 21), 7));
  const auto found = finders.found(kRedBall, 7);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->centre, (vision::Pixel{120, 70}));
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

TEST(Finders, FindInWhatACameraGives) {
  const std::vector<std::uint8_t> bgra = lawnWithBox(100, 60, 41, 21);
  std::vector<std::uint8_t> yuyv(2 * kWide * kHigh);
  pixels::bgraToYuyvRotated(bgra, kWide, kHigh, yuyv, 2 * kWide);
  Finders finders;
  finders.want({kRedBall});
  finders.look({.sequence = 1, .time = Nanos{0}, .width = kWide, .height = kHigh, .yuyv = yuyv});
  ASSERT_TRUE(finders.found(kRedBall, 1).has_value());
  EXPECT_NEAR(finders.found(kRedBall, 1)->centre.value_or(vision::Pixel{}).x, 120, 1);
  yuyv.resize(100);
  finders.look({.sequence = 2, .time = Nanos{0}, .width = kWide, .height = kHigh, .yuyv = yuyv});
  EXPECT_FALSE(finders.found(kRedBall, 2).has_value()) << "half a picture";
}

TEST(Finders, SayHowMuchThereIsWhenItIsNoBall) {
  Finders finders;
  const Search small{{}, {0, 1}};
  finders.want({small});
  finders.look(frameOf(lawnWithBox(100, 60, 41, 21), 1));
  EXPECT_FALSE(finders.found(small, 1)->centre.has_value());
  EXPECT_EQ(finders.found(small, 1)->pixels, 861U);
  finders.look(frameOf(lawnWithBox(0, 0, 0, 0), 2));
  EXPECT_EQ(
      foundText(*finders.found(small, 2), false),
      R"({"type":"found","picture":2,"width":320,"height":240,"x":null,"y":null,"pixels":0,"percent":0,"box":null})");
}

TEST(Finders, LookForNoMoreThanObserversCanAskFor) {
  std::vector<Search> many;
  for (int hue = 0; hue < 40; ++hue) many.push_back({{.hue = hue / 2}, {}});
  Finders finders;
  finders.want(many);
  const auto bgra = lawnWithBox(100, 60, 41, 21);
  finders.look(frameOf(bgra, 1));
  EXPECT_TRUE(finders.found(many[2 * Finders::kMost - 1], 1).has_value()) << "equal ones count once";
  EXPECT_FALSE(finders.found(many[2 * Finders::kMost], 1).has_value());
  finders.want({});
  finders.look(frameOf(bgra, 2));
  EXPECT_FALSE(finders.found(many[0], 2).has_value()) << "nobody asks any more";
}

TEST(Finders, RememberThePicturesOfThisMoment) {
  Finders finders;
  finders.want({kRedBall});
  for (std::uint64_t number = 1; number <= 10; ++number)
    finders.look(frameOf(lawnWithBox(static_cast<int>(number) * 10, 60, 9, 9), number));
  EXPECT_EQ(finders.found(kRedBall, 10)->left, 100);
  EXPECT_EQ(finders.found(kRedBall, 9)->left, 90);
  EXPECT_FALSE(finders.found(kRedBall, 2).has_value());
  EXPECT_FALSE(finders.found(kRedBall, 0).has_value());
}

/// A camera that gives a picture as often as it is told.
struct ToldCamera final : FrameSource {
  explicit ToldCamera(const std::atomic<std::uint64_t>& told) : number{told} {}
  const std::atomic<std::uint64_t>& number;
  std::vector<std::uint8_t> bgra = lawnWithBox(100, 60, 41, 21);
  CameraFrame newest() override { return frameOf(bgra, number); }
  [[nodiscard]] CameraHealth health() const override { return {.seeing = true, .frames = number}; }
};

TEST(Finders, KnowAPictureBeforeItCanBeShown) {
  Finders finders;
  finders.want({kRedBall});
  std::atomic<std::uint64_t> number{1};
  remote::LivePictures pictures{std::make_unique<ToldCamera>(number),
                                {.now = [] { return Nanos{0}; },
                                 .say = {},
                                 .look_at = [&finders](const CameraFrame& frame) { finders.look(frame); }}};
  for (; number <= 3; ++number) {
    while (pictures.newest().sequence != number) std::this_thread::yield();
    EXPECT_TRUE(finders.found(kRedBall, number).has_value()) << number;
  }
}

}  // namespace
}  // namespace darwinop::monitor
