// What the supervisor has to say: one line each to standard error, with the time of day.
#pragma once

#include <string>

namespace darwinop::supervisor {

/// "2026-01-31 09:00:00 darwinop supervisor: TEXT". A disk that is full is no reason to stop.
void say(const std::string& text);

/// For what is looked at again and again: says the same text once, until another one came or forget() was called.
class Once {
 public:
  void say(const std::string& text) {
    if (text == said_) return;
    said_ = text;
    supervisor::say(text);
  }
  void forget() { said_.clear(); }

 private:
  std::string said_;
};

}  // namespace darwinop::supervisor
