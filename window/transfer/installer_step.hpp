// Parser of darwinop-install's machine-readable output on file descriptor 3, see installer/pc/progress.sh.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace darwinop::window {

struct InstallerStep {
  int number = 0, of = 0;
  std::optional<double> part;  // completed fraction, 0 to 1; nullopt: unknown
  std::string name;
  bool operator==(const InstallerStep&) const = default;
};

/// "progress 4 5 0.420 sending 4312 kB"
[[nodiscard]] std::optional<InstallerStep> readStep(std::string_view line);
/// Fingerprint of "host-key SHA256:…"; empty: another line.
[[nodiscard]] std::string_view readHostKey(std::string_view line);
/// SHA256 as printed by ssh: exactly 43 base64 characters.
[[nodiscard]] bool isFingerprint(std::string_view text);

}  // namespace darwinop::window
