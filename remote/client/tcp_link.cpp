// Robot link over TCP to `darwinop remote`: one request and one reply per step.
#include "remote/client/tcp_link.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "core/text/printable.hpp"
#include "hal/net/names/resolve.hpp"
#include "remote/client/image_age.hpp"
#include "remote/client/image_bounds.hpp"
#include "remote/client/legacy_sensors.hpp"
#include "remote/client/messages.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kStopCheck{50'000'000};   // interval at which the stop flag is checked
constexpr Nanos kLateReply{100'000'000};  // after the end of a step: then the step ends with aged values
constexpr Nanos kHeldAfter{500'000'000};  // without a reply: safety holds a silent controller (stall_ms)
constexpr Nanos kShortestPeriod{1'000'000}, kLongestPeriod{1'000'000'000};

}  // namespace

TcpLink::TcpLink(TcpOptions options)
    : options_{std::move(options)}, pictures_{[this](const std::string& what) { log(what); }}, faults_{std::cerr} {
  addresses_ = net::addressesOf(options_.host);
  connect();
  awaitFirstReply();
}

void TcpLink::publish(Commands commands) {
  commands_ = commands;
}

void TcpLink::send(std::uint64_t cycle) {
  const Commands wanted = commands_.value_or(Commands{.start_where_it_is = options_.start_where_it_is});
  const bool was_lost = loss_.since.has_value();
  Request request;
  if (commands_) command_delta_.add(wanted, request);
  request.camera = pictures_.areDue();
  request.extended = server_.extended;
  if (server_.extended)
    request.extension = {.until_cycle = isConnected(state_) ? cycle - cycle_ahead_ : 0,
                         .fault_resets = wanted.fault_resets,
                         .picture = pictures_.held(),
                         .start_where_it_is = wanted.start_where_it_is || was_lost,
                         .only_if_up = was_driven_,
                         .unattended = wanted.unattended || unattended_ || was_lost};
  if (!server_.extended || !isConnected(state_)) requestAllSensors(request);
  last_request_ = {.cycle = cycle, .sent_at = clock_.now(), .for_picture = request.camera};
  connection_.send(request);
}

bool TcpLink::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  if (cycle > stepped_to_) {
    step_ = static_cast<Nanos::rep>(cycle - stepped_to_) * server_.period;
    stepped_to_ = cycle;
  }
  // After a stop or a request to end, the last steps of a walk may follow.
  while (!stop.load() && why_ended_.empty() && !reportsEndRequest()) {
    if (shown_.cycle >= cycle) return true;
    if (connection_.state() != Connection::State::kOpen)
      reconnect();
    else if (mustRequest(cycle))
      send(cycle);
    // Counted from the request if that was later: a controller that computed for long still gets its reply.
    const Nanos until = hasImage(cycle) ? image_at_ : std::max(expected(cycle), last_request_.sent_at) + replyGrace();
    const Nanos left = until - clock_.now();
    if (hasImage(cycle) && left <= Nanos{0}) {
      shown_ = image_;
    } else if (server_.real_time && left <= Nanos{0}) {
      state_ = next(state_, TcpEvent::kReplyLate);
      ageShownImage();
    } else {
      receive(server_.real_time ? std::min(left, kStopCheck) : kStopCheck);
    }
  }
  return false;
}

/// A server with the extension is polled until it has reached this cycle; another one gets one request per step.
bool TcpLink::mustRequest(std::uint64_t cycle) const {
  if (connection_.awaitsReply() || hasImage(cycle)) return false;
  return server_.extended || !isConnected(state_) || last_request_.cycle < cycle;
}

/// Local time at which the cycle is due.
Nanos TcpLink::expected(std::uint64_t cycle) const {
  return image_at_ + static_cast<Nanos::rep>(cycle - image_.cycle) * server_.period;
}

/// Grace period for a late reply. None after a missed one: the following steps keep their time, without new values.
Nanos TcpLink::replyGrace() const {
  return state_ == TcpState::kLost || state_ == TcpState::kLate ? Nanos{0} : kLateReply;
}

void TcpLink::take(const Reply& reply) {
  const TcpState before = std::exchange(state_, next(state_, TcpEvent::kReply));
  if (!reply.extension) {
    server_.extended = false;
    takeLegacy(reply, before);
  } else if (const auto why = text::printableLines(reply.extension->why_ended);
             !why.empty() && (reply.extension->seen == nullptr || !isConnected(before))) {
    why_ended_ = why;
    return connection_.close("");
  } else if (reply.extension->seen != nullptr) {
    end_request_ = why;
    if (!takeImage(*reply.extension, before)) {
      state_ = before;
      return connection_.close(messages::kInvalidReply);
    }
  }
  if (last_request_.for_picture) pictures_.take(reply, now());
  if (server_.real_time) checkSpeed(reply);
  if (before == TcpState::kLost && loss_.isLogged()) log(name() + messages::kConnectedAgain);
}

/// False, and no image is taken, if its numbers are those of no loop.
bool TcpLink::takeImage(const ReplyExtension& extension, TcpState before) {
  server_.real_time = extension.real_time;
  Sensors seen = *extension.seen;
  if (!isInBounds(seen)) return false;
  if (const Nanos period{seen.period_ns}; period >= kShortestPeriod && period <= kLongestPeriod)
    server_.period = period;
  if (before == TcpState::kLost) {  // possibly a restarted loop: map its cycle numbers behind the last one returned
    ageShownImage();
    cycle_ahead_ = shown_.cycle + 1 - seen.cycle;
    time_ahead_ns_ = shown_.time_ns + server_.period.count() - seen.time_ns;
  }
  seen.cycle += cycle_ahead_;
  seen.time_ns += time_ahead_ns_;
  if (!isInBounds(seen) || (isConnected(before) && !isJumpInBounds(image_, seen))) return false;
  if (isConnected(before))
    ageImage(seen, cyclesOnTheWay(seen.cycle, Nanos{std::int64_t{extension.held_us} * 1000}), server_.period);
  // Cycle numbers never decrease. A loop that stood still stays behind by that many cycles from now on.
  if (seen.cycle < shown_.cycle) cycle_ahead_ += shown_.cycle - std::exchange(seen.cycle, shown_.cycle);
  seen.time_ns = std::max(seen.time_ns, shown_.time_ns);
  image_ = seen;
  image_at_ = clock_.now();
  shown_ = image_;
  was_driven_ = was_driven_ || std::ranges::any_of(image_.joint, &JointSensors::driven);
  faults_.update(image_);
  return true;
}

/// Age of a reply that was buffered, for example while the controller was stopped, in cycles. Delays within the grace
/// period count as 0.
std::uint64_t TcpLink::cyclesOnTheWay(std::uint64_t cycle, Nanos held) const {
  if (!server_.real_time) return 0;
  const Nanos now = clock_.now();
  const Nanos on_the_way = std::min(now - expected(cycle), now - last_request_.sent_at - held);
  return on_the_way > kLateReply ? static_cast<std::uint64_t>(on_the_way / server_.period) : 0;
}

/// The image counts for the end of the step; the 2013 protocol does not report its age.
void TcpLink::takeLegacy(const Reply& reply, TcpState before) {
  const Nanos now = clock_.now();
  if (before == TcpState::kFirstContact) image_at_ = now;
  const auto by_the_clock = image_.cycle + static_cast<std::uint64_t>((now - image_at_) / server_.period);
  const std::uint64_t cycle = std::max(stepped_to_, by_the_clock);
  image_at_ = expected(cycle);
  ageImage(image_, cycle - image_.cycle, server_.period);  // polled values are not in the 2013 protocol
  image_.period_ns = server_.period.count();
  takeLegacyReply(reply, image_);
  if (before == TcpState::kFirstContact) shown_ = image_;
}

/// Without a new image: the last one, aged by the cycles since then.
void TcpLink::ageShownImage() {
  shown_ = image_;
  if (!server_.real_time) return;
  const Nanos elapsed = std::max(Nanos{0}, clock_.now() - image_at_);
  ageImage(shown_, static_cast<std::uint64_t>(elapsed / server_.period), server_.period);
  if (state_ == TcpState::kLost)
    shown_.safety.state = State::kOffline;
  else if (elapsed > kHeldAfter && shown_.safety.state == State::kDriven)
    shown_.safety.state = State::kHolding;
}

void TcpLink::checkSpeed(const Reply& reply) {
  const Nanos held{reply.extension ? std::int64_t{reply.extension->held_us} * 1000 : 0};
  const std::string message = speed_.note({.network = clock_.now() - last_request_.sent_at - held,
                                           .step = step_,
                                           .picture = reply.jpeg.size(),
                                           .size = reply.jpeg.empty() ? std::nullopt : pictures_.size()});
  if (!message.empty()) log(message);
}

std::unique_ptr<FrameSource> TcpLink::openCamera(int /*width*/, int /*height*/) {
  return pictures_.open([this] { return now(); });
}

}  // namespace darwinop::remote
