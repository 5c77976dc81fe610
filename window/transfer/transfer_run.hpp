// One run of darwinop-install: output, progress and result.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "window/child.hpp"
#include "window/transfer/console.hpp"
#include "window/transfer/installer_step.hpp"
#include "window/transfer/line_splitter.hpp"
#include "window/transfer/password.hpp"

namespace darwinop::window {

class TransferRun {
 public:
  /// Bytes read from each stream per poll: endless output must not block the thread.
  static constexpr std::size_t kMaxBytesAtOnce = std::size_t{32} * 1024;

  /// `installer`: its path. Wipes `password`. Throws std::runtime_error.
  TransferRun(const std::string& installer, const std::vector<std::string>& arguments, Password& password,
              Console& console);

  /// Reads available output, non-blocking. True: something is new.
  bool poll();
  /// Like Ctrl-C: the installer completes or rolls back its work.
  void interrupt() { child_.interrupt(); }

  [[nodiscard]] const std::optional<InstallerStep>& step() const { return step_; }
  /// Fingerprint of an unknown host.
  [[nodiscard]] const std::string& hostKey() const { return host_key_; }
  /// Exit status, after all output has been read.
  [[nodiscard]] std::optional<int> status() const { return status_; }
  /// Last error or message of the installer.
  [[nodiscard]] const std::string& summary() const { return error_.empty() ? message_ : error_; }

 private:
  bool readStream(std::size_t stream);
  void takeLine(std::size_t stream, std::string_view line);
  void takeProgress(std::string_view line);

  Console& console_;
  Child child_;
  std::array<LineSplitter, Child::kStreams> splitters_{};
  std::optional<InstallerStep> step_{};
  std::string host_key_{}, message_{}, error_{};
  LineKind stderr_kind_ = LineKind::kMessage;  // kind of the last line of stderr
  std::optional<int> status_{};
};

}  // namespace darwinop::window
