// One run of darwinop-install: what it says, how far it is, how it ends.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "window/child.hpp"
#include "window/console.hpp"
#include "window/installer_step.hpp"
#include "window/line_cutter.hpp"
#include "window/password.hpp"

namespace darwinop::window {

class TransferRun {
 public:
  /// So much is read of each stream at a look: a controller that prints without end delays nobody.
  static constexpr std::size_t kMostAtOnce = std::size_t{32} * 1024;

  /// `installer`: its path. `password` is wiped. Throws std::runtime_error.
  TransferRun(const std::string& installer, const std::vector<std::string>& words, Password& password,
              Console& console);

  /// Takes what has come, without waiting. true: something is new.
  bool look();
  /// As Ctrl-C, once: the installer then completes or undoes what it has begun, by itself.
  void cancel();

  [[nodiscard]] bool cancelled() const { return cancelled_; }
  [[nodiscard]] const std::optional<InstallerStep>& step() const { return step_; }
  /// Of a robot that is not known yet.
  [[nodiscard]] const std::string& hostKey() const { return host_key_; }
  /// Exit status, when all that it said has been taken.
  [[nodiscard]] std::optional<int> status() const { return status_; }
  /// The installer's last word: what went wrong, or what was done.
  [[nodiscard]] const std::string& sentence() const { return error_.empty() ? said_ : error_; }

 private:
  bool take(std::size_t stream);
  void takeLine(std::size_t stream, std::string_view line);
  void takeNews(std::string_view line);

  Console& console_;
  Child child_;
  std::array<LineCutter, Child::kStreams> cutters_{};
  std::optional<InstallerStep> step_{};
  std::string host_key_{}, said_{}, error_{};
  LineKind complaint_ = LineKind::kSaid;  // of the last line of stderr
  bool cancelled_ = false;
  std::optional<int> status_{};
};

}  // namespace darwinop::window
