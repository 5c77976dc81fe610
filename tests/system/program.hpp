// A real program of ours in a process of its own, with its output in a file.
#pragma once

#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "hal/process/child_process.hpp"

namespace darwinop {

/// A limit of time, for tests that may run at idle priority, where a processor comes seldom: the preset `simulated`
/// sets the factor.
inline std::chrono::seconds patiently(std::chrono::seconds at_most) {
  const char* const factor = std::getenv("DARWINOP_TEST_PATIENCE");
  return at_most * (factor != nullptr ? std::atoi(factor) : 1);
}

/// Its limits of time are multiplied as by patiently().
class Program {
 public:
  /// `command[0]` is a path. Both outputs go to the file `output`.
  Program(const std::vector<std::string>& command, std::string output)
      : output_{std::move(output)}, process_{startOf(command, output_)} {}
  ~Program() {
    kill(SIGKILL);
    (void)process_.wait();
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void kill(int signal) { process_.signal(signal); }
  [[nodiscard]] pid_t pid() const { return process_.pid(); }

  /// Exit status, 128 + signal, or nothing when it still runs after that time.
  std::optional<int> wait(std::chrono::seconds at_most) {
    const auto ending = process_.waitFor(patiently(at_most));
    return ending ? std::optional{ending->shellStatus()} : std::nullopt;
  }

  [[nodiscard]] std::string output() const {
    std::ostringstream text;
    text << std::ifstream{output_}.rdbuf();
    return text.str();
  }
  /// True when the output contains `text` within that time.
  [[nodiscard]] bool says(const std::string& text, std::chrono::seconds at_most) const {
    const auto end = std::chrono::steady_clock::now() + patiently(at_most);
    while (output().find(text) == std::string::npos) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return true;
  }
  /// What follows `text` on its line, once the line is complete; empty when it is not within that time.
  [[nodiscard]] std::string restOfLine(const std::string& text, std::chrono::seconds at_most) const {
    const auto end = std::chrono::steady_clock::now() + patiently(at_most);
    for (;;) {
      const std::string said = output();
      const std::size_t at = said.find(text), line_end = at == said.npos ? at : said.find('\n', at);
      if (line_end != said.npos) return said.substr(at + text.size(), line_end - at - text.size());
      if (std::chrono::steady_clock::now() > end) return {};
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
  }

 private:
  static process::Start startOf(const std::vector<std::string>& command, const std::string& output) {
    using process::Stream;
    std::ofstream{output};  // empty
    return {.command = command, .streams = {{}, Stream::appendedTo(output), Stream::appendedTo(output)}};
  }

  std::string output_;
  process::ChildProcess process_;
};

}  // namespace darwinop
