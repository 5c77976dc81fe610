// Doctor channel: requests and states.
#include "window/doctor/doctor_channel.hpp"

#include <exception>

#include "core/json/json_text.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;

constexpr Nanos kWhileItRuns{20'000'000}, kNothingRuns{1'000'000'000};
constexpr web::Lane kDoctorState = 0;

json textOrNull(const std::string& text) {
  return text.empty() ? json(nullptr) : json(text);
}

}  // namespace

void DoctorChannel::opened(web::Channel& channel) {
  pages_.insert(&channel);
  channel.send(kDoctorState, stateText());
}

void DoctorChannel::received(web::Channel& channel, std::string_view message, bool binary) {
  const json request = binary ? json() : json::parse(message.begin(), message.end(), nullptr, false);
  if (!request.is_object() || request != json{{"check", true}}) return channel.close(messages::kInvalidDoctorRequest);
  if (run_ || !command_.elsewhere.empty()) return;  // the page that asked has seen neither yet
  start();
  sendState();
}

void DoctorChannel::start() {
  document_ = nullptr;
  error_.clear();
  try {
    run_ = std::make_unique<DoctorRun>(command_);
  } catch (const std::exception& error) {
    error_ = error.what();
  }
}

void DoctorChannel::update() {
  if (!run_ || !run_->poll()) return;
  document_ = run_->document();
  error_ = run_->error();
  run_.reset();
  sendState();
}

Nanos DoctorChannel::pause() const {
  return run_ ? kWhileItRuns : kNothingRuns;
}

void DoctorChannel::sendState() {
  const web::Bytes text = stateText();
  for (web::Channel* channel : pages_) channel->send(kDoctorState, text);
}

web::Bytes DoctorChannel::stateText() const {
  const json state{{"type", "doctor"},        {"command", typedCommand(command_)},
                   {"runs", run_ != nullptr}, {"elsewhere", textOrNull(command_.elsewhere)},
                   {"document", document_},   {"error", textOrNull(error_)}};
  return std::make_shared<const std::string>(jsonText(state));
}

}  // namespace darwinop::window
