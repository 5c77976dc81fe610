// A robot behind `darwinop remote`: each step is an exchange with its server.
#include "remote/client/tcp_link.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "core/text/printable.hpp"
#include "hal/net/resolve.hpp"
#include "remote/client/old_sensors.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kLookAround{50'000'000};  // for a flag that another thread sets
constexpr Nanos kLateReply{100'000'000};  // after the end of a step: the controller goes on with values grown old
constexpr Nanos kLongestPeriod{1'000'000'000};

void age(Freshness& freshness, std::uint64_t cycles) {
  if (freshness.ever())
    freshness.age = static_cast<std::uint32_t>(std::min<std::uint64_t>(freshness.age + cycles, Freshness::kNever - 1));
}

/// As it is so many cycles later, when no other one came.
void growOlder(Sensors& image, std::uint64_t cycles, Nanos period) {
  image.cycle += cycles;
  image.time_ns += static_cast<std::int64_t>(cycles) * period.count();
  for (JointSensors& joint : image.joint) {
    age(joint.motion, cycles);
    age(joint.health, cycles);
  }
  age(image.board.motion, cycles);
}

}  // namespace

TcpLink::TcpLink(TcpOptions options)
    : options_{std::move(options)}, pictures_{[this](const std::string& what) { say(what); }}, faults_{std::cerr} {
  addresses_ = net::addressesOf(options_.host);
  connectFirst();
  firstReply();
}

std::string TcpLink::name() const {
  return "tcp://" + options_.host + ":" + std::to_string(options_.port);
}

void TcpLink::say(const std::string& sentence) const {
  if (options_.say) options_.say(sentence);
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
                         .start_where_it_is = wanted_.start_where_it_is || came_back_,
                         .only_if_up = was_up_,
                         .unattended = wanted_.unattended || unattended_ || came_back_};
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
    // Who asks late, after a long computation, still gets what it asked for.
    const Nanos until = isThere(cycle) ? image_at_ : std::max(expected(cycle), sent_) + patienceWithReply();
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

void TcpLink::take(const Reply& reply) {
  const bool first = !std::exchange(greeted_, true);
  overdue_ = false;
  if (!reply.extension) {
    extended_ = false;
    takeOld(reply, first);
  } else if (!reply.extension->why_ended.empty()) {
    end(text::printableLines(reply.extension->why_ended));
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
  seen.cycle += cycle_ahead_;
  seen.time_ns += time_ahead_ns_;
  if (!first) growOlder(seen, cyclesOnTheWay(seen.cycle, Nanos{std::int64_t{extension.held_us} * 1000}), period_);
  // Numbers never go back. A loop that stood still runs no cycle twice: from now on it is so many behind.
  if (seen.cycle < shown_.cycle) cycle_ahead_ += shown_.cycle - std::exchange(seen.cycle, shown_.cycle);
  seen.time_ns = std::max(seen.time_ns, shown_.time_ns);
  image_ = seen;
  image_at_ = clock_.now();
  shown_ = image_;
  was_up_ = was_up_ || drives(image_.safety.state);
  faults_.look(image_);
}

/// A reply that lay somewhere, as in front of a controller that was stopped, is old when it is read. What is a little
/// late is waited for, and counts as new.
std::uint64_t TcpLink::cyclesOnTheWay(std::uint64_t cycle, Nanos held) const {
  if (!real_time_) return 0;
  const Nanos now = clock_.now();
  const Nanos on_the_way = std::min(now - expected(cycle), now - sent_ - held);
  return on_the_way > kLateReply ? static_cast<std::uint64_t>(on_the_way / period_) : 0;
}

/// The image counts for the end of the step, where it is shown; its age is not told.
void TcpLink::takeOld(const Reply& reply, bool first) {
  const Nanos now = clock_.now();
  if (first && !came_back_) image_at_ = now;
  const auto by_the_clock = image_.cycle + static_cast<std::uint64_t>((now - image_at_) / period_);
  const std::uint64_t cycle = std::max(stepped_to_, by_the_clock);
  image_at_ = expected(cycle);
  growOlder(image_, cycle - image_.cycle, period_);  // their health is never told
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
  growOlder(shown_, static_cast<std::uint64_t>(gone_by / period_), period_);
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

}  // namespace darwinop::remote
