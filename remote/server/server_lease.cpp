// Who comes in, who drives, and how a client goes.
#include <algorithm>
#include <stdexcept>

#include "remote/protocol/units.hpp"
#include "remote/server/server.hpp"

namespace darwinop::remote {
namespace {

/// Why a robot is no longer that of a controller that had it under torque; empty: it is. A new driver would wake it,
/// and clear its faults unseen.
std::string whatCameBetween(const SafetyReport& report, bool only_if_up) {
  if (report.controller_must_end) {
    const FaultRow& fault = row(report.worst);
    return "meanwhile " + std::string{fault.meaning} + "; " + std::string{fault.remedy};
  }
  if (only_if_up && report.state != State::kOffline && !drives(report.state))
    return "the robot has let go meanwhile: it has sat down, or was released by hand. Start the controller again";
  return {};
}

}  // namespace

bool Server::mayDrive(const Request& request) {
  if (!client_->drives) {
    try {
      robot_.begin(client_->driven ? Beginning::kAgain : Beginning::kFresh);
    } catch (const std::runtime_error& refused) {
      refuse(request, "cannot drive the robot: ", refused.what());
      return false;
    }
    const bool only_if_up = request.extended && request.extension.only_if_up;
    const std::string came =
        only_if_up || client_->driven ? whatCameBetween(robot_.sensors().safety, only_if_up) : std::string{};
    if (!came.empty()) {
      robot_.leaveAlone();
      refuse(request, "goes on too late: ", came);
      return false;
    }
    listener_.close();
    log(client_->name() + (client_->driven ? " is back and drives on" : " drives; others are refused meanwhile"));
    client_->drives = client_->driven = true;
    client_->began = now_;
  }
  const std::string why = robot_.mustEnd();
  if (why.empty()) return true;
  refuse(request, "has to end: ", why);
  return false;
}

/// Our own clients are told why before they are shown out.
void Server::refuse(const Request& request, const std::string& what, const std::string& why) {
  if (request.extended && !client_->owes()) {
    Reply reply;
    for (std::size_t i = 0; i < request.positions.size(); ++i) (void)reply.positions.add(kNoValue);
    for (std::size_t i = 0; i < request.torques.size(); ++i) (void)reply.torques.add(kNoValue);
    reply.extension = ReplyExtension{.real_time = true, .why_ended = why};
    (void)client_->reply(request, reply);
  }
  showOut(what + why);
}

void Server::letIn() {
  allowance_.spend(now_);
  std::optional<net::Listener::Caller> caller = listener_.next();
  if (!caller) return;
  const auto lives_here = [&](const net::Network& network) { return network.has(caller->address); };
  if (std::ranges::none_of(config_.allowed, lives_here)) {
    log(caller->name + " may not connect: its address is in no network given with --allow");
    return;
  }
  if (client_) showOut("was silent, and another client takes its place");
  log(caller->name + " has connected");
  client_.emplace(std::move(caller->socket), caller->name, now_);
  listener_.close();
}

void Server::lookForSilence() {
  if (client_ && now_ - client_->heard < config_.silence) return;
  if (client_ && client_->drives) {
    stopDriving();
    log(client_->name() + " is silent: motion is held; it may go on unless another client comes");
  }
  openDoor();
}

void Server::stopDriving() {
  if (!client_->drives) return;
  client_->drives = false;
  pictures_.reset();  // before hold(): what it looks through may go with the lease
  robot_.hold();
}

void Server::sayFarewell() {
  client_->drives = false;
  pictures_.reset();
  robot_.farewell();
  showOut("has said farewell");
}

void Server::showOut(const std::string& why) {
  const std::string line = client_->name() + " " + why;  // `why` may be the client's own
  stopDriving();
  client_.reset();
  openDoor();  // first: who reads that one has left may come
  log(line);
}

void Server::openDoor() {
  if (listener_.isOpen()) return;
  try {
    listener_.open();
  } catch (const std::runtime_error& not_now) {
    log(not_now.what());  // tried again at the next look
  }
}

}  // namespace darwinop::remote
