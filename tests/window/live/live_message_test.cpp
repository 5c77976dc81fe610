// Messages of the live comparison's channel.
#include "window/live/live_message.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "window/messages.hpp"

namespace darwinop::window {
namespace {

using gap::live::Support;

TEST(LiveMessage, ARequestNamesModelAndSupport) {
  std::string why;
  const auto request = parseLiveRequest(R"({"run": {"model": "my.ini", "support": "floor"}})", why);
  ASSERT_TRUE(request && request->run);
  EXPECT_EQ(request->run->model, "my.ini");
  EXPECT_EQ(request->run->support, Support::kFloor);
  const auto stop = parseLiveRequest(R"({"run": null})", why);
  ASSERT_TRUE(stop);
  EXPECT_FALSE(stop->run);
}

TEST(LiveMessage, OtherRequestsAreRefused) {
  for (const std::string& text :
       {std::string{"run"}, std::string{"{}"}, std::string{R"({"run": 1})"}, std::string{R"({"run": {"model": 3}})"},
        std::string{R"({"run": {"model": ""}})"}, std::string{R"({"run": {"support": "floor"}})"},
        std::string{R"({"run": {"model": "x", "support": "hand"}})"},
        std::string{R"({"run": {"model": "x", "speed": 1}})"},
        R"({"run": {"model": ")" + std::string(1001, 'x') + R"("}})"}) {
    std::string why;
    EXPECT_FALSE(parseLiveRequest(text, why)) << text;
    EXPECT_EQ(why, messages::kInvalidLiveRequest);
  }
}

TEST(LiveMessage, WhatWasNotComparedIsNullAndUnitsAreThoseOfTheNames) {
  LiveStatus status;
  status.report.position_rad[3].rms = 0.0025;
  status.report.load[3].worst = 0.5;
  const auto message = nlohmann::json::parse(liveText(status));
  const auto& signals = message["signals"];
  EXPECT_DOUBLE_EQ(signals["position_mrad"]["rms"][3], 2.5);
  EXPECT_DOUBLE_EQ(signals["load_percent"]["worst"][3], 50);
  EXPECT_TRUE(signals["position_mrad"]["rms"][4].is_null());
  EXPECT_TRUE(signals["gyro_rad_s"]["newest"][0].is_null());
  EXPECT_TRUE(message["step_ms"].is_null());
  EXPECT_TRUE(message["before"].is_null());
}

}  // namespace
}  // namespace darwinop::window
