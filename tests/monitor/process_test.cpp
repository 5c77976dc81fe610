// The monitor beside a daemon on a virtual robot's pty, all as processes, in real time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hal/net/web/web_client.hpp"
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
  [[nodiscard]] WebClient observer(const std::string& wishes, int receive_buffer = 0) const {
    WebClient peer{port_number_, [] { std::this_thread::sleep_for(1ms); }, receive_buffer};
    EXPECT_THAT(peer.open("/monitor", "darwinop-monitor.1"), StartsWith("HTTP/1.1 101"));
    peer.say(wishes);
    return peer;
  }
  /// The next message that `wanted` is true of; null: none came within 20 s.
  template <class Wanted>
  static Json hearUntil(WebClient& peer, Wanted wanted) {
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < give_up) {
      const auto heard = peer.hear();
      if (!heard) break;
      if (heard->opcode != 1) continue;
      if (Json text = Json::parse(heard->bytes); wanted(text)) return text;
    }
    return {};
  }
  static Json hearType(WebClient& peer, const std::string& type) {
    return hearUntil(peer, [&type](const Json& text) { return text["type"] == type; });
  }

  /// A picture, of a camera of which the observer has been told that it sees.
  static bool hearPicture(WebClient& peer) {
    if (hearUntil(peer, [](const Json& text) { return text["type"] == "camera" && text["seeing"] == true; }).is_null())
      return false;
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < give_up) {
      const auto heard = peer.hear();
      if (!heard) break;
      if (heard->opcode == 2) return heard->bytes.substr(20, 2) == "\xFF\xD8";
    }
    return false;
  }

  std::unique_ptr<Program> monitor_;
  std::uint16_t port_number_ = 0;
};

TEST_F(MonitorProcess, ShowsAMoveAFaultAndADaemonThatDiesAndComesBack) {
  startMonitor();
  WebClient peer = observer(R"({"rate": 30})");
  EXPECT_TRUE(hearType(peer, "hello")["period"].is_null());
  EXPECT_THAT(hearType(peer, "gone")["reason"].dump(), HasSubstr("darwinop runtime"));

  startVirtualRobot("6 dead Head\n");
  auto daemon = startDaemon();
  EXPECT_EQ(hearType(peer, "hello")["period"], 0.016) << monitor_->output() << daemon->output();
  EXPECT_FALSE(
      hearUntil(peer, [](const Json& text) { return text["type"] == "state" && text["state"] == "limp"; }).is_null());

  Program driver{{program("darwinop-run"), "--robot", "runtime", controller(), "100000"}, file("run.txt")};
  const auto neck_is = [](double low, double high) {
    return [=](const Json& text) {
      if (text["type"] != "state" || !text["joints"]["position"][18].is_number()) return false;
      const double neck = text["joints"]["position"][18];
      return neck > low && neck < high;
    };
  };
  EXPECT_FALSE(hearUntil(peer, neck_is(0.3, 0.6)).is_null()) << driver.output();
  EXPECT_FALSE(hearUntil(peer, neck_is(-0.6, -0.3)).is_null()) << driver.output();
  EXPECT_TRUE(hearType(peer, "loop")["driver"]["pid"].is_number());

  const Json fault =
      hearUntil(peer, [](const Json& text) { return text["type"] == "notice" && text["time"].is_number(); });
  EXPECT_THAT(fault["text"].dump(), HasSubstr("fault 12 servo_silent (Head, id 20)"));
  WebClient newcomer = observer("{}");
  // On a busy machine a servo may be silent now and then; this one stays so.
  const auto is_silent = [](const Json& text) {
    return text["type"] == "state" && text["joints"]["position"][19].is_null() && text["joints"]["silent"][19] == true;
  };
  EXPECT_FALSE(hearUntil(newcomer, is_silent).is_null());
  WebClient third = observer("{}");
  EXPECT_EQ(hearType(third, "faults")["active"][0]["name"], "servo_silent");

  daemon->kill(SIGKILL);
  EXPECT_THAT(hearType(peer, "gone")["reason"].dump(), HasSubstr("has ended"));
  driver.kill(SIGKILL);
  daemon->wait(5s);
  daemon = startDaemon();
  EXPECT_EQ(hearType(peer, "hello")["period"], 0.016) << daemon->output();
  EXPECT_FALSE(hearType(peer, "state").is_null());
  monitor_->kill(SIGTERM);
  EXPECT_EQ(monitor_->wait(5s), 0);
}

TEST_F(MonitorProcess, LosesFramesOfSlowObserversAndNothingElse) {
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

  const std::uint64_t first = hearType(quick, "state")["cycle"];
  std::uint64_t last = first;
  int heard = 0;
  for (Json text; last < first + 400; last = text["cycle"], ++heard) {
    text = hearType(quick, "state");
    ASSERT_FALSE(text.is_null());
  }
  for (WebClient& other : others)  // nobody read them all this time, so they have lost some, too
    EXPECT_FALSE(
        hearUntil(other, [first](const Json& t) { return t["type"] == "state" && t["cycle"] > first; }).is_null());
  EXPECT_GT(heard, 200) << "of 400 cycles; a busy machine costs some";
  const Json loop = hearType(quick, "loop");
  RecordProperty("overruns", loop["overruns"].get<int>());  // a figure, no judgement: the machine has other work
  RecordProperty("cycles", loop["cycles"].get<int>());

  int late = 0;
  const auto counted = [&late, last](const Json& text) {
    if (text["type"] != "state") return false;
    ++late;
    return text["cycle"] >= last;
  };
  EXPECT_FALSE(hearUntil(slow, counted).is_null()) << "the newest state comes in the end";
  EXPECT_LT(late, heard) << "most were thrown away";
  EXPECT_FALSE(hearUntil(slow, [](const Json& text) { return text["type"] == "loop" && text["lost"] > 0; }).is_null());
}

#ifdef DARWINOP_VISUAL_TRACKING  // where there is a virtual camera
TEST_F(MonitorProcess, ShowsWhatTheCameraOfADriverSeesAndThenItsOwn) {
  startVirtualRobot();
  const auto daemon = startDaemon();
  ASSERT_TRUE(daemon->says("ready:", 20s)) << daemon->output();
  const std::string camera = program("darwinop-virtual-camera");  // a camera for each of the two
  startMonitor({camera, "--"});
  const Program driver{{camera, "--", program("darwinop-run"), "--robot", "runtime", DARWINOP_VISUAL_TRACKING},
                       file("run.txt")};
  WebClient peer = observer("{}");
  const auto driven = [](const Json& text) { return text["type"] == "loop" && text["driver"].is_object(); };
  const Json loop = hearUntil(peer, driven);
  ASSERT_FALSE(loop.is_null()) << driver.output();
  peer.say(R"({"camera": 30})");
  EXPECT_THAT(hearType(peer, "camera")["text"].dump(), HasSubstr("a controller drives"));
  EXPECT_TRUE(hearPicture(peer)) << monitor_->output() << driver.output();
  EXPECT_TRUE(std::filesystem::exists(file("runtime.pictures")));

  ::kill(loop["driver"]["pid"], SIGKILL);  // perhaps in the middle of a picture
  EXPECT_THAT(hearType(peer, "camera")["text"].dump(), HasSubstr("the camera gives no pictures"));
  EXPECT_TRUE(hearPicture(peer)) << monitor_->output();
}
#endif

TEST_F(MonitorProcess, AsksWhoMayLookBeforeItShowsTheRobotToANetwork) {
  Program refused{{program("darwinop-monitor"), "--listen", "0.0.0.0"}, file("monitor.txt")};
  EXPECT_EQ(refused.wait(20s), 1);
  EXPECT_THAT(refused.output(), HasSubstr("--allow 192.168.123.0/24"));
}

}  // namespace
}  // namespace darwinop::monitor
