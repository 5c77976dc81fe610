// Monitor, daemon and virtual robot as processes, in real time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hal/net/web/web_client.hpp"
#include "monitor/monitor.hpp"
#include "runtime/messages.hpp"
#include "system/rig.hpp"

namespace darwinop::monitor {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;
using web::WebClient;

class MonitorProcess : public Rig {
 protected:
  void startMonitor(std::vector<std::string> command = {}) {
    command.insert(command.end(), {program("darwinop-monitor"), "--port", "0"});
    monitor_ = std::make_unique<Program>(command, file("monitor.txt"));
    const std::string ready = "ready: ws://127.0.0.1:";
    ASSERT_TRUE(monitor_->says(ready, 20s)) << monitor_->output();
    const std::string said = monitor_->output();
    port_number_ = static_cast<std::uint16_t>(std::stoi(said.substr(said.find(ready) + ready.size())));
  }
  [[nodiscard]] std::unique_ptr<Program> startDaemon(const std::string& period = "16") const {
    return std::make_unique<Program>(
        std::vector<std::string>{program("darwinop-runtime"), "--robot", port(), "--period", period},
        file("daemon.txt"));
  }
  [[nodiscard]] WebClient observer(const std::string& subscription, int receive_buffer = 0) const {
    WebClient peer{port_number_, [] { std::this_thread::sleep_for(1ms); }, receive_buffer};
    EXPECT_THAT(peer.open("/monitor", "darwinop-monitor.1"), StartsWith("HTTP/1.1 101"));
    peer.send(subscription);
    return peer;
  }
  /// The next message that satisfies `wanted`; null: none within 20 s.
  template <class Wanted>
  static Json receiveUntil(WebClient& peer, Wanted wanted) {
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < give_up) {
      const auto received = peer.receiveMessage();
      if (!received) break;
      if (received->opcode != 1) continue;
      if (Json text = Json::parse(received->bytes); wanted(text)) return text;
    }
    return {};
  }
  static Json receiveType(WebClient& peer, const std::string& type) {
    return receiveUntil(peer, [&type](const Json& text) { return text["type"] == type; });
  }

  /// Waits for camera status "seeing", then for a JPEG picture.
  static bool receivePicture(WebClient& peer) {
    if (receiveUntil(peer, [](const Json& text) {
          return text["type"] == "camera" && text["seeing"] == true;
        }).is_null())
      return false;
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < give_up) {
      const auto received = peer.receiveMessage();
      if (!received) break;
      if (received->opcode == 2) return received->bytes.substr(20, 2) == "\xFF\xD8";
    }
    return false;
  }

  std::unique_ptr<Program> monitor_;
  std::uint16_t port_number_ = 0;
};

TEST_F(MonitorProcess, ShowsAMoveAFaultAndADaemonThatDiesAndComesBack) {
  startMonitor();
  WebClient peer = observer(R"({"rate": 30})");
  EXPECT_TRUE(receiveType(peer, "hello")["period"].is_null());
  EXPECT_THAT(receiveType(peer, "gone")["reason"].dump(), HasSubstr("darwinop runtime"));

  startVirtualRobot("6 dead Head\n");
  auto daemon = startDaemon();
  EXPECT_EQ(receiveType(peer, "hello")["period"], 0.016) << monitor_->output() << daemon->output();
  EXPECT_FALSE(receiveUntil(peer, [](const Json& text) {
                 return text["type"] == "state" && text["state"] == "limp";
               }).is_null());

  Program driver{{program("darwinop-run"), "--robot", "runtime", controller(), "100000"}, file("run.txt")};
  const auto neck_is = [](double low, double high) {
    return [=](const Json& text) {
      if (text["type"] != "state" || !text["joints"]["position"][18].is_number()) return false;
      const double neck = text["joints"]["position"][18];
      return neck > low && neck < high;
    };
  };
  EXPECT_FALSE(receiveUntil(peer, neck_is(0.3, 0.6)).is_null()) << driver.output();
  EXPECT_FALSE(receiveUntil(peer, neck_is(-0.6, -0.3)).is_null()) << driver.output();
  EXPECT_TRUE(receiveType(peer, "loop")["driver"]["pid"].is_number());

  const Json fault =
      receiveUntil(peer, [](const Json& text) { return text["type"] == "notice" && text["time"].is_number(); });
  EXPECT_THAT(fault["text"].dump(), HasSubstr("fault 12 servo_silent (Head, id 20)"));
  WebClient newcomer = observer("{}");
  // On a busy machine any servo may be silent now and then; this one stays silent.
  const auto is_silent = [](const Json& text) {
    return text["type"] == "state" && text["joints"]["position"][19].is_null() && text["joints"]["silent"][19] == true;
  };
  EXPECT_FALSE(receiveUntil(newcomer, is_silent).is_null());
  WebClient third = observer("{}");
  EXPECT_EQ(receiveType(third, "faults")["active"][0]["name"], "servo_silent");

  daemon->kill(SIGKILL);
  EXPECT_THAT(receiveType(peer, "gone")["reason"].dump(), HasSubstr(runtime::messages::kRuntimeHasEnded));
  driver.kill(SIGKILL);
  daemon->wait(5s);
  daemon = startDaemon();
  EXPECT_EQ(receiveType(peer, "hello")["period"], 0.016) << daemon->output();
  EXPECT_FALSE(receiveType(peer, "state").is_null());
  monitor_->kill(SIGTERM);
  EXPECT_EQ(monitor_->wait(5s), 0);
}

TEST_F(MonitorProcess, DropsMessagesOfSlowObserversOnly) {
  startVirtualRobot();
  const auto daemon = startDaemon("8");
  ASSERT_TRUE(daemon->says("ready:", 20s)) << daemon->output();
  startMonitor();
  WebClient slow = observer(R"({"rate": 125})", 4096), quick = observer(R"({"rate": 125})");
  std::vector<WebClient> others;
  others.reserve(6);
  for (int i = 0; i < 6; ++i) others.push_back(observer(R"({"rate": 125})"));
  const auto doze = [] { std::this_thread::sleep_for(1ms); };
  const WebClient silent{port_number_, doze};
  WebClient ninth{port_number_, doze};
  EXPECT_THAT(ninth.open("/monitor", "darwinop-monitor.1"), StartsWith("HTTP/1.1 503"));

  const std::uint64_t first = receiveType(quick, "state")["cycle"];
  std::uint64_t last = first;
  int received = 0;
  for (Json text; last < first + 400; last = text["cycle"], ++received) {
    text = receiveType(quick, "state");
    ASSERT_FALSE(text.is_null());
  }
  for (WebClient& other : others)  // not read so far, so some of their messages were dropped
    EXPECT_FALSE(
        receiveUntil(other, [first](const Json& t) { return t["type"] == "state" && t["cycle"] > first; }).is_null());
  EXPECT_GT(received, 200) << "of 400 cycles; a busy machine costs some";
  const Json loop = receiveType(quick, "loop");
  RecordProperty("overruns", loop["overruns"].get<int>());  // recorded, not checked: the machine may be busy
  RecordProperty("cycles", loop["cycles"].get<int>());

  int late = 0;
  const auto counted = [&late, last](const Json& text) {
    if (text["type"] != "state") return false;
    ++late;
    return text["cycle"] >= last;
  };
  EXPECT_FALSE(receiveUntil(slow, counted).is_null()) << "the newest state arrives last";
  EXPECT_LT(late, received) << "most were dropped";
  EXPECT_FALSE(
      receiveUntil(slow, [](const Json& text) { return text["type"] == "loop" && text["lost"] > 0; }).is_null());
}

#ifdef DARWINOP_VISUAL_TRACKING  // where there is a virtual camera
TEST_F(MonitorProcess, ShowsSharedFramesOfADriverAndThenItsOwnCamera) {
  startVirtualRobot();
  const auto daemon = startDaemon();
  ASSERT_TRUE(daemon->says("ready:", 20s)) << daemon->output();
  const std::string camera = program("darwinop-virtual-camera");  // a camera for each of the two
  startMonitor({camera, "--"});
  const Program driver{{camera, "--", program("darwinop-run"), "--robot", "runtime", DARWINOP_VISUAL_TRACKING},
                       file("run.txt")};
  WebClient peer = observer("{}");
  const auto driven = [](const Json& text) { return text["type"] == "loop" && text["driver"].is_object(); };
  const Json loop = receiveUntil(peer, driven);
  ASSERT_FALSE(loop.is_null()) << driver.output();
  peer.send(R"({"camera": 30})");
  EXPECT_THAT(receiveType(peer, "camera")["text"].dump(), HasSubstr(Monitor::kNoSharedPictures));
  EXPECT_TRUE(receivePicture(peer)) << monitor_->output() << driver.output();
  EXPECT_TRUE(std::filesystem::exists(file("runtime.pictures")));

  ::kill(loop["driver"]["pid"], SIGKILL);  // perhaps in the middle of a picture
  EXPECT_THAT(receiveType(peer, "camera")["text"].dump(), HasSubstr(Monitor::kCameraIsBlind));
  EXPECT_TRUE(receivePicture(peer)) << monitor_->output();
}
#endif

TEST_F(MonitorProcess, RequiresAllowBeforeItListensOnANetwork) {
  Program refused{{program("darwinop-monitor"), "--listen", "0.0.0.0"}, file("monitor.txt")};
  EXPECT_EQ(refused.wait(20s), 2);
  EXPECT_THAT(refused.output(), HasSubstr("--allow 192.168.123.0/24"));
}

}  // namespace
}  // namespace darwinop::monitor
