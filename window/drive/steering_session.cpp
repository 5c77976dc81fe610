// Takeover, heartbeat and end of a page's steering session.
#include "window/drive/steering_session.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/json/json_text.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

enum class Phase { kSettled, kTaking, kEnding };

void sendDriving(web::Channel& channel, bool yours, const std::string& text, Phase phase = Phase::kSettled) {
  const nlohmann::json message{{"type", "driving"},
                               {"yours", yours},
                               {"taking", phase == Phase::kTaking},
                               {"ending", phase == Phase::kEnding},
                               {"text", text}};
  channel.send(web::kEvery, std::make_shared<const std::string>(jsonText(message)));
}

}  // namespace

SteeringSession::~SteeringSession() {
  if (driver_ != nullptr) drive_.finish();
}

void SteeringSession::opened(web::Channel& channel) {
  if (driver_ == nullptr && drive_.report().state != DriveState::kFree)
    awaitEnd(channel, "");
  else
    sendDriving(channel, false, "");
}

void SteeringSession::received(web::Channel& channel, std::string_view message, bool binary) {
  std::string why = "requests must be text messages";
  const std::optional<SteeringMessage> request = binary ? std::nullopt : parseSteering(message, why);
  if (!request) return sendDriving(channel, is_driving_ && driver_ == &channel, why);  // does not count as a heartbeat
  if (request->stop) return stop(channel);
  if (request->take && driver_ == nullptr)
    take(channel);
  else if (request->take && driver_ != &channel)
    sendDriving(channel, false, messages::kAnotherPageDrives);
  if (driver_ != &channel) return;
  last_heartbeat_ = clock_();
  if (request->leave) {
    const bool held = hasTorque();
    drive_.finish();
    return release(held ? messages::kDrivingEnded : messages::kTakeoverCancelled);
  }
  requests_.merge(request->requests);
}

void SteeringSession::take(web::Channel& channel) {
  if (drive_.report().state != DriveState::kFree) return sendDriving(channel, false, messages::kPreviousSessionEnds);
  sendEnd();
  driver_ = &channel;
  is_driving_ = false;
  requests_ = {};
  sent_status_ = {};
  sendDriving(channel, false, messages::kTakesTheRobot, Phase::kTaking);
  drive_.start();
}

/// From every page, also while the steps of an ended session are completed: each person who sees the robot may stop it.
void SteeringSession::stop(const web::Channel& channel) {
  if (drive_.report().state == DriveState::kFree) return;
  const bool held = hasTorque();
  drive_.stop();
  if (driver_ == &channel)
    release(held ? messages::kDrivingEnded : messages::kTakeoverCancelled);
  else if (driver_ != nullptr)
    release(held ? messages::kAnotherPageStopped : messages::kAnotherPageCancelled);
}

bool SteeringSession::hasTorque() {
  return is_driving_ || drive_.report().state == DriveState::kDriving;
}

void SteeringSession::update() {
  if (drive_.report().state == DriveState::kFree) sendEnd();
  if (driver_ == nullptr) return;
  const DriveInterface::Report report = drive_.report();
  if (report.state == DriveState::kFree || (is_driving_ && report.state != DriveState::kDriving))
    return release(report.why);
  if (!is_driving_ && report.state == DriveState::kDriving) {
    is_driving_ = true;
    last_heartbeat_ = clock_();  // the page did not have to send heartbeats so far
    sendDriving(*driver_, true, "");
  }
  if (!is_driving_) return;
  if (clock_() - last_heartbeat_ > kHeartbeatTimeout) {
    drive_.finish();
    return release(messages::kNoHeartbeat);
  }
  drive_.request(requests_);
  requests_.clearOneTime();
  if (report.status != sent_status_) sendStatus(report.status);
}

void SteeringSession::sendStatus(const DriveStatus& status) {
  sent_status_ = status;
  nlohmann::json limp = nlohmann::json::array();
  for (std::size_t i = 0; i < kLimbs; ++i)
    if (status.limp[i]) limp.push_back(limbName(i));
  const nlohmann::json message{
      {"type", "doing"}, {"walks", status.walks}, {"page", status.page}, {"limp", limp}, {"refused", status.refused}};
  driver_->send(web::kEvery, std::make_shared<const std::string>(message.dump()));
}

void SteeringSession::release(const std::string& why) {
  is_driving_ = false;
  awaitEnd(*std::exchange(driver_, nullptr), why);
}

void SteeringSession::awaitEnd(web::Channel& channel, const std::string& text) {
  const DriveState state = drive_.report().state;
  if (state == DriveState::kFree) return sendDriving(channel, false, text);
  await_end_[&channel] = text;
  const char* const meanwhile = state == DriveState::kEnding ? messages::kCompletesItsStep : messages::kSessionEnds;
  sendDriving(channel, false, meanwhile, Phase::kEnding);
}

void SteeringSession::sendEnd() {
  for (const auto& [page, text] : std::exchange(await_end_, {})) sendDriving(*page, false, text);
}

void SteeringSession::closed(web::Channel& channel) noexcept {
  await_end_.erase(&channel);
  if (driver_ != &channel) return;
  driver_ = nullptr;
  is_driving_ = false;
  drive_.finish();
}

}  // namespace darwinop::window
