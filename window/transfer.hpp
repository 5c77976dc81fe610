// The transfer channel: pages have the installer do something to a robot, one thing at a time, and all of them see it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/web/channel.hpp"
#include "window/remembered.hpp"
#include "window/transfer_run.hpp"

namespace darwinop::window {

inline constexpr const char* kTransferProtocol = "darwinop-transfer.1";

/// One thread: the web server's. A binary message is the password for the next start of that page.
class Transfer final : public web::ChannelUser {
 public:
  using Clock = std::function<Nanos()>;
  static constexpr Nanos kLinesPause{50'000'000};  // of one page: twenty messages a second are enough to read
  static constexpr std::size_t kLinesBytes = std::size_t{32} * 1024;

  /// `installer`: path of darwinop-install. `given`: the robot that this window was started for, which pages begin
  /// with.
  Transfer(std::string installer, std::filesystem::path remembered, Clock clock,
           std::optional<RobotAddress> given = std::nullopt);
  /// What runs is cancelled and waited for.
  ~Transfer() override;

  void opened(web::Channel& channel) override;
  void said(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override { pages_.erase(&channel); }

  /// Tells pages what is new. To be called again after pause(), or earlier.
  void turn();
  [[nodiscard]] Nanos pause() const;
  [[nodiscard]] bool runs() const { return run_ != nullptr && !run_->status(); }

 private:
  struct Page {
    Password password{};
    bool no_password = false;  // it was refused, so that the start that it was for is refused, too
    std::uint64_t next = 0;    // line that it has not got
    bool waits = false;        // it has asked for lines
    Nanos told{0};

    void forgetPassword() noexcept {
      password.wipe();
      no_password = false;
    }
  };

  void start(web::Channel& channel, Page& page, const TransferStart& start);
  void tellState();
  void tellKnown();
  void tellLines(web::Channel& channel, Page& page);
  [[nodiscard]] web::Bytes stateText() const;
  [[nodiscard]] web::Bytes knownText() const;

  std::string installer_;
  Clock clock_;
  std::optional<RobotAddress> given_;
  RememberedFile remembered_;
  Console console_;
  std::unique_ptr<TransferRun> run_;
  TransferStart doing_{};
  std::string told_{};  // of the state, to all pages
  std::map<web::Channel*, Page> pages_;
};

}  // namespace darwinop::window
