// Incremental parser of requests in a byte stream.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "remote/protocol/request.hpp"

namespace darwinop::remote {

class RequestReader {
 public:
  enum class Result : std::uint8_t {
    kIncomplete,  // more bytes are needed
    kRequest,
    kInvalid  // invalid length: the stream is out of sync, stop reading
  };

  /// Buffer for the next read; report its size with filled(). Not empty after next() has returned kIncomplete.
  [[nodiscard]] std::span<std::uint8_t> room();
  void filled(std::size_t count) { end_ += count; }

  /// Parses the next complete request. Skips and counts bytes before a 'W'.
  [[nodiscard]] Result next(Request& request, RequestIssues& issues);

  [[nodiscard]] std::size_t garbageBytes() const { return garbage_; }
  [[nodiscard]] std::size_t pending() const { return end_ - begin_; }

 private:
  std::array<std::uint8_t, kMostStated> buffer_{};
  std::size_t begin_ = 0, end_ = 0, garbage_ = 0;
};

/// Parses the sections of a request: the bytes after the header, with or without the NUL.
void readSections(std::span<const std::uint8_t> sections, Request& request, RequestIssues& issues);

}  // namespace darwinop::remote
