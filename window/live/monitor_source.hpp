// Cycles of a robot on another computer, from its monitor.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hal/net/addresses.hpp"
#include "hal/net/web/websocket_client.hpp"
#include "window/live/cycle_source.hpp"

namespace darwinop::window {

/// Of a "state" message of the monitor; nothing of another one. What the message does not have stays unknown.
/// `period_s`: of "hello".
std::optional<Sensors> sensorsOfState(std::string_view message, double period_s);

/// s, of the robot's loop; empty: another message, or a period that no loop has.
std::optional<double> periodOfHello(std::string_view message);

class MonitorSource final : public CycleSource {
 public:
  /// `name`: of the monitor, for messages: "192.168.123.1:5024".
  MonitorSource(net::Ipv4 address, std::uint16_t port, std::string name);

  void poll(Nanos now, const Take& take) override;
  [[nodiscard]] const std::string& reason() const override { return reason_; }

 private:
  void received(std::string_view message);

  std::string name_, reason_;
  double period_s_ = 0;  // 0: "hello" has not come yet
  const Take* take_ = nullptr;
  web::WebSocketClient client_;
};

}  // namespace darwinop::window
