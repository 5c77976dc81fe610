// A robot behind `darwinop remote`: each step is an exchange with its server.
#include "remote/client/tcp_link.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "remote/client/old_sensors.hpp"
#include "remote/client/resolve.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kLookAround{50'000'000};  // for a flag that another thread sets
constexpr Nanos kAttempt{1'000'000'000};  // to connect
constexpr Nanos kBetween{250'000'000};    // attempts
constexpr Nanos kLateReply{100'000'000};  // after the end of a step: the controller goes on with values grown old
constexpr Nanos kGoodBye{1'000'000'000};  // for the reply to a farewell
constexpr Nanos kQuiet{5'000'000'000};    // at least, between two sentences of losses
constexpr Nanos kLongestPeriod{1'000'000'000};

std::string inSeconds(Nanos time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

void age(Freshness& freshness, std::uint64_t cycles) {
  if (freshness.ever())
    freshness.age = static_cast<std::uint32_t>(std::min<std::uint64_t>(freshness.age + cycles, Freshness::kNever - 1));
}

}  // namespace

TcpLink::TcpLink(TcpOptions options)
    : options_{std::move(options)}, pictures_{[this](const std::string& what) { say(what); }}, faults_{std::cerr} {
  addresses_ = addressesOf(options_.host);
  connectFirst();
  firstReply();
}

std::string TcpLink::name() const {
  return "tcp://" + options_.host + ":" + std::to_string(options_.port);
}

void TcpLink::say(const std::string& sentence) const {
  if (options_.say) options_.say(sentence);
}

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

void TcpLink::publish(Commands commands) {
  wanted_ = commands;
  drove_ = true;
}

void TcpLink::send(std::uint64_t cycle) {
  Request request;
  if (drove_) wishes_.add(wanted_, request);
  request.camera = picture_asked_ = pictures_.areDue();
  request.extended = extended_;
  if (extended_)
    request.extension = {.until_cycle = greeted_ ? cycle - cycle_ahead_ : 0,
                         .fault_resets = wanted_.fault_resets,
                         .picture = pictures_.held(),
                         .start_where_it_is = wanted_.start_where_it_is || came_back_};
  if (!extended_ || !greeted_) askForAll(request);
  sent_ = clock_.now();
  exchanged_for_ = cycle;
  connection_.send(request);
}

bool TcpLink::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  if (cycle > stepped_to_) {
    step_ = static_cast<Nanos::rep>(cycle - stepped_to_) * period_;
    stepped_to_ = cycle;
  }
  while (mayGoOn(stop)) {
    if (shown_.cycle >= cycle) return true;
    if (connection_.state() != Connection::State::kOpen)
      reconnect();
    else if (isToAsk(cycle))
      send(cycle);
    const Nanos until = isThere(cycle) ? image_at_ : expected(cycle) + patienceWithReply();
    const Nanos left = until - clock_.now();
    if (isThere(cycle) && left <= Nanos{0})
      shown_ = image_;
    else if (real_time_ && left <= Nanos{0})
      growOld();
    else
      listen(real_time_ ? std::min(left, kLookAround) : kLookAround);
  }
  return false;
}

/// A server that tells its cycles is asked until it has come to this one; another one once a step.
bool TcpLink::isToAsk(std::uint64_t cycle) const {
  if (connection_.awaitsReply() || isThere(cycle)) return false;
  return extended_ || !greeted_ || exchanged_for_ < cycle;
}

/// By the clock here.
Nanos TcpLink::expected(std::uint64_t cycle) const {
  return image_at_ + static_cast<Nanos::rep>(cycle - image_.cycle) * period_;
}

/// What is a little late is waited for. Not again when it has not come: the steps then go on in time, without values.
Nanos TcpLink::patienceWithReply() const {
  return lost_ || overdue_ ? Nanos{0} : kLateReply;
}

void TcpLink::listen(Nanos longest) {
  (void)connection_.wait(longest);
  if (const auto reply = connection_.reply()) take(*reply);
  const Nanos patience = greeted_ ? options_.silence : options_.first_patience;
  if (connection_.awaitsReply() && clock_.now() - sent_ > patience)
    connection_.close("no reply for " + inSeconds(patience));
  noticeLoss();
}

void TcpLink::take(const Reply& reply) {
  const bool first = !std::exchange(greeted_, true);
  overdue_ = false;
  if (!reply.extension) {
    extended_ = false;
    takeOld(reply, first);
  } else if (!reply.extension->why_ended.empty()) {
    end(std::string{reply.extension->why_ended});
    return connection_.close("");
  } else if (reply.extension->seen != nullptr) {
    takeImage(*reply.extension, first);
  }
  if (picture_asked_) pictures_.take(reply, now());
  if (real_time_) judgeSpeed(reply);
  if (std::exchange(lost_, false) && tells_) say(name() + " is back; the robot goes on from where it is");
}

void TcpLink::takeImage(const ReplyExtension& extension, bool first) {
  real_time_ = extension.real_time;
  Sensors seen = *extension.seen;
  if (const Nanos told{seen.period_ns}; told > Nanos{0} && told <= kLongestPeriod) period_ = told;
  if (first && came_back_) {  // another loop, perhaps: its numbers go on behind those that were shown
    growOld();
    cycle_ahead_ = shown_.cycle + 1 - seen.cycle;
    time_ahead_ns_ = shown_.time_ns + period_.count() - seen.time_ns;
  }
  // The clock here may be ahead of the robot's after a pause; numbers never go back.
  seen.cycle = std::max(seen.cycle + cycle_ahead_, shown_.cycle);
  seen.time_ns = std::max(seen.time_ns + time_ahead_ns_, shown_.time_ns);
  image_ = seen;
  image_at_ = clock_.now();
  shown_ = image_;
  faults_.look(image_);
}

/// The image counts for the end of the step, where it is shown; its age is not told.
void TcpLink::takeOld(const Reply& reply, bool first) {
  const Nanos now = clock_.now();
  if (first && !came_back_) image_at_ = now;
  const auto by_the_clock = image_.cycle + static_cast<std::uint64_t>((now - image_at_) / period_);
  const std::uint64_t cycle = std::max(stepped_to_, by_the_clock);
  const std::uint64_t passed = cycle - image_.cycle;
  for (JointSensors& joint : image_.joint) age(joint.motion, passed);
  age(image_.board.motion, passed);
  image_at_ = expected(cycle);
  image_.time_ns += static_cast<std::int64_t>(passed) * period_.count();
  image_.cycle = cycle;
  image_.period_ns = period_.count();
  takeOldReply(reply, image_);
  if (first && !came_back_) shown_ = image_;
}

/// What is shown without a new image: the last one, as many cycles older as went by.
void TcpLink::growOld() {
  overdue_ = true;
  shown_ = image_;
  if (!real_time_) return;
  const Nanos gone_by = std::max(Nanos{0}, clock_.now() - image_at_);
  const auto cycles = static_cast<std::uint64_t>(gone_by / period_);
  shown_.cycle += cycles;
  shown_.time_ns += static_cast<std::int64_t>(cycles) * period_.count();
  for (JointSensors& joint : shown_.joint) {
    age(joint.motion, cycles);
    age(joint.health, cycles);
  }
  age(shown_.board.motion, cycles);
  if (lost_) shown_.safety.state = State::kOffline;
}

void TcpLink::judgeSpeed(const Reply& reply) {
  const Nanos held{reply.extension ? std::int64_t{reply.extension->held_us} * 1000 : 0};
  const std::string sentence = speed_.note({.network = clock_.now() - sent_ - held,
                                            .step = step_,
                                            .picture = reply.jpeg.size(),
                                            .size = reply.jpeg.empty() ? std::nullopt : pictures_.size()});
  if (!sentence.empty()) say(sentence);
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

bool TcpLink::mayGoOn(const std::atomic<bool>& stop) {
  if (stop.load()) return end("the controller was asked to stop");
  return why_ended_.empty();
}

bool TcpLink::end(const std::string& why) {
  why_ended_ = why;
  return false;
}

std::unique_ptr<FrameSource> TcpLink::openEyes(int /*width*/, int /*height*/) {
  return pictures_.open([this] { return now(); });
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
  connection_.send(farewell);
  settle();
}

}  // namespace darwinop::remote
