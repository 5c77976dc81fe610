// What is to be looked for in the frames, as a message.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "monitor/messages.hpp"
#include "monitor/search_message.hpp"

namespace darwinop::monitor {
namespace {

using testing::HasSubstr;

const Search kRedBall{};  // the search's own thresholds

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

}  // namespace
}  // namespace darwinop::monitor
