// How a TcpLink finds its server, loses it, finds it again and takes its leave.
#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "remote/client/tcp_link.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kAttempt{1'000'000'000};  // to connect
constexpr Nanos kBetween{250'000'000};    // attempts
constexpr Nanos kGoodBye{1'000'000'000};  // for the reply to a farewell
constexpr Nanos kQuiet{5'000'000'000};    // at least, between two sentences of losses

std::string inSeconds(Nanos time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

}  // namespace

void TcpLink::connectFirst() {
  const Nanos give_up = clock_.now() + options_.first_patience;
  bool told = false;
  for (;;) {
    connection_.connect(addresses_[next_address_++ % addresses_.size()], options_.port);
    const Nanos attempt_ends = std::min(give_up, clock_.now() + kAttempt);
    while (connection_.state() == Connection::State::kConnecting && clock_.now() < attempt_ends)
      if (!connection_.wait(attempt_ends - clock_.now())) throw std::runtime_error("asked to end while connecting");
    if (connection_.state() == Connection::State::kOpen) return;
    const std::string why = connection_.why().empty() ? "no answer" : connection_.why();
    if (clock_.now() >= give_up)
      throw std::runtime_error("no connection to " + name() + " in " + inSeconds(options_.first_patience) + ": " + why +
                               ". Is `darwinop remote` running there, and open to this computer (--listen, --allow)? "
                               "It refuses everybody, too, while somebody else drives");
    if (!std::exchange(told, true)) say("waiting for " + name() + ": " + why);
    connection_.close(why);
    if (!connection_.wait(std::min(kBetween, give_up - clock_.now())))
      throw std::runtime_error("asked to end while connecting");
  }
}

void TcpLink::firstReply() {
  send(0);
  const Nanos give_up = clock_.now() + options_.first_patience;
  while (!greeted_) {
    if (!connection_.wait(std::max(Nanos{0}, give_up - clock_.now())))
      throw std::runtime_error("asked to end before the robot was ready");
    if (const auto reply = connection_.reply()) take(*reply);
    stepped_to_ = shown_.cycle;
    if (!why_ended_.empty()) throw std::runtime_error(why_ended_);
    if (connection_.state() == Connection::State::kClosed)
      throw std::runtime_error(name() + " lets nobody in now: " + connection_.why() +
                               ". Its log says why; this computer may be in no network given with --allow, or "
                               "somebody else may drive");
    if (clock_.now() >= give_up)
      throw std::runtime_error(name() + " has accepted the connection but has not answered for " +
                               inSeconds(options_.first_patience) +
                               ": it is no server of remote control, or another client is before this one");
  }
  if (!extended_)
    say(name() + " is a server that tells no buttons, battery, temperatures or faults: they are not a number here");
}

void TcpLink::listen(Nanos longest) {
  (void)connection_.wait(longest);
  if (const auto reply = connection_.reply()) take(*reply);
  const Nanos patience = greeted_ ? options_.silence : options_.first_patience;
  if (connection_.awaitsReply() && clock_.now() - sent_ > patience)
    connection_.close("no reply for " + inSeconds(patience));
  noticeLoss();
}

void TcpLink::noticeLoss() {
  if (connection_.state() == Connection::State::kOpen || lost_ || !why_ended_.empty()) return;
  lost_ = came_back_ = true;
  lost_since_ = clock_.now();
  attempted_ = lost_since_ - kBetween;                     // the first attempt is made at once
  tells_ = !told_at_ || lost_since_ - *told_at_ > kQuiet;  // a loose cable is told of now and then
  if (!tells_) return;
  told_at_ = lost_since_;
  say("the connection to " + name() + " is lost (" + connection_.why() + "); it is tried again for " +
      inSeconds(options_.patience) + ", and sensors are not a number meanwhile");
}

/// Begins an attempt, or ends one that takes too long.
void TcpLink::reconnect() {
  const Nanos now = clock_.now();
  noticeLoss();
  if (now - lost_since_ > options_.patience) {
    end("the connection to " + name() + " was lost " + inSeconds(options_.patience) +
        " ago and has not come back: " + connection_.why());
    return;
  }
  if (connection_.state() == Connection::State::kConnecting) {
    if (now - attempted_ > kAttempt) connection_.close("no answer");
    return;
  }
  if (now - attempted_ < kBetween) return;
  attempted_ = now;
  greeted_ = false;
  extended_ = true;
  wishes_.forget();
  pictures_.forgetHeld();
  connection_.connect(addresses_[next_address_++ % addresses_.size()], options_.port);
}

void TcpLink::leaveHolding() {
  constexpr std::atomic<bool> kNeverStops{false};
  (void)waitForCycle(shown_.cycle + 1, kNeverStops);  // a cycle's time, whatever the network does
  says_farewell_ = false;
}

/// A server of 2013 knows no farewell: there the robot stops when the connection ends.
TcpLink::~TcpLink() {
  if (!says_farewell_ || !drove_ || !extended_ || !greeted_) return;
  const Nanos give_up = clock_.now() + kGoodBye;
  const auto settle = [&] {
    while (connection_.awaitsReply() && clock_.now() < give_up) {
      (void)connection_.wait(give_up - clock_.now());
      (void)connection_.reply();
    }
  };
  settle();
  if (connection_.state() != Connection::State::kOpen || connection_.awaitsReply()) return;
  Request farewell;
  farewell.extended = farewell.extension.farewell = true;
  farewell.extension.only_if_up = true;  // said long after the last step, it wakes no robot that sits
  connection_.send(farewell);
  settle();
}

}  // namespace darwinop::remote
