// What nobody sends who means well, and who may come in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fixed_eye.hpp"
#include "remote/server/server.hpp"
#include "visits.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;

TEST(RemoteServer, AFloodOfRequestsIsAnsweredAsFarAsItIsRead) {
  FixedEye eye;
  eye.jpeg.assign(20000, 1);
  Served served{eye.opener()};
  TestClient client{served};
  flood(served, client, kCameraRequest, 2000);
  const std::size_t unread = served.robot.obeyed.size();
  EXPECT_LT(unread, 2000) << "nobody reads: 40 MB must not pile up here";
  served.pass(500ms);
  EXPECT_FALSE(served.robot.driven) << "who does not read its replies drives nothing";
  std::size_t received = 0;
  const auto give_up = std::chrono::steady_clock::now() + 20s;  // a full network takes its time to say that it has room
  while (received < 2000 * 20010 && std::chrono::steady_clock::now() < give_up) {
    received += client.receive(1 << 20).size();
    served.server.attend(1ms);
  }
  EXPECT_EQ(served.robot.obeyed.size(), 2000);
  EXPECT_EQ(received, 2000 * 20010);
}

TEST(RemoteServer, AFloodGetsNoMoreThanItsShareOfTheCpu) {
  Served served{{}, ServerConfig{}};
  TestClient client{served};
  flood(served, client, kEmptyRequest, 250);
  EXPECT_LE(served.robot.obeyed.size(), 64);
  EXPECT_GE(served.robot.obeyed.size(), 50);
  for (int ms = 0; ms < 200; ++ms) {
    const std::size_t before = served.robot.obeyed.size();
    served.pass(1ms);
    EXPECT_LE(served.robot.obeyed.size() - before, 2);
  }
  EXPECT_EQ(served.robot.obeyed.size(), 250) << "late, but each";
}

TEST(RemoteServer, CallersGetNoMoreThanTheirShareEither) {
  Served served{{}, {.allowed = {net::networkFromText("192.168.123.0/24")}}};
  int shown_out = 0;
  for (int i = 0; i < 67; ++i) shown_out += TestClient{served}.shownOut() ? 1 : 0;
  EXPECT_EQ(shown_out, 64) << "the others wait at the door";
  served.pass(2ms);
  EXPECT_TRUE(TestClient{served}.shownOut());
}

TEST(RemoteServer, WhoAsksEveryStepNeverWaitsForAnAllowance) {
  Served served{{}, ServerConfig{}};
  TestClient client{served};
  for (int step = 0; step < 500; ++step) {
    ASSERT_EQ(client.ask(kEmptyRequest), kEmptyReply) << step;
    served.now += 4ms;
  }
}

TEST(RemoteServer, AnswersOddRequestsAsTheOldOneAndSaysSoOnce) {
  Served served;
  TestClient client{served};
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(client.ask("57 08 00 47 41 50 03 00").size(), 3 * 18 - 1) << "the gyroscope alone";
    EXPECT_EQ(client.ask("57 0a 00 50 14 50 00 46 ff 00"), "57 00 00 00 11 00 00 00 00 00 00 00 00 00 00 00 00 00");
  }
  EXPECT_TRUE(served.hasSaid("received unknown message: byte 65 at offset 4"));
  EXPECT_TRUE(served.hasSaid("answered with 0"));
  EXPECT_LE(served.said.size(), 5);
}

TEST(RemoteServer, ShowsOutWhoStatesAnImpossibleLength) {
  Served served;
  TestClient client{served};
  client.send("57 ff ff 41");
  EXPECT_TRUE(client.shownOut());
  EXPECT_TRUE(served.robot.obeyed.empty());
  EXPECT_TRUE(nextIsAnswered(served));
}

// Any web page may have its reader's browser send this to a port of the reader's own computer.
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
  EXPECT_TRUE(served.robot.obeyed.empty());
  EXPECT_TRUE(served.robot.events.empty());
  EXPECT_TRUE(served.hasSaid("speaks another protocol"));
  EXPECT_TRUE(nextIsAnswered(served));
}

TEST(RemoteServer, WhoHasDrivenIsUnderstoodAgainAfterNonsense) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  EXPECT_EQ(client.ask(std::string{"00 01 02 "} + kNeckRequest), kEmptyReply);
  EXPECT_EQ(served.robot.obeyed.back().motors[0].position, 325);
  EXPECT_TRUE(served.hasSaid("bytes that begin no request are skipped"));
}

TEST(RemoteServer, KnowsWhoMayConnect) {
  Served served{{}, {.allowed = {net::networkFromText("192.168.123.0/24")}}};
  TestClient stranger{served};
  stranger.send(kNeckRequest);
  EXPECT_TRUE(stranger.shownOut());
  EXPECT_TRUE(served.robot.obeyed.empty());
  EXPECT_TRUE(served.hasSaid("may not connect"));
}

TEST(RemoteServer, ClientsThatComeAndGoDoNotFillTheLog) {
  Served served;
  for (int i = 0; i < 100; ++i) TestClient{served}.close();
  EXPECT_EQ(served.said.size(), net::BoundedLog::kLinesPerMinute);
  served.pass(61s);
  EXPECT_TRUE(served.hasSaid("170 more lines in that minute were left out"));
}

TEST(RemoteServer, SaysThatItsPortIsTaken) {
  Served served;
  FakeRobotPort robot;
  try {
    const Server second{{.port = served.server.port()}, robot, {}, [] { return Nanos{0}; }, [](auto&) {}};
    FAIL() << "two servers on one port";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("another server runs there"));
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
