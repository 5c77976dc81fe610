// Connection handling of TcpLink: connect, detect a loss, reconnect, end the session.
#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "core/text/number_text.hpp"
#include "remote/client/messages.hpp"
#include "remote/client/tcp_link.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kAttempt{1'000'000'000};      // per attempt to connect
constexpr Nanos kBetween{250'000'000};        // between attempts
constexpr Nanos kEndTimeout{1'000'000'000};   // for the reply to the end of the session
constexpr Nanos kLogInterval{5'000'000'000};  // minimum between two messages about a lost connection

}  // namespace

std::string TcpLink::name() const {
  return "tcp://" + options_.host + ":" + std::to_string(options_.port);
}

void TcpLink::log(const std::string& message) const {
  if (options_.log) options_.log(message);
}

void TcpLink::connect() {
  const Nanos give_up = clock_.now() + options_.connect_timeout;
  bool logged = false;
  for (;;) {
    connection_.connect(addresses_[next_address_++ % addresses_.size()], options_.port);
    const Nanos attempt_ends = std::min(give_up, clock_.now() + kAttempt);
    while (connection_.state() == Connection::State::kConnecting && clock_.now() < attempt_ends)
      if (!connection_.wait(attempt_ends - clock_.now())) throw std::runtime_error("interrupted while connecting");
    if (connection_.state() == Connection::State::kOpen) return;
    const std::string why = connection_.why().empty() ? "no answer" : connection_.why();
    if (clock_.now() >= give_up)
      throw std::runtime_error("no connection to " + name() + " in " + text::inSeconds(options_.connect_timeout) +
                               ": " + why + messages::kNoServer);
    if (!std::exchange(logged, true)) log("waiting for " + name() + ": " + why);
    connection_.close(why);
    if (!connection_.wait(std::min(kBetween, give_up - clock_.now())))
      throw std::runtime_error("interrupted while connecting");
  }
}

void TcpLink::awaitFirstReply() {
  send(0);
  const Nanos give_up = clock_.now() + options_.connect_timeout;
  while (!isConnected(state_)) {
    if (!connection_.wait(std::max(Nanos{0}, give_up - clock_.now())))
      throw std::runtime_error("interrupted before the robot was ready");
    if (const auto reply = connection_.reply()) take(*reply);
    stepped_to_ = shown_.cycle;
    if (!why_ended_.empty()) throw std::runtime_error(why_ended_);
    if (connection_.state() == Connection::State::kClosed)
      throw std::runtime_error(name() + " has refused this client: " + connection_.why() +
                               ". See its log: this computer may not be in a network given with --allow, or another "
                               "client drives");
    if (clock_.now() >= give_up)
      throw std::runtime_error(name() + " has accepted the connection but has not replied for " +
                               text::inSeconds(options_.connect_timeout) +
                               ": check that it is darwinop remote, and that no other client is waiting");
  }
  if (!server_.extended)
    log(name() + " runs the 2013 protocol: buttons, battery, temperatures and faults are not available (NaN)");
}

void TcpLink::receive(Nanos longest) {
  (void)connection_.wait(longest);
  if (const auto reply = connection_.reply()) take(*reply);
  const Nanos patience = isConnected(state_) ? options_.reply_timeout : options_.connect_timeout;
  if (connection_.awaitsReply() && clock_.now() - last_request_.sent_at > patience)
    connection_.close(messages::kNoReplyFor + text::inSeconds(patience));
  detectLoss();
}

void TcpLink::detectLoss() {
  if (connection_.state() == Connection::State::kOpen || state_ == TcpState::kLost || !why_ended_.empty()) return;
  state_ = next(state_, TcpEvent::kConnectionLost);
  const Nanos now = clock_.now();
  loss_.since = now;
  loss_.attempted_at = now - kBetween;                                    // the first attempt is made at once
  if (loss_.logged_at && now - *loss_.logged_at <= kLogInterval) return;  // limits the log for a loose cable
  loss_.logged_at = now;
  log("the connection to " + name() + messages::kConnectionLost + connection_.why() + "); reconnecting for " +
      text::inSeconds(options_.reconnect_timeout) + "; sensor values are NaN until then");
}

/// Starts an attempt, or ends one that takes too long.
void TcpLink::reconnect() {
  const Nanos now = clock_.now();
  detectLoss();
  if (now - loss_.since.value_or(now) > options_.reconnect_timeout) {
    why_ended_ = "the connection to " + name() + " was lost " + text::inSeconds(options_.reconnect_timeout) +
                 messages::kNotRestored + connection_.why();
    return;
  }
  if (connection_.state() == Connection::State::kConnecting) {
    if (now - loss_.attempted_at > kAttempt) connection_.close("no answer");
    return;
  }
  if (now - loss_.attempted_at < kBetween) return;
  loss_.attempted_at = now;
  server_.extended = true;
  command_delta_.forget();
  pictures_.forgetHeld();
  connection_.connect(addresses_[next_address_++ % addresses_.size()], options_.port);
}

void TcpLink::leaveHolding() {
  constexpr std::atomic<bool> kNeverStops{false};
  // One cycle, whether or not a reply arrives. A request to end is reported once and must not hide the last commands.
  const std::uint64_t next_cycle = shown_.cycle + 1;
  if (!waitForCycle(next_cycle, kNeverStops)) (void)waitForCycle(next_cycle, kNeverStops);
  state_ = next(state_, TcpEvent::kLeaveHolding);
}

/// The 2013 protocol has no end of session: there the robot stops when the connection closes.
TcpLink::~TcpLink() {
  if (state_ == TcpState::kLeft || !isConnected(state_) || !commands_ || !server_.extended) return;
  const Nanos give_up = clock_.now() + kEndTimeout;
  const auto drain = [&] {
    while (connection_.awaitsReply() && clock_.now() < give_up) {
      (void)connection_.wait(give_up - clock_.now());
      (void)connection_.reply();
    }
  };
  drain();
  if (connection_.state() != Connection::State::kOpen || connection_.awaitsReply()) return;
  Request last;
  last.extended = last.extension.end_of_session = true;
  last.extension.only_if_up = true;  // sent long after the last step, it must not start a robot at rest
  connection_.send(last);
  drain();
}

}  // namespace darwinop::remote
