// Incremental parser of replies in a byte stream.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sensors.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

inline constexpr std::size_t kLongestReply = 300'000;  // limit of the 2013 clients; a picture has about 12,000 bytes

class ReplyReader {
 public:
  enum class Result : std::uint8_t {
    kIncomplete,  // more bytes are needed
    kReply,
    kInvalid  // too long or not matching the request: the stream is out of sync, stop reading
  };

  /// Buffer for the next read; report its size with filled(). Not empty after next() has returned kIncomplete.
  [[nodiscard]] std::span<std::uint8_t> room();
  void filled(std::size_t count) { end_ += count; }

  /// Parses the next complete reply to `asked`; skips bytes before its 'W'. Picture, message and sensors are valid
  /// until the
  /// next call of room().
  [[nodiscard]] Result next(const Request& asked, Reply& reply);

  [[nodiscard]] std::size_t pending() const { return end_ - begin_; }
  void forget() { begin_ = end_ = 0; }

 private:
  [[nodiscard]] std::size_t stated() const;  // length of the present reply; 0: not known yet

  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(4096);
  std::size_t begin_ = 0, end_ = 0;
  Sensors seen_{};
};

}  // namespace darwinop::remote
