// What the page sees: shared memory of a runtime here, or the monitor of a robot elsewhere.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "monitor/monitor.hpp"
#include "window/bridge.hpp"

namespace darwinop::window {

class Sight {
 public:
  explicit Sight(std::unique_ptr<monitor::Monitor> here) : here_{std::move(here)} {}
  explicit Sight(std::unique_ptr<Bridge> elsewhere) : elsewhere_{std::move(elsewhere)} {}

  web::ChannelUser& user() {
    if (here_) return *here_;
    return *elsewhere_;
  }
  void look() { here_ ? here_->look() : elsewhere_->look(); }
  [[nodiscard]] Nanos pause() const { return here_ ? here_->pause() : elsewhere_->pause(); }
  void notice(const std::string& text) {
    if (here_) here_->notice(text);
  }
  void tellEnd(const std::string& why) {
    if (elsewhere_) elsewhere_->tellEnd(why);
  }

 private:
  std::unique_ptr<monitor::Monitor> here_;
  std::unique_ptr<Bridge> elsewhere_;
};

}  // namespace darwinop::window
