// Recently used robots and controllers, in a file in the user's home. It never contains passwords.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "window/transfer/transfer_message.hpp"

namespace darwinop::window {

struct Remembered {
  std::vector<RobotAddress> robots{};      // most recent first
  std::vector<std::string> controllers{};  // folders, most recent first
};

/// Read again before each change, because another window may have written it.
class RememberedFile {
 public:
  static constexpr std::size_t kMost = 20;  // of each

  /// `file`: empty: nothing is stored.
  explicit RememberedFile(std::filesystem::path file);
  /// $XDG_CONFIG_HOME/darwinop/robots.json, otherwise below ~/.config; empty: HOME is not set.
  [[nodiscard]] static std::filesystem::path usual();

  [[nodiscard]] const Remembered& all() const { return all_; }
  /// Last error of reading or writing the file, for the user; empty: none.
  [[nodiscard]] const std::string& error() const { return error_; }

  /// Moves robot and controller to the front. `controller`: empty: none.
  void note(const RobotAddress& robot, const std::string& controller);
  /// Removes all entries with this user and address.
  void forget(const RobotAddress& robot);

 private:
  void read();
  void write();
  void moveAside(const std::string& why);

  std::filesystem::path file_;
  Remembered all_{};
  std::string error_{};
};

}  // namespace darwinop::window
