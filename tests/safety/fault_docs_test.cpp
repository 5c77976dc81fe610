// docs/faults.md names every limit and threshold, docs/states.md every state.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "core/faults.hpp"
#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/states.hpp"
#include "support/text_of.hpp"

namespace darwinop::safety {
namespace {

std::string page(const std::string& name) {
  return textOf(std::string{DARWINOP_DOCS} + "/" + name);
}

TEST(FaultDocs, EveryLimitIsOnThePage) {
  const std::string text = page("faults.md");
  for (const std::string_view limit : kLimitNames)
    EXPECT_NE(text.find("`" + std::string{limit} + "`"), text.npos) << limit;
}

std::string shown(const char* format, double value) {
  std::array<char, 32> text{};
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, value))};
}

TEST(FaultDocs, TheTableNamesTheDefaultThresholds) {
  const Config config;
  const struct {
    Fault fault;
    std::string cause, end;
  } thresholds[] = {
      {Fault::kBusSilent, shown("%g cycles", kAnswerPatience), ""},
      {Fault::kBatteryLow, shown("%.1f V", config.battery_low),
       shown("%.1f V", config.battery_low + kBatteryHysteresis)},
      {Fault::kBatteryEmpty, shown("%.1f V", config.battery_empty),
       shown("%.1f V", config.battery_empty + kBatteryHysteresis)},
      {Fault::kServoHot, shown("%g deg C", config.hot), shown("%g deg C", config.hot - kHeatHysteresis)},
      {Fault::kServoOverheat, shown("%g deg C", config.overheat), shown("%g deg C", config.overheat - kHeatHysteresis)},
      {Fault::kServoOverheat, shown("shuts itself off at %g", kServoShutdownC), ""},
      {Fault::kServoVoltage, shown("(%g to ", kServoSupplyLow) + shown("%g V)", kServoSupplyHigh), ""},
      {Fault::kFell, shown("%g deg", config.fall_tilt), ""},
      {Fault::kControllerStalled, shown("%g ms", config.stall_ms), ""},
      {Fault::kControllerGone, shown("%g s", config.gone_s), ""},
  };
  for (const auto& expected : thresholds) {
    const FaultRow& fault = row(expected.fault);
    EXPECT_NE(fault.meaning.find(expected.cause), fault.meaning.npos) << fault.meaning << " lacks " << expected.cause;
    EXPECT_NE(fault.ends.find(expected.end), fault.ends.npos) << fault.ends << " lacks " << expected.end;
  }
}

TEST(FaultDocs, EveryStateAndEventIsOnTheStatesPage) {
  const std::string text = page("states.md");
  for (const std::string_view name : kStateNames)
    EXPECT_NE(text.find("`" + std::string{name} + "`"), text.npos) << name;
  for (const std::string_view name : kEventNames)
    EXPECT_NE(text.find("`" + std::string{name} + "`"), text.npos) << name;
}

}  // namespace
}  // namespace darwinop::safety
