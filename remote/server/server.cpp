// The server: one thread, one client that drives, nothing that waits for the robot, an encoder or a slow network.
#include "remote/server/server.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace darwinop::remote {
namespace {

constexpr int kAtOnce = 64;          // pieces of work: a client has two a step
constexpr Nanos kLook{100'000'000};  // a signal that comes just before a wait is noticed after it

// Servos that nobody drives may have no power. Their first values are worth waiting for, as they were in 2013 (3 s).
constexpr Nanos kFirstValues{2'000'000'000}, kAskAgain{4'000'000};

// Our own clients wait here for a cycle of the robot: at most so long, a step of theirs being 200 ms or a part of it.
constexpr Nanos kForACycle{300'000'000}, kLookForACycle{1'000'000};

}  // namespace

Server::Server(const ServerConfig& config, RobotPort& robot, OpenPictures open_pictures, Clock clock,
               net::BoundedLog::Say say)
    : config_{config},
      robot_{robot},
      open_pictures_{std::move(open_pictures)},
      clock_{std::move(clock)},
      log_{std::move(say)},
      allowance_{config.pace, kAtOnce},
      listener_{config.address, config.port},
      now_{clock_()} {}

void Server::run(const std::atomic<bool>& stop) {
  while (!stop) attend(kLook);
}

void Server::attend(Nanos longest) {
  now_ = clock_();
  const bool may_work = allowance_.left(now_);
  // While a reply is on its way no further request is read: a client that does not fetch its replies gets no more.
  const bool looks = may_work && client_ && !client_->waits && !client_->more;
  const short for_client = !looks ? 0 : client_->owes() ? POLLOUT : POLLIN;
  std::array<pollfd, 2> places{{{listener_.isOpen() && may_work ? listener_.descriptor() : -1, POLLIN, 0},
                                {client_ ? client_->descriptor() : -1, for_client, 0}}};
  const bool something = poll(places.data(), places.size(), waitFor(longest)) > 0;
  now_ = clock_();
  log_.look(now_);
  if (client_ && client_->waits) {
    if (places[1].revents != 0 && !client_->receive())  // asked for nothing, it tells only of an end
      showOut(client_->why());
    else if (answerAgain(*client_->waits))
      answerAll();
  } else if (client_ && client_->more) {
    answerAll();
  } else if (something && client_ && places[1].revents != 0) {
    seeToClient();
  }
  lookForSilence();
  if (something && places[0].revents != 0 && listener_.isOpen()) letIn();
}

/// In ms, for poll: no longer than the client may be silent.
int Server::waitFor(Nanos longest) const {
  Nanos wait = longest;
  if (const Nanos rest = allowance_.wait(now_); rest > Nanos{0})
    wait = std::min(rest, longest);
  else if (client_ && client_->more)
    return 0;
  if (client_ && client_->waits)
    return static_cast<int>(std::min(longest, client_->waits->extended ? kLookForACycle : kAskAgain).count() /
                            1'000'000);
  if (client_ && !listener_.isOpen()) wait = std::clamp(client_->heard + config_.silence - now_, Nanos{0}, wait);
  return static_cast<int>((wait.count() + 999'999) / 1'000'000);
}

void Server::seeToClient() {
  allowance_.spend(now_);
  if (client_->owes() ? client_->flush() : client_->receive()) return answerAll();
  showOut(client_->why());
}

void Server::answerAll() {
  Request request;
  Oddities oddities;
  while (client_ && !client_->owes()) {
    client_->more = !allowance_.left(now_);
    if (client_->more) return;
    const RequestReader::Found found = client_->next(request, oddities);
    // A web page can make its reader's browser send anything to this port, but only behind a head of HTTP.
    if (!client_->driven && client_->garbageBytes() > 0)
      return showOut("speaks another protocol: its first byte begins no request");
    switch (found) {
      case RequestReader::Found::kNothing:
        if (client_->garbageBytes() > 0 && !std::exchange(client_->told_garbage, true))
          log(client_->name() + ": bytes that begin no request are skipped");
        return;
      case RequestReader::Found::kRefused:
        return showOut("sent a length that no request has; nothing after it can be trusted");
      case RequestReader::Found::kRequest:
        if (oddities.any()) tellOddities(oddities);
        allowance_.spend(now_);
        if (!answer(request)) return;
    }
  }
}

/// False: not yet, or the client was shown out.
bool Server::answer(const Request& request) {
  client_->asked = now_;
  return answerAgain(request);
}

/// The same of a request that has waited.
bool Server::answerAgain(const Request& request) {
  client_->heard = now_;
  if (!mayDrive(request)) return false;
  if (!client_->waits || !request.extended) robot_.obey(request);
  const Sensors seen = robot_.sensors();
  if (request.extended && isToCome(request.extension.until_cycle, seen)) {
    client_->waits = request;
    return false;
  }
  const JpegPicture newest = picture(request);
  Doubts doubts;
  Reply reply = answerTo(request, seen, newest.jpeg, doubts);
  if (request.extended) {
    extend(reply, request.extension, seen, newest, now_ - client_->asked);
    reply.extension->real_time = robot_.realTime();
  } else if (doubts.never.any() && now_ - client_->began < kFirstValues) {
    client_->waits = request;
    return false;
  }
  if (!request.extended) tellDoubts(doubts);  // else its own values tell how old they are
  const bool sent = client_->reply(request, reply);
  const bool last = request.extended && request.extension.farewell;
  client_->waits.reset();  // and perhaps `request` with it
  if (!sent) showOut(client_->why());
  if (sent && last) sayFarewell();
  return sent && client_;
}

bool Server::isToCome(std::uint64_t cycle, const Sensors& seen) const {
  return robot_.realTime() && seen.cycle < cycle && now_ - client_->asked < kForACycle;
}

JpegPicture Server::picture(const Request& request) {
  if (!request.camera) return {};
  if (!pictures_ && !client_->told_no_picture) openPictures();
  return pictures_ ? pictures_->newest() : JpegPicture{};
}

void Server::openPictures() {
  std::string why = "this robot has no eye";
  try {
    if (open_pictures_) pictures_ = open_pictures_();
  } catch (const std::runtime_error& blind) {
    why = blind.what();
  }
  if (pictures_) return;
  client_->told_no_picture = true;
  log(client_->name() + " asks for pictures, and gets 0 bytes of JPEG: " + why);
}

void Server::tellOddities(const Oddities& oddities) {
  Oddities& told = client_->told;
  const std::string who = client_->name() + ": ";
  if (oddities.unknown_at != 0 && std::exchange(told.unknown_at, oddities.unknown_at) == 0)
    log(who + "received unknown message: byte " + std::to_string(oddities.unknown_byte) + " at offset " +
        std::to_string(oddities.unknown_at) + " begins no section there; the rest of such requests is not read");
  if (oddities.cut_off && !std::exchange(told.cut_off, true))
    log(who + "a section is longer than its request; it is not obeyed");
  if (oddities.refused_motors > 0 && std::exchange(told.refused_motors, 1) == 0)
    log(who + "commands for motors over 19, which do not exist, are refused");
  if (oddities.refused_leds > 0 && std::exchange(told.refused_leds, 1) == 0)
    log(who + "commands for LEDs over 4, which do not exist, are refused");
  if (oddities.refused_sensors > 0 && std::exchange(told.refused_sensors, 1) == 0)
    log(who + "values of joints over 19, which do not exist, are answered with 0");
}

void Server::tellDoubts(const Doubts& doubts) {
  const auto news = doubts.never & ~client_->told_values.never;
  const auto aged = doubts.old & ~client_->told_values.old;
  client_->told_values.never |= news;
  client_->told_values.old |= aged;
  for (std::size_t i = 0; i <= Doubts::kBoard; ++i) {
    const std::string device{i == Doubts::kBoard ? "CM-730" : kJointTable[i].name};
    if (news[i]) log(device + " has never answered: its values are sent as -2147483648, which no sensor can be");
    if (aged[i]) log(device + " has not answered for 3 cycles: its last known values are sent");
  }
}

}  // namespace darwinop::remote
