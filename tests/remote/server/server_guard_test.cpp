// Hostile and invalid requests, rate limit and access control.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fixed_eye.hpp"
#include "remote/server/messages.hpp"
#include "remote/server/server.hpp"
#include "visits.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;

TEST(RemoteServer, AFloodOfRequestsIsAnsweredAsFastAsItsRepliesAreRead) {
  FixedEye eye;
  eye.jpeg.assign(20000, 1);
  Served served{eye.opener()};
  TestClient client{served};
  flood(served, client, kCameraRequest, 2000);
  const std::size_t unread = served.robot.applied.size();
  EXPECT_LT(unread, 2000) << "replies are not read: 40 MB must not be buffered";
  served.pass(500ms);
  EXPECT_FALSE(served.robot.driven) << "a client that does not read its replies does not drive";
  std::size_t received = 0;
  const auto give_up = std::chrono::steady_clock::now() + 20s;  // the kernel reports free buffer space with a delay
  while (received < 2000 * 20010 && std::chrono::steady_clock::now() < give_up) {
    received += client.receive(1 << 20).size();
    served.server.poll(1ms);
  }
  EXPECT_EQ(served.robot.applied.size(), 2000);
  EXPECT_EQ(received, 2000 * 20010);
}

TEST(RemoteServer, AFloodIsLimitedToItsShareOfTheCpu) {
  Served served{{}, ServerConfig{}};
  TestClient client{served};
  flood(served, client, kEmptyRequest, 250);
  EXPECT_LE(served.robot.applied.size(), 64);
  EXPECT_GE(served.robot.applied.size(), 50);
  for (int ms = 0; ms < 200; ++ms) {
    const std::size_t before = served.robot.applied.size();
    served.pass(1ms);
    EXPECT_LE(served.robot.applied.size() - before, 2);
  }
  EXPECT_EQ(served.robot.applied.size(), 250) << "late, but each";
}

TEST(RemoteServer, ConnectionsAreLimitedToTheirShareOfTheCpu) {
  Served served{{}, {.allowed = {net::networkFromText("192.168.123.0/24")}}};
  int shown_out = 0;
  for (int i = 0; i < 67; ++i) shown_out += TestClient{served}.shownOut() ? 1 : 0;
  EXPECT_EQ(shown_out, 64) << "the others wait at the door";
  served.pass(2ms);
  EXPECT_TRUE(TestClient{served}.shownOut());
}

TEST(RemoteServer, AClientWithOneRequestPerStepIsNeverLimited) {
  Served served{{}, ServerConfig{}};
  TestClient client{served};
  for (int step = 0; step < 500; ++step) {
    ASSERT_EQ(client.ask(kEmptyRequest), kEmptyReply) << step;
    served.now += 4ms;
  }
}

TEST(RemoteServer, AnswersInvalidRequestsAsThe2013ServerAndLogsThemOnce) {
  Served served;
  TestClient client{served};
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(client.ask("57 08 00 47 41 50 03 00").size(), 3 * 18 - 1) << "the gyroscope alone";
    EXPECT_EQ(client.ask("57 0a 00 50 14 50 00 46 ff 00"), "57 00 00 00 11 00 00 00 00 00 00 00 00 00 00 00 00 00");
  }
  EXPECT_TRUE(served.hasSaid(messages::kUnknownSection + std::string{"65 at offset 4"}));
  EXPECT_TRUE(served.hasSaid(messages::kUnknownJoints));
  EXPECT_LE(served.said.size(), 5);
}

TEST(RemoteServer, DisconnectsAClientThatSendsAnInvalidLength) {
  Served served;
  TestClient client{served};
  client.send("57 ff ff 41");
  EXPECT_TRUE(client.shownOut());
  EXPECT_TRUE(served.robot.applied.empty());
  EXPECT_TRUE(nextIsAnswered(served));
}

// Any web page can make a browser send this to a local port.
TEST(RemoteServer, AWebPageCannotDriveTheRobot) {
  Served served;
  for (const std::size_t first_piece : {std::size_t{200}, std::size_t{1}}) {
    const std::string head = "POST / HTTP/1.1\r\nHost: 127.0.0.1:5023\r\nContent-Length: 11\r\n\r\n";
    ByteList bytes(head.begin(), head.end());
    for (const std::uint8_t byte : fromHex(kNeckRequest)) bytes.push_back(byte);
    const auto cut = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(first_piece, bytes.size()));
    TestClient browser{served};
    browser.send(ByteList(bytes.begin(), cut));
    browser.send(ByteList(cut, bytes.end()));
    EXPECT_TRUE(browser.shownOut());
  }
  EXPECT_TRUE(served.robot.applied.empty());
  EXPECT_TRUE(served.robot.events.empty());
  EXPECT_TRUE(served.hasSaid(messages::kOtherProtocol));
  EXPECT_TRUE(nextIsAnswered(served));
}

TEST(RemoteServer, AClientThatHasDrivenMayContinueAfterInvalidBytes) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  EXPECT_EQ(client.ask(std::string{"00 01 02 "} + kNeckRequest), kEmptyReply);
  EXPECT_EQ(served.robot.applied.back().motors[0].position, 325);
  EXPECT_TRUE(served.hasSaid(messages::kSkippedBytes));
}

TEST(RemoteServer, AcceptsAllowedNetworksOnly) {
  Served served{{}, {.allowed = {net::networkFromText("192.168.123.0/24")}}};
  TestClient foreign{served};
  foreign.send(kNeckRequest);
  EXPECT_TRUE(foreign.shownOut());
  EXPECT_TRUE(served.robot.applied.empty());
  EXPECT_TRUE(served.hasSaid("--allow"));
}

TEST(RemoteServer, ReconnectingClientsDoNotFillTheLog) {
  Served served;
  for (int i = 0; i < 100; ++i) TestClient{served}.close();
  EXPECT_EQ(served.said.size(), net::BoundedLog::kLinesPerMinute);
  served.pass(61s);
  EXPECT_TRUE(served.hasSaid("170 more lines in that minute were left out"));
}

TEST(RemoteServer, ReportsThatItsPortIsInUse) {
  Served served;
  FakeRobotPort robot;
  try {
    const Server second{{.port = served.server.port()}, robot, {}, [] { return Nanos{0}; }, [](auto&) {}};
    FAIL() << "two servers on one port";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr(std::to_string(served.server.port())), testing::HasSubstr("--port")));
  }
}

TEST(RemoteAddresses, AreReadAndWritten) {
  EXPECT_EQ(net::textFromIpv4(net::ipv4FromText("192.168.123.1")), "192.168.123.1");
  EXPECT_TRUE(net::isLoopback(net::ipv4FromText("127.0.0.1")));
  EXPECT_FALSE(net::isLoopback(net::ipv4FromText("0.0.0.0")));
  const net::Network home = net::networkFromText("192.168.123.0/24");
  EXPECT_TRUE(home.has(net::ipv4FromText("192.168.123.77")));
  EXPECT_FALSE(home.has(net::ipv4FromText("192.168.124.77")));
  EXPECT_TRUE(net::networkFromText("0.0.0.0/0").has(net::ipv4FromText("8.8.8.8")));
  EXPECT_FALSE(net::networkFromText("10.0.0.1").has(net::ipv4FromText("10.0.0.2")));
  for (const char* const wrong : {"", "localhost", "1.2.3", "1.2.3.4/", "1.2.3.4/33", "1.2.3.4/8x", "1.2.3.4/-1"})
    EXPECT_THROW((void)net::networkFromText(wrong), std::runtime_error) << wrong;
}

}  // namespace
}  // namespace darwinop::remote
