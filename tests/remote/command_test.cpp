// darwinop remote as a process, with a virtual robot in it.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <span>
#include <thread>

#include "hal/net/socket.hpp"
#include "remote/jpeg/decoder.hpp"
#include "remote/protocol/examples.hpp"
#include "remote/server/messages.hpp"
#include "support/hex.hpp"
#include "support/temporary_folder.hpp"
#include "system/program.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class RemoteCommand : public testing::Test {
 protected:
  [[nodiscard]] Program run(const std::vector<std::string>& options) const {
    std::vector<std::string> command{DARWINOP_REMOTE, "--robot", "virtual", "--port", "0"};
    command.insert(command.end(), options.begin(), options.end());
    return {command, folder_ / "output"};
  }
  static std::uint16_t portOf(const Program& server) {
    const std::string ready = "ready: 127.0.0.1:";
    EXPECT_TRUE(server.says(ready, 20s)) << server.output();
    const std::string said = server.output();
    return static_cast<std::uint16_t>(std::stoi(said.substr(said.find(ready) + ready.size())));
  }
  static net::Socket connectTo(std::uint16_t port) {
    net::Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) socket.close();
    return socket;
  }
  static std::string ask(const net::Socket& socket, const std::string& request) {
    const std::vector<std::uint8_t> bytes = fromHex(request);
    EXPECT_EQ(send(socket.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL), bytes.size());
    std::vector<std::uint8_t> reply(4096);
    const ssize_t count = recv(socket.descriptor(), reply.data(), reply.size(), 0);  // blocks until the reply arrives
    reply.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return toHex(reply);
  }

  TemporaryFolder folder_;
};

TEST_F(RemoteCommand, ServesARobotUntilItIsAskedToEnd) {
  Program server = run({});
  const std::uint16_t port = portOf(server);
  {
    const net::Socket client = connectTo(port);
    EXPECT_EQ(ask(client, kEmptyRequest), kEmptyReply);
    EXPECT_EQ(ask(client, kInertialRequest).substr(0, 14), "57 00 00 00 1d");
    EXPECT_FALSE(connectTo(port).open()) << "one drives";
  }
  EXPECT_TRUE(server.says(messages::kDisconnected, 20s));
  const net::Socket next = connectTo(port);
  EXPECT_EQ(ask(next, kEmptyRequest), kEmptyReply);
  server.kill(SIGINT);
  EXPECT_EQ(server.wait(20s), 0) << server.output();
}

TEST_F(RemoteCommand, SendsABlackPictureOfItsSizeIfTheRobotHasNoCamera) {
  Program server = run({"2", "4"});
  const net::Socket client = connectTo(portOf(server));
  const std::vector<std::uint8_t> reply = fromHex(ask(client, kCameraRequest));
  constexpr std::size_t kHeader = 9, kNul = 1;
  ASSERT_GT(reply.size(), kHeader + kNul) << server.output();
  const std::span<const std::uint8_t> jpeg{reply.data() + kHeader, reply.size() - kHeader - kNul};
  constexpr ImageSize kSize{160, 60};
  EXPECT_EQ(imageSizeOf(jpeg), kSize);
  std::vector<std::uint8_t> bgra(std::size_t{4} * kSize.width * kSize.height);
  EXPECT_EQ(decodeJpeg(jpeg, kSize, bgra), nullptr);
  for (std::size_t byte = 0; byte < bgra.size(); ++byte) ASSERT_EQ(bgra[byte], byte % 4 == 3 ? 255 : 0) << byte;
  server.kill(SIGTERM);
  EXPECT_EQ(server.wait(20s), 0);
}

TEST_F(RemoteCommand, KeepsRunningWhenItsOutputIsNotRead) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  Program server{
      {"/bin/sh", "-c", std::string{"exec " DARWINOP_REMOTE " --robot virtual --port 0 >'"} + pipe + "' 2>&1"},
      folder_ / "output"};
  std::uint16_t port = 0;
  {
    std::ifstream said{pipe};
    for (std::string line; port == 0 && std::getline(said, line);)
      if (line.starts_with("ready: ")) port = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  }
  for (int client = 0; client < 3; ++client) {
    net::Socket socket;
    for (int i = 0; i < 500 && !socket.open(); ++i) {  // until the previous client is disconnected
      socket = connectTo(port);
      if (!socket.open()) std::this_thread::sleep_for(10ms);
    }
    ASSERT_TRUE(socket.open()) << "client " << client;
    EXPECT_EQ(ask(socket, kEmptyRequest), kEmptyReply);
  }
  server.kill(SIGTERM);
  EXPECT_EQ(server.wait(20s), 0);
}

TEST_F(RemoteCommand, RequiresAllowBeforeItListensOnANetwork) {
  Program server = run({"--listen", "0.0.0.0"});
  EXPECT_EQ(server.wait(20s), 2);
  EXPECT_THAT(server.output(), HasSubstr("--allow 192.168.123.0/24"));
}

TEST_F(RemoteCommand, WarnsThatTheProtocolHasNoPassword) {
  Program server = run({"--listen", "0.0.0.0", "--allow", "10.1.2.0/24", "4", "2"});
  EXPECT_TRUE(server.says("ready: 0.0.0.0:", 20s)) << server.output();
  EXPECT_THAT(server.output(), HasSubstr(messages::kNoPassword));
  server.kill(SIGTERM);
  EXPECT_EQ(server.wait(20s), 0);
}

}  // namespace
}  // namespace darwinop::remote
