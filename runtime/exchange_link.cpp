// Controller's side of an exchange.
#include "runtime/exchange_link.hpp"

#include <utility>

#include "runtime/names.hpp"
#include "safety/session_settings.hpp"

namespace darwinop::runtime {
namespace {

/// Numbers of sessions wrap.
std::uint32_t later(std::uint32_t one, std::uint32_t other) {
  return static_cast<std::int32_t>(one - other) > 0 ? one : other;
}

}  // namespace

ExchangeLink::ExchangeLink(Exchange exchange) : exchange_{std::move(exchange)}, unattended_{startedUnattended()} {}

void ExchangeLink::publish(Commands commands) {
  commands.session = session_;
  commands.sequence = ++sequence_;
  commands.unattended = commands.unattended || unattended_;
  commands.settings = settings_;
  commands.made_ns = now().count();
  last_ = commands;
  exchange_.commands().commands.publish(commands);
}

Sensors ExchangeLink::sensors() const {
  (void)block().sensors.read(sensors_);
  return sensors_;
}

void ExchangeLink::beginSession() {
  info_ = block().info;
  std::atomic<std::uint32_t>& taken = exchange_.commands().session_taken;
  session_ = later(later(block().session.load(), taken.load()), session_) + 1;
  if (session_ == 0) session_ = 1;  // 0 means no driver
  taken.store(session_);
}

safety::Config ExchangeLink::robotSafety() const {
  return safety::fromSession(info_.safety, info_.safety_named);
}

void ExchangeLink::setSafety(const safety::Config& config) {
  settings_ = safety::toSession(config);
}

bool ExchangeLink::publishEndOfSession() {
  if (sequence_ == 0) return false;
  Commands last = last_;
  last.end_of_session = true;
  publish(last);
  return true;
}

bool ExchangeLink::finished(std::uint64_t cycle) const {
  // The word holds the low 32 bits of the cycle number.
  return static_cast<std::int32_t>(block().finished.value() - static_cast<std::uint32_t>(cycle)) >= 0;
}

bool ExchangeLink::releasedByOperator() const {
  return session_ != 0 && block().refused.load() == session_;
}

void ExchangeLink::sleepUntilAfter(std::uint32_t finished, Nanos at_most) const {
  block().finished.waitWhile(finished, at_most, exchange_.commands().wait);
}

bool ExchangeLink::end(const std::string& why) {
  why_ended_ = why;
  return false;
}

}  // namespace darwinop::runtime
