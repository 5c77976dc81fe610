// Settings of the safety layer.
#include "safety/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "core/text/number_text.hpp"

namespace darwinop::safety {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal(std::string_view section, std::string_view key, std::string_view value) {
  Config config;
  try {
    config.set(section, key, value);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SafetyConfig, DefaultsAreWithinTheirOwnRanges) {
  EXPECT_NO_THROW(Config{}.check());
}

TEST(SafetyConfig, EveryNumberIsSetByItsNameAndRefusedOutsideItsRange) {
  const Config defaults;
  int numbers = 0;
  defaults.visit([&](std::string_view name, const auto& field, const auto&... rest) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, double>) {
      ++numbers;
      const auto [low, high, unit, why] = std::tuple{rest...};
      EXPECT_LT(low, high) << name;
      EXPECT_FALSE(std::string_view{why}.empty()) << name;
      const double wanted = low + (high - low) * 0.25;
      Config config;
      config.set("Safety", name, std::to_string(wanted));
      bool changed = false;
      config.visit([&](std::string_view other, const auto& value, const auto&...) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
          if (other == name) changed = std::abs(value - wanted) < 1e-4;
      });
      EXPECT_TRUE(changed) << name;
      const std::string range = text::generalText(low, 6) + " to " + text::generalText(high, 6);
      for (const std::string& wrong : {std::to_string(high * 1.5 + 1), std::string{"-1"}, std::string{"nan"},
                                       std::string{"12 volts"}, std::string{}})
        EXPECT_THAT(refusal("Safety", name, wrong),
                    AllOf(StartsWith("config.ini, [Safety] " + std::string{name} + " = " + wrong + ": "),
                          HasSubstr(" " + range)));
    }
  });
  EXPECT_GE(numbers, 10);
}

TEST(SafetyConfig, ChoicesAreTakenByName) {
  Config config;
  config.set("Safety", "on_fall", "limp");
  config.set("Safety", "on_exit", " hold ");
  config.set("Safety", "release_button", "none");
  config.set("Safety", "start", "hold");
  EXPECT_EQ(config.on_fall, OnFall::kLimp);
  EXPECT_EQ(config.on_exit, OnExit::kHold);
  EXPECT_EQ(config.release_button, ReleaseButton::kNone);
  EXPECT_EQ(config.start, StartMove::kHold);
  EXPECT_THAT(refusal("Safety", "on_exit", "sit"),
              AllOf(HasSubstr("on_exit"), HasSubstr("hold, kneel, limp"), HasSubstr("sit")));
}

TEST(SafetyConfig, AnUnknownKeyIsRefusedWithTheKeysThatExist) {
  EXPECT_THAT(refusal("Safety", "max_speed", "1"), AllOf(HasSubstr("max_speed"), HasSubstr("max_joint_speed")));
  EXPECT_THAT(refusal("Robot", "stall_ms", "500"), HasSubstr("[Robot]"));
}

TEST(SafetyConfig, LimitsCanBeNarrowedAndNotWidened) {
  Config config;
  config.set("Limits", "Neck", "-1.0, 1.0");
  EXPECT_EQ(config.range[index(Joint::kNeck)].low, Rad{-1});
  EXPECT_EQ(config.range[index(Joint::kNeck)].high, Rad{1});
  EXPECT_THAT(refusal("Limits", "Neck", "-3.0, 1.0"), AllOf(HasSubstr("Neck"), HasSubstr("-1.929"), HasSubstr("1.69")));
  for (const std::string wrong : {"1, -1", "1", "nan, 1"})
    EXPECT_THAT(refusal("Limits", "Neck", wrong),
                AllOf(HasSubstr("Neck = " + wrong + ": "), HasSubstr("-1.929"), HasSubstr("1.69")));
  EXPECT_EQ(refusal("Limits", "Nose", "0, 1"), std::string{"config.ini, [Limits] Nose = 0, 1: "} + kNoSuchJoint);
}

TEST(SafetyConfig, ALimitGivenBackAsPrintedIsNotAWidening) {
  Config config;
  config.set("Limits", "Neck", "-1.92975, 1.69044");
  EXPECT_GE(config.range[index(Joint::kNeck)].low, hardRange(Joint::kNeck).low);
  EXPECT_LE(config.range[index(Joint::kNeck)].high, hardRange(Joint::kNeck).high);
  EXPECT_NO_THROW(config.check());
}

TEST(SafetyConfig, SettingsThatContradictEachOtherAreRefused) {
  const auto contradicts = [](auto change) {
    Config config;
    change(config);
    EXPECT_THROW(config.check(), std::runtime_error);
  };
  contradicts([](Config& c) { c.battery_low = 9.0; });
  contradicts([](Config& c) { c.hot = 78; });
  contradicts([](Config& c) { c.max_joint_speed = 0.5; });
  contradicts([](Config& c) { c.gone_s = 0.2; });
  contradicts([](Config& c) { c.gentle_speed = std::numeric_limits<double>::quiet_NaN(); });
  contradicts([](Config& c) { c.range[0].high = Rad{4}; });
  contradicts([](Config& c) { c.period = Nanos{0}; });
}

TEST(SafetyConfig, NamesOfSettingsAreDistinct) {
  std::multiset<std::string_view> names;
  Config{}.visit([&](std::string_view name, const auto&...) { names.insert(name); });
  for (const auto name : names) EXPECT_EQ(names.count(name), 1u) << name;
}

}  // namespace
}  // namespace darwinop::safety
