// An X server for a test, without a screen.
#pragma once

#include <unistd.h>

#include <optional>
#include <string>

#include "hal/process/child_process.hpp"

namespace darwinop {

class XServer {
 public:
  XServer() {
    if (process::findProgram("Xvfb").empty()) return;
    using process::Stream;
    server_.emplace(
        process::Start{.command = {"Xvfb", "-displayfd", "3", "-screen", "0", "800x600x24", "-nolisten", "tcp"},
                       .streams = {{}, {}, {}, Stream::pipe()}});
    // It writes the number first and the end of the line later.
    std::string number;
    for (char next = 0; read(server_->stream(3), &next, 1) == 1 && next != '\n';) number += next;
    if (!number.empty()) name_ = ":" + number;
  }
  ~XServer() { end(); }
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// For DISPLAY; empty: it did not start.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// As behind a network that hangs: connected, and silent.
  void hang() { server_->signal(SIGSTOP); }
  void end() {
    if (!server_) return;
    server_->signal(SIGTERM);
    server_->signal(SIGCONT);
    (void)server_->wait();
    server_.reset();
  }

 private:
  std::optional<process::ChildProcess> server_;
  std::string name_;
};

}  // namespace darwinop
