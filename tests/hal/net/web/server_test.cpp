// The web server on a loopback port, with clients written by hand.
#include "hal/net/web/server.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <set>

#include "hal/net/web/messages.hpp"
#include "web_client.hpp"

namespace darwinop::web {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

/// Sends every message back.
struct Echo final : ChannelHandler {
  std::set<Channel*> open;
  int ended = 0;

  void opened(Channel& channel) override {
    open.insert(&channel);
    channel.send(kEvery, std::make_shared<const std::string>("welcome"));
  }
  void received(Channel& channel, std::string_view message, bool binary) override {
    if (message == "out") return channel.close("test");
    const auto bytes = std::make_shared<const std::string>(message);
    binary ? channel.sendBinary(kEvery, bytes) : channel.send(kEvery, bytes);
  }
  void closed(Channel& channel) noexcept override {
    open.erase(&channel);
    ++ended;
  }
};

class WebServerTest : public testing::Test {
 protected:
  explicit WebServerTest(const WebServerConfig& config = {})
      : server_{std::make_unique<WebServer>(config, [this](const std::string& line) { log_ += line + "\n"; })} {
    server_->serve("/", {.type = "text/html", .body = "<p>hello"});
    server_->serve("/large", {.type = "text/html", .body = std::string(8 << 20, ' ')});
    server_->channel("/echo", "echo.1", echo_);
  }
  [[nodiscard]] WebClient client(int receive_buffer = 0) {
    return {server_->port(), [this] { server_->poll(1ms); }, receive_buffer};
  }
  [[nodiscard]] std::string ask(const std::string& request) { return client().ask(request); }
  /// A client with an open channel that has received the welcome message.
  [[nodiscard]] WebClient observer(int receive_buffer = 0) {
    WebClient peer = client(receive_buffer);
    EXPECT_THAT(peer.open("/echo", "other, echo.1"), StartsWith("HTTP/1.1 101")) << log_;
    EXPECT_EQ(peer.receiveMessage().value_or(ReceivedMessage{}).bytes, "welcome");
    return peer;
  }

  std::string log_;
  Echo echo_;
  std::unique_ptr<WebServer> server_;
};

TEST_F(WebServerTest, ServesItsPagesAndNothingElse) {
  const std::string page = ask("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(page, HasSubstr("Content-Type: text/html\r\n"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'self'\r\n"));
  EXPECT_THAT(page, testing::EndsWith("\r\n\r\n<p>hello"));
  EXPECT_THAT(ask("HEAD /?x HTTP/1.1\r\nHost: localhost\r\n\r\n"), testing::EndsWith("Content-Length: 8\r\n\r\n"));
  EXPECT_THAT(ask("GET /../etc HTTP/1.1\r\nHost: localhost\r\n\r\n"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(ask("GET /echo HTTP/1.1\r\nHost: localhost\r\n\r\n"), StartsWith("HTTP/1.1 426"));
  EXPECT_THAT(ask("POST / HTTP/1.1\r\nHost: localhost\r\n\r\n"), StartsWith("HTTP/1.1 405"));
}

TEST_F(WebServerTest, AnswersRequestsThatItCannotRead) {
  EXPECT_THAT(ask("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1\r\n\r\nx"), StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(ask("GET / HTTP/1.1\r\nHost: localhost\r\nCookie: " + std::string(9000, 'x') + "\r\n\r\n"),
              StartsWith("HTTP/1.1 431"));
  EXPECT_THAT(ask("\x16\x03\x01\x02\x01\x03\x03\r\n\r\n"),
              testing::AllOf(StartsWith("HTTP/1.1 400"), HasSubstr("https")));
  EXPECT_EQ(std::count(log_.begin(), log_.end(), '\n'), 3) << log_;
}

TEST_F(WebServerTest, RefusesForeignOriginsAndUnknownHostNames) {
  const std::string evil = "Origin: http://evil.example\r\n";
  EXPECT_THAT(ask(WebClient::upgrade("/echo", "echo.1", evil)), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask(WebClient::upgrade("/echo", "echo.1", {}, "evil.example")), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(ask("GET / HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(ask("GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n"), StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(ask(WebClient::upgrade("/echo", "")), StartsWith("HTTP/1.1 400")) << "no subprotocol";
  EXPECT_THAT(ask(WebClient::upgrade("/", "echo.1")), StartsWith("HTTP/1.1 404"));
  EXPECT_TRUE(echo_.open.empty());
}

TEST_F(WebServerTest, CarriesTextAndBytesBothWays) {
  WebClient peer = observer();
  EXPECT_THAT(peer.head(), HasSubstr("Sec-WebSocket-Protocol: echo.1"));
  EXPECT_THAT(peer.head(), HasSubstr("s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")) << "the example of RFC 6455";
  peer.send("to and fro");
  const ReceivedMessage text = peer.receiveMessage().value_or(ReceivedMessage{});
  EXPECT_EQ(text.opcode, 1);
  EXPECT_EQ(text.bytes, "to and fro");
  peer.send(std::string("\0\xff", 2), 2);
  const ReceivedMessage bytes = peer.receiveMessage().value_or(ReceivedMessage{});
  EXPECT_EQ(bytes.opcode, 2);
  EXPECT_EQ(bytes.bytes, std::string("\0\xff", 2));
  peer.send("are you there", 9);
  EXPECT_EQ(peer.receiveMessage().value_or(ReceivedMessage{}).opcode, 10);
}

TEST_F(WebServerTest, DisconnectsAPeerThatSendsTooMuch) {
  WebClient wordy = observer(), hasty = observer(), third = observer();
  wordy.send(std::string(4097, 'x'));
  EXPECT_TRUE(wordy.atEnd());
  for (int i = 0; i < 60; ++i) hasty.send("x");
  EXPECT_TRUE(hasty.atEnd());
  EXPECT_THAT(log_, HasSubstr(messages::kTooManyMessages));
  third.send("out");
  EXPECT_EQ(third.receiveMessage().value_or(ReceivedMessage{}).opcode, 8);
  EXPECT_TRUE(third.atEnd());
  for (WebClient* peer : {&wordy, &hasty, &third}) peer->disconnect();
  for (int i = 0; i < 5000 && echo_.ended < 3; ++i) server_->poll(1ms);
  EXPECT_EQ(echo_.ended, 3) << log_;
}

TEST_F(WebServerTest, AcceptsEightChannelsAndOneMoreWhenOneDisconnects) {
  std::vector<WebClient> peers;
  peers.reserve(8);
  for (int i = 0; i < 8; ++i) peers.push_back(observer());
  EXPECT_THAT(ask(WebClient::upgrade("/echo", "echo.1")), StartsWith("HTTP/1.1 503"));
  peers[3].disconnect();
  for (int i = 0; i < 5000 && echo_.open.size() == 8; ++i) server_->poll(1ms);
  (void)observer();
}

TEST_F(WebServerTest, DropsMessagesOfTheSlowPeerOnlyAndNeverBlocks) {
  constexpr int kMessages = 300;
  WebClient slow = observer(4096);
  Channel* const slow_channel = *echo_.open.begin();
  WebClient quick = observer();
  const std::string filling(20'000, ' ');
  int received = 0;
  for (int i = 1; i <= kMessages; ++i) {
    const auto message = std::make_shared<const std::string>(std::to_string(i) + filling);
    for (Channel* channel : echo_.open) channel->send(0, message);
    received += quick.receiveMessage().value_or(ReceivedMessage{}).bytes == *message ? 1 : 0;
  }
  EXPECT_EQ(received, kMessages);
  EXPECT_GT(slow_channel->lost(), kMessages / 2u);
  std::uint64_t got = 0;
  int last = 0;
  while (last < kMessages) {
    const std::optional<ReceivedMessage> late = slow.receiveMessage();
    ASSERT_TRUE(late.has_value());
    const int number = std::stoi(late->bytes);
    EXPECT_GT(number, last) << "never an older one";
    last = number;
    ++got;
  }
  EXPECT_EQ(got + slow_channel->lost(), kMessages)
      << "the newest message arrives last, and received plus lost is complete";
}

TEST_F(WebServerTest, ReportsTheEndOfAChannelOnceWhenTheServerIsDestroyed) {
  const WebClient peer = observer();
  server_.reset();
  EXPECT_EQ(echo_.ended, 1);
}

TEST_F(WebServerTest, ServesNewClientsHoweverManyConnectionsAreHeldOpen) {
  WebClient before = observer();
  std::vector<WebClient> held;
  held.reserve(120);
  for (int i = 0; i < 120; ++i) {
    held.push_back(client());
    // Silent, slow, or not reading its response.
    held.back().raw(i % 3 == 0   ? ""
                    : i % 3 == 1 ? "GET / HTTP/1.1\r\nHo"
                                 : "GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n");
    for (int turn = 0; turn < 3; ++turn) server_->poll(1ms);
    if (i % 10 == 9) {
      EXPECT_THAT(ask("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"), StartsWith("HTTP/1.1 200")) << i;
    }
  }
  (void)observer();
  before.send("still here");
  EXPECT_EQ(before.receiveMessage().value_or(ReceivedMessage{}).bytes, "still here") << log_;
  EXPECT_THAT(log_, HasSubstr(messages::kClosedForNewer));
}

/// Counts messages without storing them.
struct Nowhere final : ChannelHandler {
  int taken = 0;
  void opened(Channel&) override {}
  void received(Channel&, std::string_view, bool) override { ++taken; }
  void closed(Channel&) noexcept override {}
};

/// How often this process' writable memory contains the text whose reverse is `reversed`.
int timesInMemory(const std::string& reversed) {
  static std::array<char, 1 << 20> piece;
  int times = 0;
  std::ifstream maps{"/proc/self/maps"};
  const int memory = open("/proc/self/mem", O_RDONLY);
  for (std::string line; std::getline(maps, line);) {
    unsigned long from = 0, to = 0;
    char rights[5] = {};
    if (std::sscanf(line.c_str(), "%lx-%lx %4s", &from, &to, rights) != 3 || rights[1] != 'w') continue;
    if (to - from > (1ul << 30)) continue;  // a sanitizer's own
    for (unsigned long at = from; at < to; at += piece.size() - reversed.size()) {
      const ssize_t size =
          pread(memory, piece.data(), std::min<unsigned long>(piece.size(), to - at), static_cast<off_t>(at));
      if (size <= 0) break;
      const char* end = piece.data() + size;
      for (const char* found = piece.data();; ++found) {  // memchr(): std::search takes half a minute under sanitizers
        found = static_cast<const char*>(std::memchr(found, reversed.back(), static_cast<std::size_t>(end - found)));
        if (found == nullptr || static_cast<std::size_t>(end - found) < reversed.size()) break;
        if (!std::equal(reversed.rbegin(), reversed.rend(), found)) continue;
        const unsigned long place = at + static_cast<unsigned long>(found - piece.data());
        const auto own = reinterpret_cast<unsigned long>(piece.data());
        if (place < own || place >= own + piece.size()) ++times;
      }
    }
  }
  close(memory);
  return times;
}

TEST_F(WebServerTest, LeavesNoCopyOfAReceivedMessageInMemory) {
  Nowhere nowhere;
  server_->channel("/nowhere", "nowhere.1", nowhere);
  const std::string reversed = "drowssap suoregnad 7391";
  const pid_t page = fork();  // so that no copy of the sender is in this memory
  if (page == 0) {
    WebClient peer{server_->port(), [] { usleep(1000); }};
    (void)peer.open("/nowhere", "nowhere.1");
    peer.send(std::string{reversed.rbegin(), reversed.rend()}, 2);
    (void)peer.atEnd();
    _exit(0);
  }
  for (int i = 0; i < 5000 && nowhere.taken == 0; ++i) server_->poll(1ms);
  for (int i = 0; i < 3; ++i) server_->poll(1ms);
  EXPECT_EQ(nowhere.taken, 1);
  EXPECT_EQ(timesInMemory(reversed), 0);
  std::string present{reversed.rbegin(), reversed.rend()};
  EXPECT_GT(timesInMemory(reversed), 0) << "the search finds what is there: " << present;
  kill(page, SIGKILL);
  waitpid(page, nullptr, 0);
  server_.reset();  // its handler is destroyed next
}

class HastyWebServerTest : public WebServerTest {
 protected:
  HastyWebServerTest() : WebServerTest{{.max_connections = 2, .handshake_timeout = 20ms, .idle_timeout = 40ms}} {}
};

TEST_F(HastyWebServerTest, ClosesConnectionsThatSendNoRequest) {
  WebClient silent = client(), slow = client();
  slow.raw("GET / HTTP/1.1\r\nHo");
  EXPECT_TRUE(silent.atEnd());
  EXPECT_TRUE(slow.atEnd());
}

TEST_F(HastyWebServerTest, DisconnectsAPeerThatAnswersNoPing) {
  const WebClient dead = observer();
  for (int i = 0; i < 5000 && echo_.ended == 0; ++i) server_->poll(2ms);
  EXPECT_EQ(echo_.ended, 1);
}

TEST_F(HastyWebServerTest, RefusesConnectionsBeyondTheLimit) {
  const WebClient first = observer(), second = observer();
  WebClient third = client();
  EXPECT_TRUE(third.atEnd());
  EXPECT_THAT(log_, HasSubstr("2" + std::string{messages::kConnectionsOpen}));
}

class ForeignWebServerTest : public WebServerTest {
 protected:
  ForeignWebServerTest() : WebServerTest{{.allowed = {{0x0A000000, 0xFF000000}}}} {}
};

TEST_F(ForeignWebServerTest, AcceptsOnlyTheAllowedNetworks) {
  EXPECT_EQ(ask("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"), "");
  EXPECT_THAT(log_, HasSubstr(messages::kNotInAllowedNetwork));
}

}  // namespace
}  // namespace darwinop::web
