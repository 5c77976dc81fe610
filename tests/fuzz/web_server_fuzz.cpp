// HTTP and WebSocket bytes: the server survives and reveals nothing without the secret path.
// First input byte: whether a WebSocket is open, and where the bytes are cut.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "hal/net/web/server.hpp"
#include "hal/net/web/web_client.hpp"

namespace {

using namespace darwinop::web;

constexpr const char *kSecret = "0123456789abcdef0123456789abcdef", *kTreasure = "the page of the robot window";

struct Echo final : ChannelUser {
  int open = 0;
  void opened(Channel& channel) override {
    ++open;
    channel.send(0, std::make_shared<const std::string>("hello"));
  }
  void said(Channel& channel, std::string_view message, bool binary) override {
    if (message.size() > 4096) std::abort();
    if (message == "out") return channel.close("out");
    if (message.find(kTreasure) != std::string_view::npos) return;  // said by itself, it is no secret
    const auto bytes = std::make_shared<const std::string>(message);
    binary ? channel.sendBinary(1, bytes) : channel.send(kEvery, bytes);
  }
  void closed(Channel& /*channel*/) noexcept override { --open; }
};

struct Served {
  Echo echo;
  Server server{{.entry = {.own_origin = true}, .most_messages = 1000}, [](const std::string&) {}};
  Served() {
    server.serve(std::string{"/"} + kSecret + "/", {.type = "text/plain", .body = kTreasure});
    server.serve("/", {.type = "text/plain", .body = "hello"});
    server.channel("/echo", "echo.1", echo);
  }
  void attend() { server.attend(darwinop::Nanos{0}); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Served served;
  if (size == 0) return 0;
  const std::string bytes{reinterpret_cast<const char*>(data) + 1, size - 1};
  const std::size_t cut = std::min<std::size_t>(data[0] >> 1, bytes.size());
  {
    WebClient client{served.server.port(), [] { served.attend(); }};
    if (!client.connected()) std::abort();
    served.attend();
    if ((data[0] & 1) != 0 && client.open("/echo", "echo.1").find(" 101 ") == std::string::npos) std::abort();
    client.raw(bytes.substr(0, cut));
    client.raw(bytes.substr(cut));
    for (int i = 0; i < 4; ++i) served.attend();
    if (client.unheard().find(kTreasure) != std::string::npos && bytes.find(kSecret) == std::string::npos) std::abort();
    client.breakOff();
  }
  for (int i = 0; i < 1000 && served.echo.open > 0; ++i) served.attend();
  if (served.echo.open != 0) std::abort();
  return 0;
}
