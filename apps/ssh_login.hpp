// How to log in to a robot by ssh, as options of a program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace darwinop {

inline constexpr const char* kWithSsh = "With --robot tcp://USER@HOST";  // the options' heading

struct SshLogin {
  std::string port, key;
  bool new_host = false;

  [[nodiscard]] bool any() const { return !port.empty() || !key.empty() || new_host; }
};

inline void addSshLogin(CLI::App& app, SshLogin& login) {
  app.add_option("--ssh-port", login.port, "port of ssh on the robot, else as ~/.ssh/config says")->group(kWithSsh);
  app.add_option("--ssh-key", login.key, "key to log in with, else as ~/.ssh/config says")->group(kWithSsh);
  app.add_flag("--new-host", login.new_host, "accept the key of a robot that is not known yet, without asking")
      ->group(kWithSsh);
}

/// For darwinop-install.
inline std::vector<std::string> sshWords(const SshLogin& login) {
  std::vector<std::string> words;
  if (!login.port.empty()) words.insert(words.end(), {"-p", login.port});
  if (!login.key.empty()) words.insert(words.end(), {"-i", login.key});
  if (login.new_host) words.emplace_back("--new-host");
  return words;
}

}  // namespace darwinop
