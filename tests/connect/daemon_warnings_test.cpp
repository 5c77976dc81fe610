// Warnings when a controller asks a daemon for what only the daemon's own start can give.
#include "connect/daemon_warnings.hpp"

#include <gmock/gmock.h>

namespace darwinop::connect {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

TEST(DaemonWarnings, SayNothingWhenNothingIsAskedFor) {
  EXPECT_EQ(daemonWarnings(ConnectRequest{}, 16ms), "");
}

TEST(DaemonWarnings, NameTheRightWayToRecord) {
  ConnectRequest request;
  request.record_path = "/tmp/walk.csv";
  EXPECT_THAT(daemonWarnings(request, 16ms), HasSubstr("darwinop runtime --record FILE"));
}

TEST(DaemonWarnings, NameBothPeriods) {
  ConnectRequest request;
  request.period = 8ms;
  const std::string logged = daemonWarnings(request, 16ms);
  EXPECT_THAT(logged, testing::AllOf(HasSubstr(" 16 ms"), HasSubstr(" 8 ms")));
  EXPECT_THAT(logged, HasSubstr("darwinop runtime --period 8\n"));
}

TEST(AsksForSafety, IsTrueForNumbersRangesChoicesAndNamedDefaults) {
  const auto asks = [](auto change) {
    safety::Config config;
    change(config);
    return asksForSafety(config);
  };
  EXPECT_TRUE(asks([](safety::Config& c) { c.stall_ms = 400; }));
  EXPECT_TRUE(asks([](safety::Config& c) { c.on_exit = safety::OnExit::kLimp; }));
  EXPECT_TRUE(asks([](safety::Config& c) { c.range[18].low = Rad{-0.5}; }));
  EXPECT_TRUE(asks([](safety::Config& c) { c.set("Safety", "hot", "65"); })) << "the robot's file may say less";
  EXPECT_FALSE(asks([](safety::Config& c) { c.period = 8ms; })) << "the loop's own period, no setting";
}

TEST(TcpWarnings, NameWhatTheRobotDecides) {
  EXPECT_EQ(tcpWarnings(ConnectRequest{}, 16ms), "");
  ConnectRequest request;
  request.record_path = "/tmp/walk.csv";
  request.period = 8ms;
  const std::string logged = tcpWarnings(request, 16ms);
  EXPECT_THAT(logged, HasSubstr("/tmp/walk.csv is not written"));
  EXPECT_THAT(logged, testing::AllOf(HasSubstr(" 16 ms"), HasSubstr(" 8 ms")));
}

}  // namespace
}  // namespace darwinop::connect
