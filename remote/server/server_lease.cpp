// Connections and sessions of the server: accept, take the lease, hold, disconnect.
#include <algorithm>
#include <stdexcept>

#include "remote/protocol/units.hpp"
#include "remote/server/messages.hpp"
#include "remote/server/server.hpp"

namespace darwinop::remote {
namespace {

/// Why a controller must not resume its session; empty: it may. A new session would start the robot again and clear
/// unseen faults.
std::string whyNotResumed(const SafetyReport& report, bool only_if_up) {
  if (report.controller_must_end) {
    const FaultRow& fault = row(report.worst);
    return "in the meantime " + std::string{fault.meaning} + "; " + std::string{fault.remedy};
  }
  if (only_if_up && report.state != State::kOffline && !drives(report.state)) return messages::kTorqueSwitchedOff;
  return {};
}

}  // namespace

bool Server::mayDrive(const Request& request) {
  const bool starts = !client_->drives;
  if (starts && !startSession(request)) return false;
  client_->extended = request.extended;
  std::string why = robot_.endReason();
  if (why.empty()) {
    why = client_->end_request = ends_ ? messages::kServerEnds : robot_.endRequest();
    const bool may_finish = request.extended && !starts;
    if (why.empty() || may_finish) return true;
  }
  refuse(request, "must end: ", why);
  return false;
}

/// False: the client was refused.
bool Server::startSession(const Request& request) {
  try {
    robot_.startSession(client_->has_driven ? SessionStart::kResumed : SessionStart::kNew);
  } catch (const std::runtime_error& refused) {
    refuse(request, "cannot drive the robot: ", refused.what());
    return false;
  }
  const bool only_if_up = request.extended && request.extension.only_if_up;
  const std::string changed =
      only_if_up || client_->has_driven ? whyNotResumed(robot_.sensors().safety, only_if_up) : std::string{};
  if (!changed.empty()) {
    robot_.cancelSession();
    refuse(request, "cannot resume: ", changed);
    return false;
  }
  listener_.close();
  log(client_->name() + (client_->has_driven ? " resumes driving" : messages::kDrives));
  client_->drives = client_->has_driven = true;
  client_->session_start = now_;
  return true;
}

/// At the end a client may finish its steps, as under the daemon: 2.9 s for a walk.
void Server::run(const std::atomic<bool>& stop) {
  constexpr Nanos kPollInterval{100'000'000};  // bounds the delay of a signal that arrives just before a wait
  constexpr Nanos kPatience{3'000'000'000};
  while (!stop) poll(kPollInterval);
  ends_ = true;
  const Nanos give_up = clock_() + kPatience;
  while (client_ && client_->drives && client_->extended && clock_() < give_up) poll(kPollInterval);
}

/// Sends the reason to clients with the extension, then disconnects.
void Server::refuse(const Request& request, const std::string& what, const std::string& why) {
  if (request.extended && !client_->hasUnsent()) {
    Reply reply;
    for (std::size_t i = 0; i < request.positions.size(); ++i) (void)reply.positions.add(kNoValue);
    for (std::size_t i = 0; i < request.torques.size(); ++i) (void)reply.torques.add(kNoValue);
    reply.extension = ReplyExtension{.real_time = true, .why_ended = why};
    (void)client_->reply(request, reply);
  }
  disconnect(what + why);
}

void Server::accept() {
  rate_limiter_.spend(now_);
  std::optional<net::Listener::Accepted> accepted = listener_.accept();
  if (!accepted) return;
  const auto is_inside = [&](const net::Network& network) { return network.has(accepted->address); };
  if (std::ranges::none_of(config_.allowed, is_inside)) {
    log(accepted->name + " was refused: its address is not in a network given with --allow");
    return;
  }
  if (client_) disconnect("was silent and is replaced by another client");
  log(accepted->name + " has connected");
  client_.emplace(std::move(accepted->socket), accepted->name, now_);
  listener_.close();
}

void Server::checkSilence() {
  if (client_ && now_ - client_->last_request_at < config_.silence) return;
  if (client_ && client_->drives) {
    stopDriving();
    log(client_->name() + " is silent: the robot holds; the client may resume unless another one connects");
  }
  reopen();
}

void Server::stopDriving() {
  if (!client_->drives) return;
  client_->drives = false;
  pictures_.reset();  // before hold(): its frame source may end with the lease
  robot_.hold();
}

void Server::endSession() {
  client_->drives = false;
  pictures_.reset();
  robot_.endSession();
  disconnect(messages::kSessionEnded);
}

void Server::disconnect(const std::string& why) {
  const std::string line = client_->name() + " " + why;  // copy: `why` may belong to the client
  stopDriving();
  client_.reset();
  reopen();  // before the log line: a client that reads it may connect at once
  log(line);
}

void Server::reopen() {
  if (listener_.isOpen()) return;
  try {
    listener_.open();
  } catch (const std::runtime_error& not_now) {
    log(not_now.what());  // retried in the next poll()
  }
}

}  // namespace darwinop::remote
