// Messages to a person, by a program that must go on whether somebody reads them or not.
#pragma once

#include <cstddef>
#include <streambuf>
#include <string_view>

namespace darwinop {

/// Writes what fits at once. Text that a full pipe or a stopped terminal does not take is dropped: false. A pipe
/// without a reader takes nothing either; SIGPIPE must be ignored (hal/signals.hpp).
bool writeWithoutWaiting(int fd, std::string_view text) noexcept;

/// A stream's buffer that never waits. After text was dropped it says so as soon as there is room again.
class NeverWaitingBuffer final : public std::streambuf {
 public:
  explicit NeverWaitingBuffer(int fd) : fd_{fd} {}

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;

 private:
  int fd_;
  bool dropped_ = false;
};

/// std::cerr and std::cout never wait as long as this lives.
class DiagnosticsOutput {
 public:
  DiagnosticsOutput();
  ~DiagnosticsOutput();
  DiagnosticsOutput(const DiagnosticsOutput&) = delete;
  DiagnosticsOutput& operator=(const DiagnosticsOutput&) = delete;

 private:
  NeverWaitingBuffer error_{2}, output_{1};
  std::streambuf *error_before_, *output_before_;
};

}  // namespace darwinop
