// ssh login options of a program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace darwinop {

inline constexpr const char* kWithSsh = "With --robot tcp://USER@HOST";  // heading of the options

struct SshLogin {
  std::string port, key;
  bool new_host = false;

  [[nodiscard]] bool any() const { return !port.empty() || !key.empty() || new_host; }
};

inline void addSshLogin(CLI::App& app, SshLogin& login) {
  app.add_option("--ssh-port", login.port, "ssh port of the robot; default: ~/.ssh/config")->group(kWithSsh);
  app.add_option("--ssh-key", login.key, "ssh key file; default: ~/.ssh/config")->group(kWithSsh);
  app.add_flag("--new-host", login.new_host, "accept the host key of an unknown robot without asking")->group(kWithSsh);
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
