// TCP server of remote control: single-threaded, one client at a time, never blocks on robot, encoder or network.
#include "remote/server/server.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "remote/server/messages.hpp"

namespace darwinop::remote {
namespace {

constexpr int kAtOnce = 64;  // burst of the rate limit, pieces of work: a client needs two per step

// Servos may be without power before the session. The first values are waited for, as in the 2013 server (3 s).
constexpr Nanos kFirstValues{2'000'000'000}, kFirstValuesInterval{4'000'000};

// Hold time of a request for a cycle: longer than the longest step of a client, 200 ms.
constexpr Nanos kMaxCycleWait{300'000'000}, kCyclePollInterval{1'000'000};

}  // namespace

Server::Server(const ServerConfig& config, RobotPort& robot, OpenPictures open_pictures, Clock clock,
               net::BoundedLog::Log log)
    : config_{config},
      robot_{robot},
      open_pictures_{std::move(open_pictures)},
      clock_{std::move(clock)},
      log_{std::move(log)},
      rate_limiter_{config.pace, kAtOnce},
      listener_{config.address, config.port},
      now_{clock_()} {}

void Server::poll(Nanos longest) {
  now_ = clock_();
  const bool may_work = rate_limiter_.allows(now_);
  // No request is read while a reply is unsent: a client must read its replies to get more.
  const bool looks = may_work && client_ && !client_->waiting && !client_->has_backlog;
  const short for_client = !looks ? 0 : client_->hasUnsent() ? POLLOUT : POLLIN;
  std::array<pollfd, 2> places{{{listener_.isOpen() && may_work ? listener_.descriptor() : -1, POLLIN, 0},
                                {client_ ? client_->descriptor() : -1, for_client, 0}}};
  const bool something = ::poll(places.data(), places.size(), pollTimeout(longest)) > 0;
  now_ = clock_();
  log_.reportOmitted(now_);
  if (client_ && client_->waiting) {
    if (places[1].revents != 0 &&
        !client_->receive())  // polled without events: only the end of the connection is reported
      disconnect(client_->why());
    else if (resume(*client_->waiting))
      handleRequests();
  } else if (client_ && client_->has_backlog) {
    handleRequests();
  } else if (something && client_ && places[1].revents != 0) {
    serveClient();
  }
  checkSilence();
  if (something && places[0].revents != 0 && listener_.isOpen()) accept();
}

/// Timeout for poll(), ms: at most until the client counts as silent.
int Server::pollTimeout(Nanos longest) const {
  Nanos wait = longest;
  if (const Nanos rest = rate_limiter_.wait(now_); rest > Nanos{0})
    wait = std::min(rest, longest);
  else if (client_ && client_->has_backlog)
    return 0;
  if (client_ && client_->waiting)
    return static_cast<int>(
        std::min(longest, client_->waiting->extended ? kCyclePollInterval : kFirstValuesInterval).count() / 1'000'000);
  if (client_ && !listener_.isOpen())
    wait = std::clamp(client_->last_request_at + config_.silence - now_, Nanos{0}, wait);
  return static_cast<int>((wait.count() + 999'999) / 1'000'000);
}

void Server::serveClient() {
  rate_limiter_.spend(now_);
  if (client_->hasUnsent() ? client_->flush() : client_->receive()) return handleRequests();
  disconnect(client_->why());
}

void Server::handleRequests() {
  Request request;
  RequestIssues issues;
  while (client_ && !client_->hasUnsent()) {
    client_->has_backlog = !rate_limiter_.allows(now_);
    if (client_->has_backlog) return;
    const RequestReader::Result result = client_->next(request, issues);
    // A web page can make a browser send any bytes to this port, but only after an HTTP header.
    if (!client_->has_driven && client_->garbageBytes() > 0) return disconnect(messages::kOtherProtocol);
    switch (result) {
      case RequestReader::Result::kIncomplete:
        if (client_->garbageBytes() > 0 && !std::exchange(client_->logged_garbage, true))
          log(client_->name() + messages::kSkippedBytes);
        return;
      case RequestReader::Result::kInvalid:
        return disconnect("was disconnected: it sent an invalid request length");
      case RequestReader::Result::kRequest:
        if (issues.any()) logRequestIssues(issues);
        rate_limiter_.spend(now_);
        if (!handle(request)) return;
    }
  }
}

/// False: the request waits, or the client was disconnected.
bool Server::handle(const Request& request) {
  client_->request_at = now_;
  return resume(request);
}

/// The same for a request that has waited.
bool Server::resume(const Request& request) {
  client_->last_request_at = now_;
  if (!mayDrive(request)) return false;
  if (!client_->waiting || !request.extended) robot_.apply(request);
  const Sensors seen = robot_.sensors();
  if (request.extended && mustAwait(request.extension.until_cycle, seen)) {
    client_->waiting = request;
    return false;
  }
  const JpegPicture newest = picture(request);
  finishedWork();
  StaleValues stale;
  Reply reply = makeReply(request, seen, newest.jpeg, stale);
  if (request.extended) {
    addExtension(reply, request.extension, seen, newest, now_ - client_->request_at);
    reply.extension->real_time = robot_.realTime();
    reply.extension->why_ended = client_->end_request;
  } else if (stale.never.any() && now_ - client_->session_start < kFirstValues) {
    client_->waiting = request;
    return false;
  }
  if (!request.extended) logStaleValues(stale);  // the extension contains the ages
  const bool sent = client_->reply(request, reply);
  const bool last = request.extended && request.extension.end_of_session;
  client_->waiting.reset();  // destroys `request` if it is this one
  if (!sent) disconnect(client_->why());
  if (sent && last) endSession();
  return sent && client_;
}

bool Server::mustAwait(std::uint64_t cycle, const Sensors& seen) const {
  return robot_.realTime() && seen.cycle < cycle && now_ - client_->request_at < kMaxCycleWait;
}

JpegPicture Server::picture(const Request& request) {
  if (!request.camera) return {};
  if (!pictures_ && !client_->logged_no_picture) openPictures();
  if (pictures_) return pictures_->newest();
  return request.extended ? JpegPicture{} : JpegPicture{.jpeg = config_.no_picture};
}

void Server::openPictures() {
  std::string why = "this robot has no camera";
  try {
    if (open_pictures_) pictures_ = open_pictures_();
  } catch (const std::runtime_error& blind) {
    why = blind.what();
  }
  if (pictures_) return;
  client_->logged_no_picture = true;
  log(client_->name() + messages::kNoPictures + why);
}

void Server::logRequestIssues(const RequestIssues& issues) {
  RequestIssues& logged_issues = client_->logged_issues;
  const std::string who = client_->name() + ": ";
  if (issues.unknown_at != 0 && std::exchange(logged_issues.unknown_at, issues.unknown_at) == 0)
    log(who + messages::kUnknownSection + std::to_string(issues.unknown_byte) + " at offset " +
        std::to_string(issues.unknown_at) + " does not start a section; the rest of such requests is ignored");
  if (issues.cut_off && !std::exchange(logged_issues.cut_off, true))
    log(who + "ignored a section that is longer than its request");
  if (issues.invalid_motors > 0 && std::exchange(logged_issues.invalid_motors, 1) == 0)
    log(who + "ignored commands for motors above 19, which do not exist");
  if (issues.invalid_leds > 0 && std::exchange(logged_issues.invalid_leds, 1) == 0)
    log(who + "ignored commands for LEDs above 4, which do not exist");
  if (issues.invalid_sensors > 0 && std::exchange(logged_issues.invalid_sensors, 1) == 0)
    log(who + messages::kUnknownJoints);
}

void Server::logStaleValues(const StaleValues& stale) {
  const auto unknown = stale.never & ~client_->logged_values.never;
  const auto aged = stale.old & ~client_->logged_values.old;
  client_->logged_values.never |= unknown;
  client_->logged_values.old |= aged;
  for (std::size_t i = 0; i <= StaleValues::kBoard; ++i) {
    const std::string device{i == StaleValues::kBoard ? "CM-730" : kJointTable[i].name};
    if (unknown[i]) log(device + messages::kNeverAnswered);
    if (aged[i]) log(device + messages::kAnsweredLongAgo);
  }
}

}  // namespace darwinop::remote
