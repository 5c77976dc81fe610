// Forwards messages between page and remote monitor.
#include "window/view/bridge.hpp"

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "monitor/messages.hpp"
#include "monitor/search_message.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

constexpr Nanos kBridgePoll{4'000'000}, kBridgeIdle{100'000'000};

// Messages with a lane each, of which only the newest is sent. Notices and unknown types are all kept.
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

std::string requestText(const monitor::Subscription& subscription) {
  return nlohmann::ordered_json{
      {"rate", subscription.rate}, {"camera", subscription.camera}, {"find", monitor::searchJson(subscription)}}
      .dump();
}

}  // namespace

void Bridge::opened(web::Channel& channel) {
  web::WebSocketClientConfig config;
  config.address = address_;
  config.port = port_;
  config.subprotocol = monitor::kSubprotocol;
  Connection& connection = connections_[&channel];
  connection.client = std::make_unique<web::WebSocketClient>(
      config, web::WebSocketClient::Callbacks{
                  .received = [this, &channel](std::string_view text, bool binary) { forward(channel, text, binary); },
                  .disconnected = [this, &channel](const std::string& why) { disconnected(channel, why); }});
  connection.client->request(requestText(connection.subscription));
}

void Bridge::received(web::Channel& channel, std::string_view message, bool binary) {
  const auto connection = connections_.find(&channel);
  if (connection == connections_.end()) return;
  std::string why = "requests must be text messages";
  const auto subscription =
      binary ? std::nullopt : monitor::parseSubscription(message, connection->second.subscription, why);
  if (!subscription) return channel.send(kBridgeError, bytesOf(monitor::errorText(why)));
  connection->second.subscription = *subscription;
  connection->second.client->request(requestText(*subscription));
}

void Bridge::update() {
  for (auto& [channel, connection] : connections_) connection.client->poll();
}

void Bridge::sendEnd(const std::string& why) {
  const web::Bytes text = bytesOf(nlohmann::json{{"type", "ended"}, {"text", why}}.dump());
  for (auto& [channel, connection] : connections_) channel->send(web::kEvery, text);
}

Nanos Bridge::pause() const {
  return connections_.empty() ? kBridgeIdle : kBridgePoll;
}

void Bridge::forward(web::Channel& channel, std::string_view message, bool binary) {
  connections_.at(&channel).gone_reason.clear();
  if (binary) return channel.sendBinary(kBridgePicture, bytesOf(message));
  const auto parsed = nlohmann::json::parse(message.begin(), message.end(), nullptr, false);
  if (!parsed.is_object()) return;  // not a monitor message
  const auto type = parsed.find("type");
  if (type == parsed.end() || !type->is_string()) return;
  if (*type == "hello") channel.discardQueued();  // queued messages describe the previous runtime
  channel.send(laneOf(type->get_ref<const std::string&>()), bytesOf(message));
}

void Bridge::disconnected(web::Channel& channel, const std::string& why) {
  std::string reason =
      messages::kNoMonitor + name_ + " (" + why +
      "); retrying every second. Check that darwinop monitor is running there and allows this computer";
  Connection& connection = connections_.at(&channel);
  if (connection.gone_reason == reason) return;
  channel.discardQueued();
  channel.send(kBridgeGone, bytesOf(monitor::goneText(reason)));
  connection.gone_reason = std::move(reason);
}

}  // namespace darwinop::window
