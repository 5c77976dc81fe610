// The monitor's messages while a runtime starts, runs and ends. The test itself plays the runtime, in shared memory.
#include "monitor/monitor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/daemon.hpp"
#include "runtime/messages.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::monitor {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// Records the messages it is sent, texts by type.
struct FakeChannel final : web::Channel {
  std::string called = "test";
  std::vector<Json> texts;
  std::vector<std::string> types;
  int pictures = 0, forgot = 0;
  std::vector<std::string> order;  // of results and pictures

  [[nodiscard]] const std::string& name() const override { return called; }
  void send(web::Lane /*lane*/, web::Bytes text) override {
    texts.push_back(Json::parse(*text));
    types.push_back(texts.back()["type"]);
    if (types.back() == "found") order.push_back("found " + texts.back()["picture"].dump());
  }
  void sendBinary(web::Lane /*lane*/, web::Bytes bytes) override {
    ++pictures;
    order.push_back("picture " + std::to_string(static_cast<unsigned char>(bytes->at(8))));
  }
  void discardQueued() override { ++forgot; }
  [[nodiscard]] std::uint64_t lost() const override { return 0; }
  void close(const std::string& /*why*/) override {}

  [[nodiscard]] int count(const std::string& type) const { return static_cast<int>(std::ranges::count(types, type)); }
  [[nodiscard]] std::string last(const std::string& type) const {
    std::string found;
    for (const Json& text : texts)
      if (text["type"] == type) found = text.dump();
    return found;
  }
  void clear() {
    texts.clear();
    types.clear();
    pictures = 0;
  }
};

/// Finds one pixel in every frame that it is given while there is a search.
struct FakeColourSearch final : ColourSearch {
  std::vector<ColourQuery> searches;
  std::uint64_t newest = 0;

  void setSearches(const std::vector<ColourQuery>& requested) override { searches = requested; }
  void process(const CameraFrame& frame) noexcept override { newest = frame.sequence; }
  [[nodiscard]] std::optional<ColourMatch> resultOf(const ColourQuery& search, std::uint64_t picture) const override {
    if (picture != newest || std::ranges::find(searches, search) == searches.end()) return std::nullopt;
    ColourMatch result;
    result.picture = picture;
    result.width = result.height = 4;
    return result;
  }
};

struct FakePictures final : remote::PictureSource {
  int& open;
  std::uint64_t sequence = 0;
  std::array<std::uint8_t, 2> jpeg{0xFF, 0xD8};

  explicit FakePictures(int& counter) : open{counter} { ++open; }
  ~FakePictures() override { --open; }
  remote::JpegPicture newest() override {
    ++sequence;
    if (search) search->process({sequence, Nanos{0}, 4, 4, black});
    return {sequence, Nanos{0}, jpeg};
  }
  [[nodiscard]] std::string error() const override { return blind; }
  std::shared_ptr<FakeColourSearch> search;
  std::array<std::uint8_t, 64> black{};
  std::string blind;
};

class MonitorTest : public testing::Test {
 protected:
  /// Starts a runtime: takes the lock and creates the exchange; the test publishes.
  void begin() {
    lock_.emplace(runtime::claimRuntime(files_, static_cast<gid_t>(-1)));
    exchange_.emplace(runtime::Exchange::create(files_.exchange));
    exchange_->ownBlock().info.pid = getpid();
    exchange_->ownBlock().info.period_ns = 16'000'000;
    seen_ = {};
    seen_.period_ns = 16'000'000;
  }
  void end() {
    unlink(files_.exchange.c_str());
    exchange_.reset();
    lock_.reset();
  }
  void cycle() {
    ++seen_.cycle;
    seen_.time_ns = now_.count();
    exchange_->ownBlock().sensors.publish(seen_);
    exchange_->ownBlock().finished.set(static_cast<std::uint32_t>(seen_.cycle), exchange_->commands().wait);
  }
  /// Steps of about 16 ms: a cycle if there is a runtime, and an update of the monitor.
  void pass(Nanos time) {
    constexpr std::array<Nanos, 5> kSteps{16ms, 19ms, 13ms, 10ms, 22ms};  // thread jitter
    std::size_t step = 0;
    for (const Nanos last = now_ + time; now_ < last;) {
      now_ += kSteps[step++ % kSteps.size()];
      if (exchange_) cycle();
      monitor().update();
    }
  }
  Monitor& monitor() {
    if (!monitor_) {
      monitor_ = std::make_unique<Monitor>(
          files_, [this] { return now_; },
          [this] {
            auto pictures = std::make_unique<FakePictures>(cameras_open_);
            pictures->search = search_;
            pictures->blind = blind_;
            return pictures;
          },
          CameraSource::Open{}, search_);
    }
    return *monitor_;
  }
  void setFault(Fault fault, bool active) {
    for (std::size_t i = 0; i < kFaults; ++i)
      if (kFaultTable[i].fault == fault) seen_.safety.active[i] = active;
  }

  TemporaryFolder folder_;
  runtime::RuntimeFiles files_{folder_ / "runtime"};
  std::optional<runtime::FileLock> lock_;
  std::optional<runtime::Exchange> exchange_;
  Sensors seen_{};
  Nanos now_{std::chrono::hours{1}};
  int cameras_open_ = 0;
  std::shared_ptr<FakeColourSearch> search_ = std::make_shared<FakeColourSearch>();
  std::string blind_;
  FakeChannel observer_;
  std::unique_ptr<Monitor> monitor_;
};

TEST_F(MonitorTest, SendsHelloAndThenSensors) {
  begin();
  cycle();
  monitor().opened(observer_);
  EXPECT_THAT(observer_.types, ElementsAre("hello", "faults"));
  pass(2s);
  EXPECT_NEAR(observer_.count("state"), 40, 2) << "20 Hz";
  EXPECT_NEAR(observer_.count("loop"), 2, 1);
}

TEST_F(MonitorTest, GivesEachObserverItsOwnRate) {
  begin();
  FakeChannel every, none, seldom;
  for (FakeChannel* channel : {&observer_, &every, &none, &seldom}) monitor().opened(*channel);
  monitor().received(observer_, R"({"rate": 5})", false);
  monitor().received(every, R"({"rate": 62.5})", false);
  monitor().received(none, R"({"rate": 0})", false);
  monitor().received(seldom, R"({"rate": 1e-300})", false);
  pass(1600ms);
  EXPECT_NEAR(observer_.count("state"), 8, 1);
  EXPECT_EQ(every.count("state"), 100) << "each cycle";
  EXPECT_EQ(none.count("state"), 0);
  EXPECT_GE(none.count("loop"), 1);
  EXPECT_EQ(seldom.count("state"), 1) << "once at the start only";
  EXPECT_LE(monitor().pause(), 8ms);
  monitor().closed(every);
  every.clear();
  pass(100ms);
  EXPECT_TRUE(every.types.empty());
}

TEST_F(MonitorTest, SendsEachCycleOnce) {
  begin();
  monitor().opened(observer_);
  monitor().received(observer_, R"({"rate": 125})", false);
  pass(160ms);
  const int states = observer_.count("state");
  for (int i = 0; i < 20; ++i) monitor().update();  // no new cycle
  EXPECT_EQ(observer_.count("state"), states);
}

TEST_F(MonitorTest, MapsTheExchangeReadOnly) {
  begin();
  monitor().opened(observer_);
  pass(100ms);
  exchange_.reset();  // the loop's own mapping, in this test's process
  std::ifstream maps{"/proc/self/maps"};
  std::vector<std::string> rights;
  for (std::string address, right, rest; maps >> address >> right && std::getline(maps, rest);)
    if (rest.ends_with(files_.exchange)) rights.push_back(right);
  EXPECT_THAT(rights, ElementsAre("r--s"));
}

TEST_F(MonitorTest, AnswersAnInvalidRequestWithAnError) {
  begin();
  monitor().opened(observer_);
  observer_.clear();
  monitor().received(observer_, "faster!", false);
  monitor().received(observer_, R"({"rate": 5})", true);
  EXPECT_THAT(observer_.types, ElementsAre("error", "error"));
  pass(1s);
  EXPECT_NEAR(observer_.count("state"), 20, 1) << "the rate is as before";
}

TEST_F(MonitorTest, ReportsThatNoRuntimeRunsAndWhenOneStartsAndEnds) {
  monitor().opened(observer_);
  EXPECT_THAT(observer_.types, ElementsAre("hello", "gone"));
  EXPECT_TRUE(observer_.texts[0]["period"].is_null());
  EXPECT_THAT(observer_.texts[1]["reason"].get<std::string>(), HasSubstr("darwinop runtime"));

  observer_.clear();
  begin();
  pass(400ms);
  ASSERT_GE(observer_.types.size(), 3u);
  EXPECT_EQ(observer_.types[0], "hello");
  EXPECT_EQ(observer_.texts[0]["period"], 0.016);
  EXPECT_GT(observer_.count("state"), 0);
  EXPECT_GT(observer_.forgot, 0) << "queued messages describe the previous runtime";

  observer_.clear();
  end();
  pass(400ms);
  EXPECT_EQ(observer_.types[0], "gone");
  EXPECT_THAT(observer_.texts[0]["reason"].get<std::string>(), HasSubstr(runtime::messages::kRuntimeHasEnded));
  observer_.clear();
  begin();
  pass(400ms);
  EXPECT_EQ(observer_.types[0], "hello");
  EXPECT_GT(observer_.count("state"), 0) << "cycles count from 1 again";
}

TEST_F(MonitorTest, DetectsARuntimeThatHangs) {
  begin();
  monitor().opened(observer_);
  pass(100ms);
  observer_.clear();
  for (int i = 0; i < 60; ++i, now_ += 100ms) monitor().update();
  EXPECT_EQ(observer_.count("gone"), 1);
  EXPECT_THAT(observer_.last("gone"), HasSubstr(RuntimeObserver::kHangs));
  observer_.clear();
  pass(400ms);
  EXPECT_EQ(observer_.types[0], "hello") << "it runs cycles again";
}

TEST_F(MonitorTest, SendsFaultsAndSendsEarlierNoticesToNewObservers) {
  begin();
  monitor().opened(observer_);
  pass(200ms);
  setFault(Fault::kBatteryLow, true);
  pass(200ms);
  setFault(Fault::kBatteryLow, false);
  pass(200ms);
  EXPECT_EQ(observer_.count("faults"), 3);
  EXPECT_EQ(observer_.count("notice"), 2);
  FakeChannel newcomer;
  monitor().opened(newcomer);
  EXPECT_THAT(newcomer.types, ElementsAre("hello", "faults", "notice", "notice"));
  EXPECT_EQ(newcomer.texts[1]["active"].size(), 0u);
  EXPECT_THAT(newcomer.texts[2]["text"].get<std::string>(),
              testing::StartsWith("fault 20 battery_low: the supply is under"));
  EXPECT_EQ(newcomer.texts[3]["number"], 2);
}

TEST_F(MonitorTest, KeepsABoundedNumberOfNotices) {
  begin();
  for (int i = 0; i < 100; ++i) monitor().notice("again");
  monitor().opened(observer_);
  EXPECT_EQ(observer_.count("notice"), static_cast<int>(Monitor::kNotices));
  EXPECT_EQ(observer_.texts.back()["number"], 100);
}

TEST_F(MonitorTest, OpensTheCameraWhileItIsRequestedAndNoControllerDrives) {
  begin();
  monitor().opened(observer_);
  pass(100ms);
  EXPECT_EQ(cameras_open_, 0) << "not requested";
  monitor().received(observer_, R"({"camera": 10})", false);
  pass(1s);
  EXPECT_EQ(cameras_open_, 1);
  EXPECT_NEAR(observer_.pictures, 10, 2);
  EXPECT_EQ(observer_.count("camera"), 1);
  observer_.clear();
  {
    const auto lease = runtime::FileLock::tryTake(files_.drive_lock);
    pass(96ms);
    EXPECT_EQ(cameras_open_, 0) << "the camera is the controller's";
    ASSERT_EQ(observer_.count("camera"), 1);
    EXPECT_THAT(observer_.last("camera"), HasSubstr(CameraSource::kControllerDrives));
  }
  pass(200ms);
  EXPECT_EQ(cameras_open_, 1);
  monitor().closed(observer_);
  pass(32ms);
  EXPECT_EQ(cameras_open_, 0) << "no longer requested";
}

TEST_F(MonitorTest, KeepsTheCameraDuringADriveSessionOfItsOwnProcessIfConfigured) {
  begin();
  monitor().keepCameraForObservers();
  monitor().opened(observer_);
  monitor().received(observer_, R"({"camera": 10})", false);
  const auto lease = runtime::FileLock::tryTake(files_.drive_lock);
  pass(200ms);
  EXPECT_EQ(cameras_open_, 1);
}

TEST_F(MonitorTest, SendsTheSearchResultAheadOfThePicture) {
  begin();
  monitor().opened(observer_);
  monitor().received(observer_, R"({"camera": 10})", false);
  pass(300ms);
  EXPECT_EQ(observer_.count("found"), 0) << "not requested";
  observer_.order.clear();
  monitor().received(observer_, R"({"find": {"hue": 28}})", false);
  pass(500ms);
  ASSERT_GE(observer_.order.size(), 6U);
  for (std::size_t i = 0; i + 1 < 6; i += 2)
    EXPECT_EQ(observer_.order[i].substr(5), observer_.order[i + 1].substr(7))
        << testing::PrintToString(observer_.order);
  monitor().received(observer_, R"({"find": null})", false);
  const int before = observer_.count("found");
  pass(300ms);
  EXPECT_EQ(observer_.count("found"), before);
}

TEST_F(MonitorTest, ReportsWhyAnOpenCameraGivesNoPictures) {
  blind_ = "it is dark";
  begin();
  monitor().opened(observer_);
  monitor().received(observer_, R"({"camera": 10})", false);
  pass(100ms);
  EXPECT_THAT(observer_.last("camera"), HasSubstr("it is dark"));
}

TEST(MonitorCamera, UsesSharedFramesWhileAControllerDrives) {
  int own = 0, shown = 0;
  CameraSource camera{[&own] { return std::make_unique<FakePictures>(own); },
                      [&shown] { return std::make_unique<FakePictures>(shown); }};
  const auto open = [&] { return std::pair{own, shown}; };
  camera.update(true, true, Nanos{1h});
  EXPECT_EQ(open(), (std::pair{1, 0}));
  camera.update(true, false, Nanos{1h});
  EXPECT_EQ(open(), (std::pair{0, 1})) << "at once";
  EXPECT_TRUE(camera.shared());
  camera.update(true, true, Nanos{1h});
  EXPECT_EQ(open(), (std::pair{1, 0}));
  EXPECT_FALSE(camera.shared());
  camera.update(false, false, Nanos{1h});
  EXPECT_EQ(open(), (std::pair{0, 0})) << "not requested";
}

TEST(MonitorCamera, RetriesAfterFiveSecondsIfThereIsNoCamera) {
  int tries = 0;
  CameraSource camera{[&]() -> std::unique_ptr<remote::PictureSource> {
    ++tries;
    throw std::runtime_error("unplugged");
  }};
  for (int i = 0; i < 60; ++i) camera.update(true, true, Nanos{1h} + i * 100ms);
  EXPECT_EQ(tries, 2) << "every five seconds";
  EXPECT_EQ(camera.why(), "unplugged");
  EXPECT_EQ(camera.newest().sequence, 0u);
}

}  // namespace
}  // namespace darwinop::monitor
