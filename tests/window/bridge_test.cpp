// A monitor elsewhere, handed on: a real server and a real connection on loopback, the page on paper.
#include "window/bridge.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "hal/net/web/server.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

/// A monitor that says what the test wants.
struct MonitorOnPaper final : web::ChannelUser {
  void opened(web::Channel& channel) override {
    peer = &channel;
    say(R"({"type":"hello","period":0.016})");
  }
  void said(web::Channel&, std::string_view message, bool) override { asked.emplace_back(message); }
  void closed(web::Channel&) noexcept override { peer = nullptr; }
  void say(const std::string& text) const { peer->send(web::kEvery, std::make_shared<const std::string>(text)); }

  web::Channel* peer = nullptr;
  std::vector<std::string> asked;
};

struct BridgedPage final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane lane, web::Bytes text) override {
    lanes.push_back(lane);
    heard.push_back(*text);
  }
  void sendBinary(web::Lane, web::Bytes bytes) override { heard.push_back("picture " + *bytes); }
  void forgetNewest() override { ++forgotten; }
  std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  std::string who = "page";
  std::vector<std::string> heard;
  std::vector<web::Lane> lanes;
  int forgotten = 0;
};

class WindowBridge : public testing::Test {
 protected:
  void startMonitor(std::uint16_t port = 0) {
    web::ServerConfig config;
    config.port = port;
    server_ = std::make_unique<web::Server>(config, [](const std::string&) {});
    server_->channel("/monitor", protocol_, monitor_);
    port_ = server_->port();
  }
  template <class Done>
  [[nodiscard]] bool until(Done done) {
    for (const auto end = std::chrono::steady_clock::now() + 20s; std::chrono::steady_clock::now() < end;) {
      if (server_)
        server_->attend(1ms);
      else
        std::this_thread::sleep_for(1ms);
      bridge_->look();
      if (done()) return true;
    }
    return false;
  }
  [[nodiscard]] bool hears(const std::string& part) {
    return until([&] {
      return std::ranges::any_of(page_.heard, [&](const auto& text) { return text.find(part) != std::string::npos; });
    });
  }
  void openPage() {
    bridge_ = std::make_unique<window::Bridge>(0x7F000001, port_, "robot:5024");
    bridge_->opened(page_);
  }

  MonitorOnPaper monitor_;
  BridgedPage page_;
  std::unique_ptr<web::Server> server_;
  std::unique_ptr<window::Bridge> bridge_;
  std::string protocol_ = "darwinop-monitor.1";
  std::uint16_t port_ = 0;
};

TEST_F(WindowBridge, HandsOnWhatTheMonitorSaysAndAsksForWhatThePageWants) {
  startMonitor();
  openPage();
  ASSERT_TRUE(hears("hello"));
  bridge_->said(page_, R"({"rate": 62.5})", false);
  bridge_->said(page_, R"({"camera": 10, "find": {"hue": 28}})", false);
  EXPECT_TRUE(
      until([&] { return !monitor_.asked.empty() && monitor_.asked.back().find("10.0") != std::string::npos; }));
  EXPECT_THAT(monitor_.asked.back(), HasSubstr(R"({"rate":62.5,"camera":10.0,"find":{"hue":28,)"));

  monitor_.say(R"({"type":"state","cycle":7})");
  monitor_.say(R"({"type":"notice","number":1})");
  monitor_.say("no JSON");
  monitor_.say(R"({"type":7})");
  monitor_.peer->sendBinary(web::kEvery, std::make_shared<const std::string>("jpeg"));
  ASSERT_TRUE(hears("picture jpeg"));
  EXPECT_THAT(page_.heard, Contains(R"({"type":"state","cycle":7})"));
  EXPECT_EQ(page_.heard.size(), 4U) << "what no monitor says is not handed on";
  EXPECT_LT(page_.lanes.at(1), web::kLanes) << "of states the newest counts";
  EXPECT_EQ(page_.lanes.at(2), web::kEvery) << "notices are all kept";
}

TEST_F(WindowBridge, ABrokenConnectionIsToldOnceAndComesBackWithWhatThePageWanted) {
  startMonitor();
  openPage();
  bridge_->said(page_, R"({"rate": 62.5})", false);
  ASSERT_TRUE(hears("hello"));
  const std::uint16_t port = port_;
  server_.reset();
  ASSERT_TRUE(hears(R"("gone")"));
  EXPECT_THAT(page_.heard.back(), HasSubstr("robot:5024"));
  page_.heard.clear();
  monitor_.asked.clear();
  startMonitor(port);
  ASSERT_TRUE(hears("hello"));
  EXPECT_TRUE(until([&] { return !monitor_.asked.empty(); }));
  EXPECT_THAT(monitor_.asked, Contains(HasSubstr("62.5")));
}

TEST_F(WindowBridge, WhatIsNoMonitorIsNamed) {
  protocol_ = "something.else";
  startMonitor();
  openPage();
  EXPECT_TRUE(hears("it answers 400"));
}

TEST_F(WindowBridge, APageThatHasLeftLeavesNoConnection) {
  startMonitor();
  openPage();
  ASSERT_TRUE(hears("hello"));
  bridge_->closed(page_);
  EXPECT_TRUE(until([&] { return monitor_.peer == nullptr; }));
}

}  // namespace
}  // namespace darwinop
