// Log of the supervisor: lines with a time stamp on standard error.
#pragma once

#include <string>

namespace darwinop::supervisor {

/// "2026-01-31 09:00:00 darwinop supervisor: TEXT". Write errors are ignored: a full disk must not stop the supervisor.
void log(const std::string& text);

/// For repeated checks: logs a text once, until another text or forget().
class Once {
 public:
  void log(const std::string& text) {
    if (text == said_) return;
    said_ = text;
    supervisor::log(text);
  }
  void forget() { said_.clear(); }

 private:
  std::string said_;
};

}  // namespace darwinop::supervisor
