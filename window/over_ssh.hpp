// A robot that the window logs in to: its monitor and its server for as long as the window is open.
#pragma once

#include <string>
#include <vector>

#include "hal/net/ssh/session.hpp"
#include "hal/net/web/server.hpp"
#include "window/sight.hpp"

namespace darwinop::window {

class OverSsh {
 public:
  /// Begins to log in. `target`: USER@HOST. `words`: how, as options of darwinop-install.
  OverSsh(std::string target, std::vector<std::string> words);

  /// Waits until robot() and monitor() lead there. False: they do not, and it has been said why.
  [[nodiscard]] bool arrives();
  [[nodiscard]] const std::string& target() const { return target_; }
  /// "tcp://127.0.0.1:PORT" and "127.0.0.1:PORT"
  [[nodiscard]] std::string robot() const;
  [[nodiscard]] std::string monitor() const;

  /// By itself; it has been said why.
  [[nodiscard]] bool ended() const { return session_.ended(); }
  /// A signal came while nobody else caught them.
  [[nodiscard]] static bool toldToEnd() { return ssh::SshSession::toldToEnd(); }
  /// The last that pages get to know.
  void tellPages(web::Server& server, Sight& sight) const;
  /// The robot's half is ended; returns when it has. Exit status.
  int end() { return session_.end(); }

 private:
  std::string target_;
  std::vector<std::uint16_t> ports_;
  ssh::SshSession session_;
};

}  // namespace darwinop::window
