// Requests out of a stream of bytes, however it is cut into pieces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "remote/protocol/request.hpp"

namespace darwinop::remote {

class RequestReader {
 public:
  enum class Found : std::uint8_t {
    kNothing,  // more bytes are needed
    kRequest,
    kRefused  // a length that no request has: nothing behind it can be trusted, and nothing more is read
  };

  /// Room for bytes to come; `filled` of them are there then. Never empty once next() has found nothing.
  [[nodiscard]] std::span<std::uint8_t> room();
  void filled(std::size_t count) { end_ += count; }

  /// The next whole request. Bytes before a 'W' are skipped and counted.
  [[nodiscard]] Found next(Request& request, Oddities& oddities);

  [[nodiscard]] std::size_t garbageBytes() const { return garbage_; }
  [[nodiscard]] std::size_t pending() const { return end_ - begin_; }

 private:
  std::array<std::uint8_t, kMostStated> buffer_{};
  std::size_t begin_ = 0, end_ = 0, garbage_ = 0;
};

/// The sections of a request: what lies behind the head, with or without its NUL.
void readSections(std::span<const std::uint8_t> sections, Request& request, Oddities& oddities);

}  // namespace darwinop::remote
