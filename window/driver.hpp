// Steering from the page: one page at a time drives, as a controller does, and only while it is heard.
#pragma once

#include <functional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/web/channel.hpp"
#include "window/helm.hpp"
#include "window/steering_words.hpp"

namespace darwinop::window {

inline constexpr const char* kSteeringProtocol = "darwinop-steering.1";

/// One thread: the web server's. Safety judges every goal, as it does a controller's.
class Driver final : public web::ChannelUser {
 public:
  using Clock = std::function<Nanos()>;
  /// A page that is not heard for so long has gone: closed, asleep, or behind a cut network. It speaks ten times a
  /// second.
  static constexpr Nanos kPatience{500'000'000};

  Driver(Helm& helm, Clock clock) : helm_{helm}, clock_{std::move(clock)} {}
  /// Who drives lets go.
  ~Driver() override;

  void opened(web::Channel& channel) override;
  void said(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override;

  /// Passes on what was said, or lets go. To be called every cycle, or nearly.
  void turn();
  [[nodiscard]] bool drives() const { return driver_ != nullptr; }

 private:
  void take(web::Channel& channel);
  void tellDoings(const Doings& doings);
  void letGo(const std::string& why);

  Helm& helm_;
  Clock clock_;
  web::Channel* driver_ = nullptr;  // or who wants to be it
  bool at_helm_ = false;            // it drives
  Nanos heard_{0};
  Orders orders_{};  // since the last turn
  Doings told_{};
};

}  // namespace darwinop::window
