// The controller's side of an exchange.
#include "runtime/exchange_link.hpp"

namespace darwinop::runtime {

void ExchangeLink::publish(Commands commands) {
  commands.session = session_;
  commands.sequence = ++sequence_;
  commands.made_ns = now().count();
  last_ = commands;
  block().commands.publish(commands);
}

Sensors ExchangeLink::sensors() const {
  (void)block().sensors.read(sensors_);
  return sensors_;
}

void ExchangeLink::beginSession() {
  session_ = block().session.fetch_add(1) + 1;
}

bool ExchangeLink::sayFarewell() {
  if (sequence_ == 0) return false;
  Commands farewell = last_;
  farewell.farewell = true;
  publish(farewell);
  return true;
}

bool ExchangeLink::finished(std::uint64_t cycle) const {
  // The word holds the low half of the cycle number; both move on together.
  return static_cast<std::int32_t>(block().finished.value() - static_cast<std::uint32_t>(cycle)) >= 0;
}

bool ExchangeLink::releasedByOperator() const {
  const std::uint32_t released = block().released.load();
  return released != 0 && static_cast<std::int32_t>(released - session_) > 0;
}

bool ExchangeLink::end(const std::string& why) {
  why_ended_ = why;
  return false;
}

}  // namespace darwinop::runtime
