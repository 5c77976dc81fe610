// The other end of a channel: a WebSocket that we open, and open again whenever it breaks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "hal/byte_line.hpp"
#include "hal/net/addresses.hpp"

namespace darwinop::web {

struct CallerConfig {
  net::Ipv4 address = 0x7F000001;  // loopback
  std::uint16_t port = 0;
  std::string path = "/monitor";
  std::string subprotocol;
  std::size_t longest_message = std::size_t{256} * 1024;
  Nanos greeting{std::chrono::seconds{3}};  // to connect, and again until the channel is open
  Nanos patience{std::chrono::seconds{4}};  // without a word, not even an answer to a ping
  Nanos again{std::chrono::seconds{1}};     // between two attempts
};

/// One thread: whoever calls look(). Nothing here waits, and nothing is kept of what was heard.
class Caller {
 public:
  /// Called from inside of look(), which must not be the end of the caller.
  struct Ears {
    std::function<void(std::string_view message, bool binary)> heard;
    std::function<void(const std::string& why)> broken;  // a few words: "Connection refused"
  };

  Caller(CallerConfig config, Ears ears);
  ~Caller();
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  /// Said now, and first of all after each new beginning. Of two that wait the newer counts.
  void say(std::string text);
  /// Sees to what has happened; to be called again soon.
  void look();
  [[nodiscard]] bool open() const;

 private:
  class Call;
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace darwinop::web
