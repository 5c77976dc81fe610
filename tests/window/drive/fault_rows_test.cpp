// Each row of the fault table, occurring while a page drives: what the page is sent.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "core/faults.hpp"
#include "monitor/messages.hpp"
#include "window/drive/drive_thread.hpp"
#include "window/drive/fake_robot_link.hpp"
#include "window/drive/steering_session.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;

/// The page's newest message of type "driving".
struct DrivingPage final : web::Channel {
  [[nodiscard]] const std::string& name() const override { return who; }
  void send(web::Lane, web::Bytes text) override {
    if (json message = json::parse(*text); message.at("type") == "driving") driving = std::move(message);
  }
  void sendBinary(web::Lane, web::Bytes) override {}
  void discardQueued() override {}
  [[nodiscard]] std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  json driving;
  std::string who = "page";
};

class FaultWhileAPageDrives : public testing::TestWithParam<std::size_t> {
 protected:
  /// Heartbeats until `reached`.
  template <class Condition>
  bool runUntil(Condition reached) {
    for (int i = 0; i < 20'000 && !reached(); ++i) {
      session_.received(page_, "{}", false);
      session_.update();
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return reached();
  }
  void occur(const FaultRow& row) {
    const std::scoped_lock lock{robot_.mutex};
    SafetyReport& safety = robot_.image.safety;
    for (std::size_t i = 0; i < kFaults; ++i) safety.active[i] = kFaultTable[i].fault == row.fault;
    safety.worst = row.fault;
    safety.reaction = row.reaction;
    safety.controller_must_end = row.ends_controller;
  }
  [[nodiscard]] bool driving() const { return page_.driving.value("yours", false); }
  [[nodiscard]] std::string text() const { return page_.driving.value("text", ""); }
  [[nodiscard]] Sensors image() {
    const std::scoped_lock lock{robot_.mutex};
    return robot_.image;
  }

  FakeRobot robot_;
  motion::PageFile pages_;
  DriveThread drive_{[this] { return std::make_unique<FakeRobotLink>(robot_); }, pages_};
  DrivingPage page_;
  SteeringSession session_{drive_, [] { return Nanos{0}; }};
};
INSTANTIATE_TEST_SUITE_P(Each, FaultWhileAPageDrives, testing::Range(std::size_t{0}, kFaults),
                         [](const auto& by) { return std::string{kFaultTable[by.param].name}; });

TEST_P(FaultWhileAPageDrives, IsInTheFaultsAndEndsTheSessionWithItsMeaningIfItEndsControllers) {
  session_.received(page_, R"({"take": true})", false);
  ASSERT_TRUE(runUntil([this] { return driving(); }));
  const FaultRow& row = kFaultTable[GetParam()];
  occur(row);
  const std::uint64_t since = image().cycle;

  const json faults = json::parse(monitor::faultsText(image().safety));
  ASSERT_EQ(faults.at("active").size(), 1U);
  EXPECT_EQ(faults["active"][0].at("name"), row.name);
  EXPECT_EQ(faults["active"][0].at("meaning"), row.meaning);
  EXPECT_EQ(faults["active"][0].at("remedy"), row.remedy);

  if (row.ends_controller) {
    EXPECT_TRUE(runUntil([&] { return !driving() && text().find(row.meaning) != std::string::npos; })) << text();
  } else {
    EXPECT_TRUE(runUntil([&] { return image().cycle > since + 50; }));
    EXPECT_TRUE(driving());
    EXPECT_EQ(text(), "");
  }
}

}  // namespace
}  // namespace darwinop::window
