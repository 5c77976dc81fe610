// The member "find" of an observer's request.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "monitor/messages.hpp"
#include "monitor/search_message.hpp"

namespace darwinop::monitor {
namespace {

using testing::HasSubstr;

const ColourQuery kRedBall{};  // the search's own thresholds

TEST(MonitorSearch, ReadsMemberByMember) {
  std::string why;
  const auto subscription = parseSubscription(
      R"({"camera": 10, "find": {"hue": 28, "hueTolerance": 20, "minSaturation": -1, "minValue": 45.0,
          "minPercent": 0.5, "maxPercent": 30, "mask": true, "later": {}}})",
      {}, why);
  ASSERT_TRUE(subscription.has_value()) << why;
  EXPECT_EQ(subscription->find, (ColourQuery{{28, 20, -1, 45}, {0.5, 30}}));
  EXPECT_TRUE(subscription->mask);
  const auto same = parseSubscription(R"({"rate": 5})", *subscription, why);
  EXPECT_EQ(same->find, subscription->find) << "omitted members keep their values";
  const auto usual = parseSubscription(R"({"find": {}})", *subscription, why);
  EXPECT_EQ(usual->find, kRedBall);
  EXPECT_FALSE(usual->mask);
  EXPECT_FALSE(parseSubscription(R"({"find": null})", *subscription, why)->find.has_value());
  EXPECT_EQ(parseSubscription("{\"find\": " + searchJson(*subscription).dump() + "}", {}, why)->find,
            subscription->find)
      << "as one monitor requests it from another";
}

TEST(MonitorSearch, RejectsInvalidValuesWithoutAChange) {
  for (const char* find :
       {"7", "\"red\"", "[]", "true", R"({"hue": 361})", R"({"hue": -1})", R"({"hue": 28.5})", R"({"hue": "28"})",
        R"({"hue": null})", R"({"hueTolerance": 181})", R"({"minSaturation": -2})", R"({"minValue": 101})",
        R"({"minPercent": -0.1})", R"({"maxPercent": 100.1})", R"({"maxPercent": []})", R"({"mask": 1})"}) {
    std::string why;
    EXPECT_FALSE(parseSubscription(std::string{R"({"rate": 5, "find": )"} + find + "}", {}, why).has_value()) << find;
    EXPECT_THAT(why, HasSubstr("find")) << find;
  }
  std::string why;
  EXPECT_FALSE(parseSubscription(R"({"find": {"hue": 400}})", {}, why).has_value());
  EXPECT_EQ(why, "find.hue must be a whole number from 0 to 360");
}

}  // namespace
}  // namespace darwinop::monitor
