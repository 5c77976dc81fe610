// A TcpLink with short timeouts, and its log.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "remote/client/tcp_link.hpp"

namespace darwinop::remote {

inline const std::atomic<bool> kGoOn{false};

class TcpLinkTest : public testing::Test {
 protected:
  [[nodiscard]] std::unique_ptr<TcpLink> link(std::uint16_t port) {
    TcpOptions options;
    options.port = port;
    options.connect_timeout = std::chrono::milliseconds{500};
    options.reconnect_timeout = patience;
    options.reply_timeout = reply_timeout;
    options.log = [this](const std::string& what) { said += what + "\n"; };
    return std::make_unique<TcpLink>(std::move(options));
  }
  static bool stepOf(TcpLink& link, std::uint64_t cycles = 1) {
    link.publish(wanted());
    return link.waitForCycle(link.sensors().cycle + cycles, kGoOn);
  }
  static Commands wanted() {
    Commands commands;
    commands.joint[18].setGoal(Rad{0.5});
    commands.led.setEye(31);
    return commands;
  }
  std::string said;
  Nanos patience = std::chrono::seconds{20}, reply_timeout = std::chrono::milliseconds{300};
};

}  // namespace darwinop::remote
