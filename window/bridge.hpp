// The monitor channel of a robot elsewhere, handed on to the page: the browser talks with the window's program alone.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/addresses.hpp"
#include "hal/net/web/caller.hpp"
#include "hal/net/web/channel.hpp"
#include "monitor/wishes.hpp"

namespace darwinop::window {

/// One connection for each page, so that each gets what it asks for; a page that is too slow loses messages as it does
/// beside a monitor of its own. One thread: the web server's.
class Bridge final : public web::ChannelUser {
 public:
  /// `name`: of the monitor, for sentences: "192.168.123.1:5024".
  Bridge(net::Ipv4 address, std::uint16_t port, std::string name)
      : address_{address}, port_{port}, name_{std::move(name)} {}

  void opened(web::Channel& channel) override;
  void said(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override { lines_.erase(&channel); }

  /// The last that pages are told: why this program ends.
  void tellEnd(const std::string& why);

  /// To be called again after pause(), or earlier.
  void look();
  [[nodiscard]] Nanos pause() const;

 private:
  struct Line {
    std::unique_ptr<web::Caller> caller;
    monitor::Wishes wishes{};
    std::string gone;  // what was said of a connection that is not there
  };

  void heard(web::Channel& channel, std::string_view message, bool binary);
  void broken(web::Channel& channel, const std::string& why);

  net::Ipv4 address_;
  std::uint16_t port_;
  std::string name_;
  std::map<web::Channel*, Line> lines_;
};

}  // namespace darwinop::window
