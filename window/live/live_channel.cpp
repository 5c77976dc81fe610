#include "window/live/live_channel.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/json/json_text.hpp"
#include "window/live/live_message.hpp"

namespace darwinop::window {
namespace {

constexpr web::Lane kLiveState = 0;

}  // namespace

void LiveChannel::opened(web::Channel& channel) {
  pages_.insert(&channel);
  channel.send(kLiveState, text());
}

void LiveChannel::received(web::Channel& channel, std::string_view message, bool binary) {
  std::string why = "requests must be text messages";
  const std::optional<LiveRequest> request = binary ? std::nullopt : parseLiveRequest(message, why);
  if (!request) {
    const nlohmann::json refused{{"type", "refused"}, {"text", why}};
    return channel.send(web::kEvery, std::make_shared<const std::string>(jsonText(refused)));
  }
  runs_ = request->run.has_value();
  if (runs_) {
    thread_.start(*request->run);
  } else {
    thread_.stop();
  }
  send();
}

void LiveChannel::closed(web::Channel& channel) noexcept {
  pages_.erase(&channel);
  if (!pages_.empty() || !runs_) return;
  runs_ = false;
  thread_.stop();
}

void LiveChannel::update() {
  if (runs_ && clock_() - sent_ >= kPause) send();
}

void LiveChannel::send() {
  sent_ = clock_();
  const web::Bytes message = text();
  for (web::Channel* page : pages_) page->send(kLiveState, message);
}

web::Bytes LiveChannel::text() const {
  LiveStatus status = thread_.status();
  if (!runs_ && status.report.cycles == 0) status.setting = first_;
  return std::make_shared<const std::string>(liveText(status));
}

}  // namespace darwinop::window
