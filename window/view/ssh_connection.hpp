// ssh connection to a robot: runs its monitor and remote-control server while the window is open.
#pragma once

#include <string>
#include <vector>

#include "hal/net/ssh/session.hpp"
#include "hal/net/web/server.hpp"
#include "window/view/monitor_feed.hpp"

namespace darwinop::window {

class SshConnection {
 public:
  /// Starts the login. `target`: USER@HOST. `words`: options of darwinop-install.
  SshConnection(std::string target, std::vector<std::string> words);

  /// Waits until robot() and monitor() are reachable. False: failed; the reason has been printed.
  [[nodiscard]] bool waitUntilReady();
  [[nodiscard]] const std::string& target() const { return target_; }
  /// "tcp://127.0.0.1:PORT" and "127.0.0.1:PORT"
  [[nodiscard]] std::string robot() const;
  [[nodiscard]] std::string monitor() const;

  /// The connection has ended; the reason has been printed.
  [[nodiscard]] bool ended() { return session_.ended(); }
  /// A signal requested the end during login or shutdown.
  [[nodiscard]] static bool isEndRequested() { return ssh::SshSession::isEndRequested(); }
  /// Sends the final message to all pages.
  void notifyPages(web::WebServer& server, MonitorFeed& feed) const;
  /// Ends the programs on the robot and waits for that. Returns the exit status.
  int end() { return session_.end(); }

 private:
  std::string target_;
  std::vector<std::uint16_t> ports_;
  ssh::SshSession session_;
};

}  // namespace darwinop::window
