// Child process: another darwinop program that ends with this one.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "hal/process/child_process.hpp"

namespace darwinop::window {

class Child {
 public:
  /// kBackground: stdout is discarded, stderr is kept. kTerminal: shares our terminal. kCaptured: all output is read
  /// through stream(); without a terminal.
  enum class Stdio { kBackground, kTerminal, kCaptured };
  /// File descriptors 1, 2 and 3 of a captured child; 3 is for machine-readable output.
  static constexpr std::size_t kStreams = 3;

  /// `noun`: "runtime" starts darwinop-runtime from this program's folder. `grace`: time it gets to end before SIGKILL.
  /// `environment`: "NAME=value", added to ours. Throws std::runtime_error.
  Child(const std::string& noun, const std::vector<std::string>& arguments, std::chrono::milliseconds grace,
        Stdio stdio = Stdio::kBackground, std::vector<std::string> environment = {})
      : Child{noun, programOf(noun), arguments, grace, stdio, nullptr, std::move(environment)} {}
  /// `secret`: "NAME=value" added to its environment; null: none. Our DARWINOP_PASSWORD is not passed on.
  Child(std::string noun, const std::string& program, const std::vector<std::string>& arguments,
        std::chrono::milliseconds grace, Stdio stdio, char* secret, std::vector<std::string> environment = {});
  /// Sends SIGTERM, waits, then SIGKILL. A captured child gets SIGINT with its whole process group.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// SIGINT to its process group, like Ctrl-C in a terminal.
  void interrupt() { process_.signalGroup(SIGINT); }
  /// Descriptor to read its output from, non-blocking; -1: not captured.
  [[nodiscard]] int stream(std::size_t number) const { return process_.stream(number + 1); }
  /// Exit status as in a shell; nullopt: still running.
  std::optional<int> ended();
  [[nodiscard]] const std::string& noun() const { return noun_; }

  /// Path of the program in this program's folder, whether or not it exists.
  [[nodiscard]] static std::string programOf(const std::string& noun) {
    return process::programBeside("darwinop-" + noun);
  }

 private:
  std::string noun_;
  std::chrono::milliseconds grace_;
  Stdio stdio_;
  process::ChildProcess process_;
};

}  // namespace darwinop::window
