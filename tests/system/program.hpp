// A real program of ours in a process of its own, with its output in a file.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

namespace darwinop {

class Program {
 public:
  /// `command[0]` is a path. Both outputs go to the file `output`.
  Program(const std::vector<std::string>& command, std::string output) : output_{std::move(output)} {
    std::vector<char*> argv;
    for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    const int failed = posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error("cannot start " + command[0]);
  }
  ~Program() {
    if (pid_ <= 0) return;
    kill(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void kill(int signal) const {
    if (pid_ > 0) ::kill(pid_, signal);
  }
  [[nodiscard]] pid_t pid() const { return pid_; }

  /// Exit status, 128 + signal, or nothing when it still runs after that time.
  std::optional<int> wait(std::chrono::seconds at_most) {
    const auto end = std::chrono::steady_clock::now() + at_most;
    do {
      int status = 0;
      if (waitpid(pid_, &status, WNOHANG) == pid_) {
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    } while (std::chrono::steady_clock::now() < end);
    return std::nullopt;
  }

  [[nodiscard]] std::string output() const {
    std::ostringstream text;
    text << std::ifstream{output_}.rdbuf();
    return text.str();
  }
  /// True when the output contains `text` within that time.
  [[nodiscard]] bool says(const std::string& text, std::chrono::seconds at_most) const {
    const auto end = std::chrono::steady_clock::now() + at_most;
    while (output().find(text) == std::string::npos) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return true;
  }

 private:
  std::string output_;
  pid_t pid_ = -1;
};

}  // namespace darwinop
