// The server on real sockets of the loopback, with a scripted clock.
#include "remote/server/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "examples.hpp"
#include "served.hpp"

namespace darwinop::remote {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;

/// The robot's eye, which always sees the same; counts how often it is opened, and whether it is open.
struct FixedEye {
  ByteList jpeg = fromHex("ff d8 ff e0 00 10 ff d9");
  int opened = 0, open = 0;

  struct Pictures final : PictureSource {
    FixedEye& eye;
    explicit Pictures(FixedEye& its_eye) : eye{its_eye} {
      ++eye.opened;
      ++eye.open;
    }
    ~Pictures() override { --eye.open; }
    JpegPicture newest() override { return {.sequence = 1, .jpeg = eye.jpeg}; }
  };
  [[nodiscard]] Server::OpenPictures opener() {
    return [this] { return std::make_unique<Pictures>(*this); };
  }
};

TEST(RemoteServer, AnswersTheFirstRequestAtOnce) {
  Served served;
  TestClient client{served};
  EXPECT_TRUE(served.robot.events.empty()) << "who only connects moves nothing";
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
  EXPECT_THAT(served.robot.events, ElementsAre("fresh"));
}

TEST(RemoteServer, CommandsReachTheRobotAndValuesTheClient) {
  Served served;
  TestClient client{served};
  served.robot.seen.joint[18].position = Rad{0.00307};
  served.robot.seen.joint[19].position = Rad{0.191995};
  served.robot.seen.joint[18].load = -0.18817 / 2.5;
  EXPECT_EQ(client.ask(kFeedbackRequest), kFeedbackReply);
  EXPECT_EQ(client.ask(kNeckRequest), kEmptyReply);
  ASSERT_EQ(served.robot.obeyed.size(), 2);
  EXPECT_EQ(served.robot.obeyed[1].motors[0].position, 325);
}

TEST(RemoteServer, SensorsOfTheBoardAreCounts) {
  Served served;
  TestClient client{served};
  EXPECT_EQ(client.ask(kInertialRequest),
            "57 00 00 00 1d 00 00 02 00 00 00 02 00 00 00 02 00 00 00 02 00 00 00 02 00 00 00 02 00 00");
}

TEST(RemoteServer, ReplyAndNulLeaveTogether) {
  FixedEye eye;
  Served served{eye.opener()};
  TestClient client{served};
  EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
}

TEST(RemoteServer, WithoutAPictureThereAreNoBytesOfIt) {
  Served served;
  TestClient client{served};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.ask(kCameraRequest), "57 00 00 00 09 00 00 00 00 00");
  EXPECT_EQ(std::ranges::count_if(served.said, [](auto& line) { return line.find("pictures") != std::string::npos; }),
            1);
}

TEST(RemoteServer, AnEyeThatCannotBeOpenedIsNamedOnce) {
  Served served{[]() -> std::unique_ptr<PictureSource> { throw std::runtime_error("this one is blind"); }};
  TestClient client{served};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.ask(kCameraRequest), "57 00 00 00 09 00 00 00 00 00");
  EXPECT_TRUE(served.hasSaid("this one is blind"));
}

TEST(RemoteServer, TheEyeIsOpenWhileAClientDrivesThatLooks) {
  FixedEye eye;
  Served served{eye.opener()};
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  EXPECT_EQ(eye.open, 0) << "it does not look";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
  EXPECT_EQ(eye.opened, 1);
  served.pass(500ms);
  EXPECT_EQ(eye.open, 0) << "nobody encodes for a client that is silent";
  EXPECT_EQ(client.ask(kCameraRequest), kCameraReply);
  client.close();
  EXPECT_EQ(eye.open, 0);
  EXPECT_EQ(eye.opened, 2);
}

TEST(RemoteServer, AnswersEveryRequestHoweverItIsCut) {
  Served served;
  TestClient client{served};
  std::size_t rounds = 0;
  for (const char* const example : kRequests) {
    const ByteList bytes = fromHex(example);
    for (std::size_t cut = 1; cut < bytes.size(); ++cut, ++rounds) {
      client.send(ByteList(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(cut)));
      EXPECT_TRUE(client.receive().empty()) << example << " answered after " << cut << " bytes";
      client.send(ByteList(bytes.begin() + static_cast<std::ptrdiff_t>(cut), bytes.end()));
      const ByteList reply = client.receive();
      ASSERT_FALSE(reply.empty()) << example << " cut at " << cut;
      EXPECT_EQ(reply.size(), statedSize(reply));
    }
  }
  EXPECT_EQ(served.robot.obeyed.size(), rounds);
}

TEST(RemoteServer, AnswersTwoRequestsInOneSegment) {
  Served served;
  TestClient client{served};
  EXPECT_EQ(client.ask(std::string{kNeckRequest} + " " + kEmptyRequest), std::string{kEmptyReply} + " " + kEmptyReply);
}

TEST(RemoteServer, BothHistoricClientsReadTheirReplies) {
  FixedEye eye;
  eye.jpeg.assign(20000, 0x57);  // 'W' within a picture must not confuse anybody
  Served served{eye.opener()};
  for (const auto read : {readAsIn2013, readAsToday}) {
    TestClient client{served};
    for (int round = 0; round < 5; ++round) {
      client.send(round % 2 == 0 ? kPollRequest : kFeedbackRequest);
      ASSERT_FALSE(read(client).empty()) << round;
    }
    client.close();
  }
}

// A packet of its own for the NUL could come after the rest was read, and would then be taken for the next reply's
// head.
TEST(RemoteServer, NoNulTravelsAlone) {
  FixedEye eye;
  Served served{eye.opener()};
  TestClient client{served, 1000};
  std::vector<std::size_t> without;
  for (std::size_t size = 1; size < 3200; ++size) {
    eye.jpeg.assign(size, 0x57);
    client.send(kCameraRequest);
    const ByteList reply = readAsIn2013(client);
    ASSERT_FALSE(reply.empty()) << size;
    if (reply.size() != statedSize(reply)) without.push_back(reply.size());
  }
  ASSERT_GE(without.size(), 3) << "packets of 1000 bytes or less";
  EXPECT_LE(without[0], 1000);
  for (std::size_t i = 0; i < without.size(); ++i) EXPECT_EQ(without[i], (i + 1) * without[0]) << "whole packets";
}

TEST(RemoteServer, ASecondClientIsRefusedByTheDoor) {
  Served served;
  TestClient first{served};
  (void)first.ask(kEmptyRequest);
  TestClient second{served};
  EXPECT_FALSE(second.connected());
  EXPECT_EQ(first.ask(kEmptyRequest), kEmptyReply);
  EXPECT_TRUE(served.hasSaid("others are refused meanwhile"));
}

TEST(RemoteServer, HoldsWhenAClientLeavesAndTakesTheNext) {
  Served served;
  for (const bool rudely : {false, true}) {
    TestClient client{served};
    EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
    rudely ? client.reset() : client.close();
    EXPECT_FALSE(served.robot.driven);
  }
  EXPECT_THAT(served.robot.events, ElementsAre("fresh", "hold", "fresh", "hold"));
}

TEST(RemoteServer, AClientMayDieAtEveryByte) {
  Served served;
  const ByteList bytes = fromHex(std::string{kSixRequest} + " " + kPollRequest);
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    TestClient client{served};
    ASSERT_TRUE(client.connected()) << size;
    client.send(ByteList(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    size % 2 == 0 ? client.close() : client.reset();
    EXPECT_FALSE(served.robot.driven) << size;
  }
  TestClient last{served};
  EXPECT_EQ(last.ask(kEmptyRequest), kEmptyReply);
}

TEST(RemoteServer, HoldsASilentClientsRobotAndLetsItGoOn) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  served.pass(499ms);
  EXPECT_TRUE(served.robot.driven);
  served.pass(1ms);
  EXPECT_FALSE(served.robot.driven);
  served.pass(60s);  // a simulation may pause for as long as it likes
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
  EXPECT_THAT(served.robot.events, ElementsAre("fresh", "hold", "again"));
  TestClient late{served};
  EXPECT_FALSE(late.connected()) << "it drives again";
}

TEST(RemoteServer, ASilentClientGivesWayToTheNext) {
  Served served;
  TestClient silent{served};
  (void)silent.ask(kEmptyRequest);
  served.pass(500ms);
  TestClient next{served};
  EXPECT_EQ(next.ask(kEmptyRequest), kEmptyReply);
  EXPECT_TRUE(silent.shownOut());
  EXPECT_THAT(served.robot.events, ElementsAre("fresh", "hold", "fresh"));
}

TEST(RemoteServer, SlowBytesAreSilence) {
  Served served;
  TestClient slow{served};
  (void)slow.ask(kEmptyRequest);
  for (const std::uint8_t byte : fromHex("57 2f 00 41 47 43")) {
    slow.send(ByteList{byte});
    served.pass(100ms);
  }
  EXPECT_FALSE(served.robot.driven) << "bytes came all the time, and no request";
  TestClient next{served};
  EXPECT_EQ(next.ask(kEmptyRequest), kEmptyReply);
}

TEST(RemoteServer, AFloodOfRequestsIsAnsweredAsFarAsItIsRead) {
  FixedEye eye;
  eye.jpeg.assign(20000, 1);
  Served served{eye.opener()};
  TestClient client{served};
  ByteList flood;
  for (int i = 0; i < 2000; ++i)
    for (const std::uint8_t byte : fromHex(kCameraRequest)) flood.push_back(byte);
  client.send(flood);
  served.attend(100);
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
  ByteList flood;
  for (int i = 0; i < 250; ++i)
    for (const std::uint8_t byte : fromHex(kEmptyRequest)) flood.push_back(byte);
  client.send(flood);
  served.attend(100);
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
  Served served{{}, {.allowed = {networkFromText("192.168.123.0/24")}}};
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
  TestClient next{served};
  EXPECT_EQ(next.ask(kEmptyRequest), kEmptyReply);
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
  TestClient next{served};
  EXPECT_EQ(next.ask(kEmptyRequest), kEmptyReply);
}

TEST(RemoteServer, WhoHasDrivenIsUnderstoodAgainAfterNonsense) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  EXPECT_EQ(client.ask(std::string{"00 01 02 "} + kNeckRequest), kEmptyReply);
  EXPECT_EQ(served.robot.obeyed.back().motors[0].position, 325);
  EXPECT_TRUE(served.hasSaid("bytes that begin no request are skipped"));
}

TEST(RemoteServer, WaitsForTheFirstValuesOfServosThatWereWithoutPower) {
  Served served;
  const JointSensors neck = std::exchange(served.robot.seen.joint[18], JointSensors{});
  TestClient client{served};
  EXPECT_EQ(client.ask(std::string{kEmptyRequest}), kEmptyReply) << "nothing of the neck was asked";
  EXPECT_EQ(client.ask("57 06 00 50 12 00"), "");
  served.pass(1s);
  EXPECT_TRUE(served.robot.driven) << "waiting is not silence";
  served.robot.seen.joint[18] = neck;
  served.attend();
  EXPECT_EQ(toHex(client.receive()), "57 00 00 00 09 00 00 00 b4 00");
  EXPECT_EQ(client.ask(kEmptyRequest), kEmptyReply);
}

TEST(RemoteServer, AClientMayDieWhileItsAnswerWaits) {
  Served served;
  served.robot.seen.joint[18] = JointSensors{};
  TestClient client{served};
  EXPECT_EQ(client.ask("57 06 00 50 12 00"), "");
  client.reset();
  EXPECT_FALSE(served.robot.driven);
}

TEST(RemoteServer, SaysWhatItCannotKnow) {
  Served served;
  served.robot.seen.joint[18] = JointSensors{};
  served.robot.seen.joint[19].motion.age = 4;
  TestClient client{served};
  EXPECT_EQ(client.ask("57 08 00 50 12 50 13 00"), "");
  served.pass(2s);
  EXPECT_EQ(toHex(client.receive()), "57 00 00 00 0d 80 00 00 00 00 00 00 be 00");
  EXPECT_EQ(client.ask("57 08 00 50 12 50 13 00"), "57 00 00 00 0d 80 00 00 00 00 00 00 be 00")
      << "at once from now on";
  EXPECT_TRUE(served.hasSaid("Neck has never answered"));
  EXPECT_TRUE(served.hasSaid("Head has not answered for 3 cycles"));
}

TEST(RemoteServer, ShowsOutAClientForWhomThereIsNoRobot) {
  Served served;
  served.robot.refusal = "another controller (pid 7) drives this robot";
  TestClient client{served};
  client.send(kEmptyRequest);
  EXPECT_TRUE(client.shownOut());
  EXPECT_TRUE(served.hasSaid("another controller (pid 7)"));
}

TEST(RemoteServer, AClientEndsWhenAControllerWouldHaveTo) {
  Served served;
  TestClient client{served};
  (void)client.ask(kEmptyRequest);
  served.robot.must_end = "torque was switched off by the button";
  client.send(kNeckRequest);
  EXPECT_TRUE(client.shownOut());
  EXPECT_EQ(served.robot.obeyed.size(), 1) << "its command came too late";
  EXPECT_FALSE(served.robot.driven);
}

TEST(RemoteServer, KnowsWhoMayConnect) {
  Served served{{}, {.allowed = {networkFromText("192.168.123.0/24")}}};
  TestClient stranger{served};
  stranger.send(kNeckRequest);
  EXPECT_TRUE(stranger.shownOut());
  EXPECT_TRUE(served.robot.obeyed.empty());
  EXPECT_TRUE(served.hasSaid("may not connect"));
}

TEST(RemoteServer, ClientsThatComeAndGoDoNotFillTheLog) {
  Served served;
  for (int i = 0; i < 100; ++i) TestClient{served}.close();
  EXPECT_EQ(served.said.size(), BoundedLog::kLinesPerMinute);
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
  EXPECT_EQ(textFromIpv4(ipv4FromText("192.168.123.1")), "192.168.123.1");
  EXPECT_TRUE(isLoopback(ipv4FromText("127.0.0.1")));
  EXPECT_FALSE(isLoopback(ipv4FromText("0.0.0.0")));
  const Network home = networkFromText("192.168.123.0/24");
  EXPECT_TRUE(home.has(ipv4FromText("192.168.123.77")));
  EXPECT_FALSE(home.has(ipv4FromText("192.168.124.77")));
  EXPECT_TRUE(networkFromText("0.0.0.0/0").has(ipv4FromText("8.8.8.8")));
  EXPECT_FALSE(networkFromText("10.0.0.1").has(ipv4FromText("10.0.0.2")));
  for (const char* const wrong : {"", "localhost", "1.2.3", "1.2.3.4/", "1.2.3.4/33", "1.2.3.4/8x", "1.2.3.4/-1"})
    EXPECT_THROW((void)networkFromText(wrong), std::runtime_error) << wrong;
}

}  // namespace
}  // namespace darwinop::remote
