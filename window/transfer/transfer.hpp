// Transfer channel: runs darwinop-install for the pages, one run at a time, visible to all pages.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/web/channel.hpp"
#include "window/transfer/remembered.hpp"
#include "window/transfer/transfer_run.hpp"
#include "window/transfer/transfer_states.hpp"

namespace darwinop::window {

inline constexpr const char* kTransferProtocol = "darwinop-transfer.1";

/// Runs in the web server's thread. A binary message is the password for the next start of that page.
class Transfer final : public web::ChannelHandler {
 public:
  using Clock = std::function<Nanos()>;
  static constexpr Nanos kLinesPause{50'000'000};  // between messages to one page
  static constexpr std::size_t kLinesBytes = std::size_t{32} * 1024;

  /// `installer`: path of darwinop-install. `given`: robot of the command line, preselected on pages.
  Transfer(std::string installer, std::filesystem::path remembered, Clock clock,
           std::optional<RobotAddress> given = std::nullopt);
  /// Cancels a run and wants_lines for its end.
  ~Transfer() override;

  void opened(web::Channel& channel) override;
  void received(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override { pages_.erase(&channel); }

  /// Sends changes to pages; call it again after pause() or earlier.
  void update();
  [[nodiscard]] Nanos pause() const;
  [[nodiscard]] bool runs() const { return window::runs(state_); }

 private:
  struct PageConnection {
    Password password{};
    bool password_rejected = false;  // the password was rejected, so the next start is rejected as well
    std::uint64_t next = 0;          // first line not sent yet
    bool wants_lines = false;        // the page has requested lines
    Nanos sent_at{0};

    void forgetPassword() noexcept {
      password.wipe();
      password_rejected = false;
    }
  };

  void start(web::Channel& channel, PageConnection& page, const TransferStart& start);
  bool poll();
  void cancel();
  void sendState();
  void sendKnown();
  void sendLines(web::Channel& channel, PageConnection& page);
  [[nodiscard]] web::Bytes stateText() const;
  [[nodiscard]] web::Bytes knownText() const;

  std::string installer_;
  Clock clock_;
  std::optional<RobotAddress> given_;
  RememberedFile remembered_;
  Console console_;
  TransferState state_ = TransferState::kIdle;
  std::unique_ptr<TransferRun> run_;  // the present or the last one
  TransferStart request_{};
  std::string sent_state_{};  // state sent last, to all pages
  std::map<web::Channel*, PageConnection> pages_;
};

}  // namespace darwinop::window
