// Doctor channel: runs darwinop-doctor for the pages, one run at a time, visible to all pages.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/web/channel.hpp"
#include "window/doctor/doctor_run.hpp"

namespace darwinop::window {

inline constexpr const char* kDoctorProtocol = "darwinop-doctor.1";

/// Runs in the web server's thread. The only request is {"check": true}. Each state goes to all pages:
///   {"type": "doctor", "command": "darwinop doctor", "runs": false, "elsewhere": null, "document": null, "error":
///   null}
/// `document` is that of `darwinop doctor --json` (docs/doctor.md), the last one; `error` why there is none.
class DoctorChannel final : public web::ChannelHandler {
 public:
  explicit DoctorChannel(DoctorCommand command) : command_{std::move(command)} {}

  void opened(web::Channel& channel) override;
  void received(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override { pages_.erase(&channel); }

  /// Sends changes to pages; call it again after pause() or earlier.
  void update();
  [[nodiscard]] Nanos pause() const;

 private:
  void start();
  void sendState();
  [[nodiscard]] web::Bytes stateText() const;

  DoctorCommand command_;
  std::unique_ptr<DoctorRun> run_{};  // null: none runs
  nlohmann::json document_{};
  std::string error_{};
  std::set<web::Channel*> pages_{};
};

}  // namespace darwinop::window
