// Non-blocking diagnostic output: a program with real-time work must not block on a full pipe or a stopped terminal.
#pragma once

#include <cstddef>
#include <streambuf>
#include <string_view>

namespace darwinop {

/// Printed where text is missing.
inline constexpr std::string_view kMessagesDropped = "(messages were dropped here: the output was not read)\n";

/// Writes what fits at once; returns false if text was dropped (full pipe, stopped terminal, closed reader). SIGPIPE
/// must be ignored (hal/signals.hpp).
bool writeWithoutWaiting(int fd, std::string_view text) noexcept;

/// A stream buffer that never blocks. After dropped text it prints a notice as soon as there is room.
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

/// std::cerr and std::cout do not block during the lifetime of this object.
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
