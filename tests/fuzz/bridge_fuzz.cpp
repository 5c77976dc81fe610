// Arbitrary monitor messages through the window: the page receives valid messages only.
// First input byte: whether the channel is open, and where the bytes are cut.
#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "window/view/bridge.hpp"

namespace {

using namespace darwinop;
using tcp = boost::asio::ip::tcp;
namespace websocket = boost::beast::websocket;

struct FakePage final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane lane, web::Bytes text) override {
    const auto message = nlohmann::json::parse(*text, nullptr, false);
    if (!message.is_object() || !message.contains("type") || !message["type"].is_string()) std::abort();
    if (lane != web::kEvery && lane >= web::kLanes) std::abort();
    if (message["type"] == "gone" && text->find("robot:5024") != std::string::npos)
      gone = true;
    else
      bytes += text->size();
  }
  void sendBinary(web::Lane /*lane*/, web::Bytes picture) override { bytes += picture->size(); }
  void discardQueued() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string& /*why*/) override {}

  std::string who = "page";
  std::size_t bytes = 0;
  bool gone = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static boost::asio::io_context context;
  static tcp::acceptor door{context, {boost::asio::ip::address_v4::loopback(), 0}};
  if (size == 0) return 0;
  const std::string bytes{reinterpret_cast<const char*>(data) + 1, size - 1};
  const bool greets = (data[0] & 1) != 0;
  const std::size_t cut = std::min<std::size_t>(data[0] >> 1, bytes.size());

  FakePage page;
  window::Bridge bridge{0x7F000001, door.local_endpoint().port(), "robot:5024"};
  const auto turn = [&] {
    bridge.update();
    context.restart();
    context.poll();
  };
  // The kernel may take its time on a busy computer; nothing here waits for a timer.
  const auto turn_until = [&](const bool& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{10};
    while (!done && std::chrono::steady_clock::now() < end) turn();
    return done;
  };
  bridge.opened(page);
  bridge.update();
  websocket::stream<tcp::socket> robot{door.accept()};
  if (greets) {
    robot.set_option(websocket::stream_base::decorator(
        [](websocket::response_type& answer) { answer.set("Sec-WebSocket-Protocol", "darwinop-monitor.1"); }));
    bool done = false;
    robot.async_accept([&](boost::beast::error_code error) {
      if (error) std::abort();
      done = true;
    });
    if (!turn_until(done)) std::abort();
  }
  tcp::socket& line = robot.next_layer();
  line.set_option(boost::asio::socket_base::linger{true, 0});  // nothing is left of it for later ones
  boost::system::error_code error;
  for (const std::string& part : {bytes.substr(0, cut), bytes.substr(cut)}) {
    boost::asio::write(line, boost::asio::buffer(part), error);
    for (int i = 0; i < 3; ++i) turn();
  }
  line.shutdown(tcp::socket::shutdown_send, error);
  if (!turn_until(page.gone) || page.bytes > bytes.size()) std::abort();
  line.close(error);
  bridge.closed(page);
  return 0;
}
