// Robots and controllers of last time, in a small file of the user's own. Passwords are never in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "window/transfer_words.hpp"

namespace darwinop::window {

struct Remembered {
  std::vector<RobotAddress> robots{};      // the last one used first
  std::vector<std::string> controllers{};  // folders, the last one used first
};

/// Read anew before each change: another window may have written meanwhile.
class RememberedFile {
 public:
  static constexpr std::size_t kMost = 20;  // of each

  /// `file`: empty: nothing is remembered.
  explicit RememberedFile(std::filesystem::path file);
  /// $XDG_CONFIG_HOME/darwinop/robots.json, else below ~/.config; empty: nobody knows where home is.
  [[nodiscard]] static std::filesystem::path usual();

  [[nodiscard]] const Remembered& all() const { return all_; }
  /// What went wrong with the file the last time, for the user; empty: nothing.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

  /// `controller`: empty: none was chosen.
  void note(const RobotAddress& robot, const std::string& controller);
  /// All of this user and address.
  void forget(const RobotAddress& robot);

 private:
  void read();
  void write();
  void keepAside(const std::string& why);

  std::filesystem::path file_;
  Remembered all_{};
  std::string trouble_{};
};

}  // namespace darwinop::window
