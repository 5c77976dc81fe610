#include "hal/diagnostics.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>

namespace darwinop {
namespace {

/// A pipe that polls writable accepts PIPE_BUF (one page) without blocking.
constexpr std::size_t kAtOnce = 4096;

bool hasRoom(int fd) noexcept {
  pollfd asked{fd, POLLOUT, 0};
  return poll(&asked, 1, 0) == 1;
}

}  // namespace

bool writeWithoutWaiting(int fd, std::string_view text) noexcept {
  const int error = errno;
  bool written = true;
  while (!text.empty() && written) {
    const ssize_t count = hasRoom(fd) ? write(fd, text.data(), std::min(text.size(), kAtOnce)) : -1;
    written = count > 0;
    if (written) text.remove_prefix(static_cast<std::size_t>(count));
  }
  errno = error;
  return written;
}

NeverWaitingBuffer::int_type NeverWaitingBuffer::overflow(int_type letter) {
  const char text = traits_type::to_char_type(letter);
  if (!traits_type::eq_int_type(letter, traits_type::eof())) (void)xsputn(&text, 1);
  return traits_type::not_eof(letter);
}

/// Always reports success: after one failure, iostreams would stay in the failed state.
std::streamsize NeverWaitingBuffer::xsputn(const char* text, std::streamsize count) {
  if (dropped_) dropped_ = !writeWithoutWaiting(fd_, kMessagesDropped);
  if (!dropped_) dropped_ = !writeWithoutWaiting(fd_, {text, static_cast<std::size_t>(count)});
  return count;
}

DiagnosticsOutput::DiagnosticsOutput()
    : error_before_{std::cerr.rdbuf(&error_)}, output_before_{std::cout.rdbuf(&output_)} {}

DiagnosticsOutput::~DiagnosticsOutput() {
  std::cout.rdbuf(output_before_);
  std::cerr.rdbuf(error_before_);
}

}  // namespace darwinop
