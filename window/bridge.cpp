#include "window/bridge.hpp"

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "monitor/messages.hpp"
#include "monitor/search_message.hpp"

namespace darwinop::window {
namespace {

constexpr Nanos kBridgeTurn{4'000'000}, kBridgeIdle{100'000'000};

// A lane for each kind of message of which only the newest counts; notices, and what later versions say, are all kept.
constexpr std::array<std::string_view, 8> kLaned{"hello",  "gone",   "state", "loop",
                                                 "faults", "camera", "error", "found"};
constexpr web::Lane kBridgeGone = 1, kBridgeError = 6, kBridgePicture = 8;
static_assert(kBridgePicture < web::kLanes);

web::Lane laneOf(std::string_view type) {
  for (std::size_t i = 0; i < kLaned.size(); ++i)
    if (kLaned[i] == type) return static_cast<web::Lane>(i);
  return web::kEvery;
}

web::Bytes bytesOf(std::string_view text) {
  return std::make_shared<const std::string>(text);
}

std::string wishText(const monitor::Wishes& wishes) {
  return nlohmann::ordered_json{{"rate", wishes.rate}, {"camera", wishes.camera}, {"find", monitor::searchJson(wishes)}}
      .dump();
}

}  // namespace

void Bridge::opened(web::Channel& channel) {
  web::CallerConfig config;
  config.address = address_;
  config.port = port_;
  config.subprotocol = monitor::kSubprotocol;
  Line& line = lines_[&channel];
  line.caller = std::make_unique<web::Caller>(
      config,
      web::Caller::Ears{.heard = [this, &channel](std::string_view text, bool binary) { heard(channel, text, binary); },
                        .broken = [this, &channel](const std::string& why) { broken(channel, why); }});
  line.caller->say(wishText(line.wishes));
}

void Bridge::said(web::Channel& channel, std::string_view message, bool binary) {
  const auto line = lines_.find(&channel);
  if (line == lines_.end()) return;
  std::string why = "say what you want as text";
  const auto wishes = binary ? std::nullopt : monitor::readWishes(message, line->second.wishes, why);
  if (!wishes) return channel.send(kBridgeError, bytesOf(monitor::errorText(why)));
  line->second.wishes = *wishes;
  line->second.caller->say(wishText(*wishes));
}

void Bridge::look() {
  for (auto& [channel, line] : lines_) line.caller->look();
}

void Bridge::tellEnd(const std::string& why) {
  const web::Bytes text = bytesOf(nlohmann::json{{"type", "ended"}, {"text", why}}.dump());
  for (auto& [channel, line] : lines_) channel->send(web::kEvery, text);
}

Nanos Bridge::pause() const {
  return lines_.empty() ? kBridgeIdle : kBridgeTurn;
}

void Bridge::heard(web::Channel& channel, std::string_view message, bool binary) {
  lines_.at(&channel).gone.clear();
  if (binary) return channel.sendBinary(kBridgePicture, bytesOf(message));
  const auto said = nlohmann::json::parse(message.begin(), message.end(), nullptr, false);
  if (!said.is_object()) return;  // no monitor says that
  const auto type = said.find("type");
  if (type == said.end() || !type->is_string()) return;
  if (*type == "hello") channel.forgetNewest();  // what waits was said of another runtime
  channel.send(laneOf(type->get_ref<const std::string&>()), bytesOf(message));
}

void Bridge::broken(web::Channel& channel, const std::string& why) {
  std::string reason =
      "no connection to the monitor at " + name_ + " (" + why +
      "). It is tried again each second. Is darwinop monitor running there, and may this computer see it?";
  Line& line = lines_.at(&channel);
  if (line.gone == reason) return;
  channel.forgetNewest();
  channel.send(kBridgeGone, bytesOf(monitor::goneText(reason)));
  line.gone = std::move(reason);
}

}  // namespace darwinop::window
