// Bridge to a monitor: a real server and connection on loopback, and a fake page.
#include "window/view/bridge.hpp"

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

/// A monitor that sends what the test provides.
struct FakeMonitor final : web::ChannelHandler {
  void opened(web::Channel& channel) override {
    peer = &channel;
    send(R"({"type":"hello","period":0.016})");
  }
  void received(web::Channel&, std::string_view message, bool) override { requests.emplace_back(message); }
  void closed(web::Channel&) noexcept override { peer = nullptr; }
  void send(const std::string& text) const { peer->send(web::kEvery, std::make_shared<const std::string>(text)); }

  web::Channel* peer = nullptr;
  std::vector<std::string> requests;
};

struct FakePage final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane lane, web::Bytes text) override {
    lanes.push_back(lane);
    received.push_back(*text);
  }
  void sendBinary(web::Lane, web::Bytes bytes) override { received.push_back("picture " + *bytes); }
  void discardQueued() override { ++forgotten; }
  std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  std::string who = "page";
  std::vector<std::string> received;
  std::vector<web::Lane> lanes;
  int forgotten = 0;
};

class WindowBridge : public testing::Test {
 protected:
  void startMonitor(std::uint16_t port = 0) {
    web::WebServerConfig config;
    config.port = port;
    server_ = std::make_unique<web::WebServer>(config, [](const std::string&) {});
    server_->channel("/monitor", protocol_, monitor_);
    port_ = server_->port();
  }
  template <class Done>
  [[nodiscard]] bool until(Done done) {
    for (const auto end = std::chrono::steady_clock::now() + 20s; std::chrono::steady_clock::now() < end;) {
      if (server_)
        server_->poll(1ms);
      else
        std::this_thread::sleep_for(1ms);
      bridge_->update();
      if (done()) return true;
    }
    return false;
  }
  [[nodiscard]] bool receives(const std::string& part) {
    return until([&] {
      return std::ranges::any_of(page_.received,
                                 [&](const auto& text) { return text.find(part) != std::string::npos; });
    });
  }
  void openPage() {
    bridge_ = std::make_unique<window::Bridge>(0x7F000001, port_, "robot:5024");
    bridge_->opened(page_);
  }

  FakeMonitor monitor_;
  FakePage page_;
  std::unique_ptr<web::WebServer> server_;
  std::unique_ptr<window::Bridge> bridge_;
  std::string protocol_ = "darwinop-monitor.1";
  std::uint16_t port_ = 0;
};

TEST_F(WindowBridge, ForwardsMessagesOfTheMonitorAndRequestsOfThePage) {
  startMonitor();
  openPage();
  ASSERT_TRUE(receives("hello"));
  bridge_->received(page_, R"({"rate": 62.5})", false);
  bridge_->received(page_, R"({"camera": 10, "find": {"hue": 28}})", false);
  EXPECT_TRUE(
      until([&] { return !monitor_.requests.empty() && monitor_.requests.back().find("10.0") != std::string::npos; }));
  EXPECT_THAT(monitor_.requests.back(), HasSubstr(R"({"rate":62.5,"camera":10.0,"find":{"hue":28,)"));

  monitor_.send(R"({"type":"state","cycle":7})");
  monitor_.send(R"({"type":"notice","number":1})");
  monitor_.send("no JSON");
  monitor_.send(R"({"type":7})");
  monitor_.peer->sendBinary(web::kEvery, std::make_shared<const std::string>("jpeg"));
  ASSERT_TRUE(receives("picture jpeg"));
  EXPECT_THAT(page_.received, Contains(R"({"type":"state","cycle":7})"));
  EXPECT_EQ(page_.received.size(), 4U) << "invalid messages are not forwarded";
  EXPECT_LT(page_.lanes.at(1), web::kLanes) << "states replace each other";
  EXPECT_EQ(page_.lanes.at(2), web::kEvery) << "notices are all kept";
}

TEST_F(WindowBridge, ReportsABrokenConnectionOnceAndRestoresItsRequest) {
  startMonitor();
  openPage();
  bridge_->received(page_, R"({"rate": 62.5})", false);
  ASSERT_TRUE(receives("hello"));
  const std::uint16_t port = port_;
  server_.reset();
  ASSERT_TRUE(receives(R"("gone")"));
  EXPECT_THAT(page_.received.back(), HasSubstr("robot:5024"));
  page_.received.clear();
  monitor_.requests.clear();
  startMonitor(port);
  ASSERT_TRUE(receives("hello"));
  EXPECT_TRUE(until([&] { return !monitor_.requests.empty(); }));
  EXPECT_THAT(monitor_.requests, Contains(HasSubstr("62.5")));
}

TEST_F(WindowBridge, ReportsAServerThatIsNotAMonitor) {
  protocol_ = "something.else";
  startMonitor();
  openPage();
  EXPECT_TRUE(receives("HTTP status 400"));
}

TEST_F(WindowBridge, ClosesTheConnectionOfAClosedPage) {
  startMonitor();
  openPage();
  ASSERT_TRUE(receives("hello"));
  bridge_->closed(page_);
  EXPECT_TRUE(until([&] { return monitor_.peer == nullptr; }));
}

}  // namespace
}  // namespace darwinop
