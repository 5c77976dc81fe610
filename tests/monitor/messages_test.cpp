// Messages of the monitor channel.
#include "monitor/messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/conversions.hpp"
#include "monitor/picture.hpp"

namespace darwinop::monitor {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

TEST(MonitorSubscription, ReadsMemberByMember) {
  std::string why;
  EXPECT_EQ(parseSubscription(R"({"rate": 62.5, "camera": 10, "later": []})", {}, why), (Subscription{62.5, 10}));
  EXPECT_EQ(parseSubscription(R"({"camera": 0})", {62.5, 10}, why), (Subscription{62.5, 0}));
  EXPECT_EQ(parseSubscription("{}", {62.5, 10}, why), (Subscription{62.5, 10}));
  EXPECT_EQ(why, "");
}

TEST(MonitorSubscription, RejectsInvalidRequests) {
  for (const char* text : {"", "20", "[]", "{", "{\"rate\": 20} x", R"({"rate": "20"})", R"({"rate": -1})",
                           R"({"rate": 126})", R"({"rate": null})", R"({"camera": 31})", R"({"camera": 1e999})"}) {
    std::string why;
    EXPECT_FALSE(parseSubscription(text, {}, why).has_value()) << text;
    EXPECT_NE(why, "") << text;
  }
  std::string why;
  EXPECT_FALSE(parseSubscription(std::string(4096, '['), {}, why).has_value());
  EXPECT_FALSE(parseSubscription(R"({"rate": 126})", {}, why).has_value());
  EXPECT_EQ(why, "rate must be a number from 0 to 125, in Hz");
}

TEST(MonitorTexts, WritesShortMessagesExactly) {
  EXPECT_EQ(goneText("no \"runtime\""), R"({"type":"gone","reason":"no \"runtime\""})");
  EXPECT_EQ(cameraText(false, "taken"), R"({"type":"camera","seeing":false,"text":"taken"})");
  EXPECT_EQ(errorText("what?"), R"({"type":"error","text":"what?"})");
  EXPECT_EQ(noticeText(7, 1.5, "it fell"), R"({"type":"notice","number":7,"time":1.5,"text":"it fell"})");
  EXPECT_EQ(noticeText(8, kUnknown, "\xff"),
            "{\"type\":\"notice\",\"number\":8,\"time\":null,\"text\":\"\xef\xbf\xbd\"}")
      << "invalid UTF-8 is replaced";
  EXPECT_EQ(faultsText({}), R"({"type":"faults","active":[]})");
}

TEST(MonitorTexts, DescribesAFaultAsTheFaultTableDoes) {
  SafetyReport safety;
  for (std::size_t i = 0; i < kFaults; ++i)
    safety.active[i] = kFaultTable[i].fault == Fault::kServoSilent || kFaultTable[i].fault == Fault::kBatteryLow;
  safety.worst = Fault::kServoSilent;
  safety.worst_joint = 19;
  const Json text = Json::parse(faultsText(safety));
  ASSERT_EQ(text["active"].size(), 2u);
  const Json& silent = text["active"][0];
  EXPECT_EQ(silent["code"], 12);
  EXPECT_EQ(silent["name"], "servo_silent");
  EXPECT_EQ(silent["joint"], "Neck");
  EXPECT_EQ(silent["meaning"], row(Fault::kServoSilent).meaning);
  EXPECT_EQ(silent["remedy"], row(Fault::kServoSilent).remedy);
  EXPECT_TRUE(text["active"][1]["joint"].is_null()) << "known for the worst fault only";
}

TEST(MonitorTexts, DescribeTheRobotInHello) {
  runtime::LoopInfo info{.period_ns = 16'000'000, .pid = 1};
  runtime::setText(info.robot, sizeof info.robot, "darwin-op");
  const Json hello = Json::parse(helloText(&info, {50, 5}));
  EXPECT_EQ(hello["protocol"], 1);
  EXPECT_EQ(hello["robot"], "darwin-op");
  EXPECT_EQ(hello["period"], 0.016);
  EXPECT_EQ(hello["rate"], 50);
  EXPECT_EQ(hello["most"]["camera"], 30);
  ASSERT_EQ(hello["joints"].size(), kJoints);
  EXPECT_EQ(hello["joints"][18]["name"], "Neck");
  EXPECT_EQ(hello["joints"][18]["sensor"], "NeckS");
  EXPECT_EQ(hello["joints"][18]["chain"], "head");
  EXPECT_NEAR(hello["joints"][18]["low"].get<double>(), radFromTicks(790).value, 1e-5);
  EXPECT_EQ(hello["faults"].size(), kFaults);
  EXPECT_EQ(hello["faults"][0]["reaction"], "stop_sending");
  EXPECT_TRUE(Json::parse(helloText(nullptr, {}))["period"].is_null()) << "no runtime";
}

Sensors standing() {
  Sensors seen;
  seen.cycle = 1234;
  seen.time_ns = 19'744'000'000;
  seen.period_ns = 16'000'000;
  seen.safety.state = State::kDriven;
  JointSensors& neck = seen.joint[18];
  neck.motion.received();
  neck.position = Rad{0.5};
  neck.velocity = RadPerSec{-0.1};
  neck.load = 0.25;
  neck.polled.age = 60;
  neck.temperature = Celsius{41};
  neck.voltage = Volt{11.9};
  neck.torque_enabled = true;
  neck.driven = true;
  neck.commanded = Rad{0.6};
  seen.board.motion.received();
  seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
  seen.board.gyro = {RadPerSec{0}, RadPerSec{0}, RadPerSec{0}};
  seen.board.buttons = 2;
  seen.board.voltage = Volt{12.1};
  seen.board.led_panel = 5;
  seen.board.led_head = 31;
  seen.board.led_eye = 31 << 10;
  return seen;
}

TEST(MonitorState, ReportsKnownValuesAndNullForUnknownOnes) {
  const Json text = Json::parse(stateText(standing()));
  EXPECT_EQ(text["cycle"], 1234);
  EXPECT_EQ(text["time"], 19.744);
  EXPECT_EQ(text["state"], "driven");
  const Json& joints = text["joints"];
  EXPECT_EQ(joints["position"][18], 0.5);
  EXPECT_EQ(joints["goal"][18], 0.6);
  EXPECT_EQ(joints["speed"][18], -0.1);
  EXPECT_EQ(joints["temperature"][18], 41);
  EXPECT_EQ(joints["torque"][18], true);
  EXPECT_TRUE(joints["torque_limit"][18].is_null());
  for (const char* name :
       {"position", "goal", "speed", "load", "age", "temperature", "voltage", "torque", "health_age"})
    EXPECT_TRUE(joints[name][0].is_null()) << name << " of a servo that has never answered";
  const Json& board = text["board"];
  EXPECT_EQ(board["accelerometer_count"], (Json{512, 512, 640}));
  EXPECT_EQ(board["start_button"], true);
  EXPECT_EQ(board["mode_button"], false);
  EXPECT_EQ(board["led"], (Json{{"panel", 5}, {"head", "#ff0000"}, {"eye", "#0000ff"}}));
  EXPECT_TRUE(board["microphone"].is_null());
}

TEST(MonitorState, ReportsStaleValuesAsNull) {
  Sensors seen = standing();
  seen.joint[18].motion.age = 3;
  EXPECT_EQ(Json::parse(stateText(seen))["joints"]["position"][18], 0.5);
  seen.joint[18].motion.age = 4;
  seen.joint[18].polled.age = 188;  // 3.008 s
  seen.board.motion.age = 4;
  const Json text = Json::parse(stateText(seen));
  EXPECT_TRUE(text["joints"]["position"][18].is_null());
  EXPECT_EQ(text["joints"]["age"][18], 4);
  EXPECT_TRUE(text["joints"]["temperature"][18].is_null());
  EXPECT_TRUE(text["joints"]["torque"][18].is_null());
  EXPECT_TRUE(text["board"]["voltage"].is_null());
  EXPECT_TRUE(text["board"]["accelerometer"][2].is_null());
  EXPECT_TRUE(text["board"]["mode_button"].is_null());
}

double anyDouble() {
  return *rc::gen::oneOf(rc::gen::arbitrary<double>(),
                         rc::gen::element(0.0, -0.0, kUnknown, std::numeric_limits<double>::infinity(), 1e308, 5e-324));
}

bool allNumbersAreNumbers(const Json& value) {
  if (value.is_structured()) return std::all_of(value.begin(), value.end(), allNumbersAreNumbers);
  return !value.is_number() || std::isfinite(value.get<double>());
}

RC_GTEST_PROP(MonitorState, IsJsonWhateverTheImage, ()) {
  Sensors seen;
  seen.cycle = *rc::gen::arbitrary<std::uint64_t>();
  seen.time_ns = *rc::gen::arbitrary<std::int64_t>();
  seen.period_ns = *rc::gen::arbitrary<std::int64_t>();
  seen.safety.state = static_cast<State>(*rc::gen::arbitrary<std::uint8_t>());
  seen.safety.active = std::bitset<kFaults>{*rc::gen::arbitrary<unsigned>()};
  seen.safety.worst = static_cast<Fault>(*rc::gen::arbitrary<std::uint8_t>());
  seen.safety.worst_joint = *rc::gen::arbitrary<std::uint8_t>();
  JointSensors& joint = seen.joint[*rc::gen::inRange<std::size_t>(0, kJoints)];
  joint.motion.age = *rc::gen::element<std::uint32_t>(0, 3, Freshness::kNever);
  joint.polled.age = *rc::gen::element<std::uint32_t>(0, 3, Freshness::kNever);
  joint.position = Rad{anyDouble()};
  joint.load = anyDouble();
  joint.temperature = Celsius{anyDouble()};
  seen.board.motion.age = *rc::gen::element<std::uint32_t>(0, Freshness::kNever);
  seen.board.accelerometer[0] = MeterPerSec2{anyDouble()};
  seen.board.led_head = *rc::gen::arbitrary<std::uint16_t>();
  const Json state = Json::parse(stateText(seen));  // throws if invalid
  RC_ASSERT(allNumbersAreNumbers(state));
  RC_ASSERT(state["joints"]["position"].size() == kJoints);
  RC_ASSERT(Json::parse(faultsText(seen.safety)).is_object());
}

TEST(MonitorLoop, CountsAndSpreads) {
  const auto stats = std::make_unique<runtime::LoopStats>();
  Sensors seen = standing();
  for (const std::int64_t wake_us : {5, 35, 35, 700, 20'000}) {
    seen.wake_latency_ns = wake_us * 1000;
    stats->account(seen, 0, runtime::LoopStats::Timed::kYes);
  }
  const auto all = std::make_unique<runtime::StatsView>(), none = std::make_unique<runtime::StatsView>();
  stats->copyTo(*all);
  const Json text =
      Json::parse(loopText({.all = *all, .recent = *none, .seconds = 1, .driver = -1, .session = 3, .lost = 17}, seen));
  EXPECT_EQ(text["cycles"], 5);
  EXPECT_EQ(text["wake_us"]["p50"], 35);
  EXPECT_EQ(text["wake_histogram"]["counts"], (Json{1, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_TRUE(text["recent"]["wake_us"]["max"].is_null()) << "nothing was measured";
  EXPECT_EQ(text["stale"].size(), kJoints - 1);
  EXPECT_TRUE(text["driver"]["pid"].is_null()) << "of another user";
  EXPECT_EQ(text["lost"], 17);
  EXPECT_TRUE(Json::parse(loopText({.all = *all, .recent = *none}, seen))["driver"].is_null());
}

TEST(MonitorPicture, HasAHeadOfTwentyBytes) {
  const std::array<std::uint8_t, 3> jpeg{0xFF, 0xD8, 0x01};
  const std::string message =
      pictureMessage({.sequence = 0x1'0203'0405, .age = std::chrono::milliseconds{258}, .jpeg = jpeg}, {320, 240});
  using std::string_view_literals::operator""sv;
  EXPECT_EQ(message, "\x01\x14\x40\x01\xf0\x00\x00\x00\x05\x04\x03\x02\x02\x01\x00\x00\x00\x00\x00\x00\xff\xd8\x01"sv);
}

}  // namespace
}  // namespace darwinop::monitor
