// Replies out of a stream of bytes, however it is cut into pieces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sensors.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

inline constexpr std::size_t kLongestReply = 300'000;  // what historic clients take; a picture has some 12,000 bytes

class ReplyReader {
 public:
  enum class Found : std::uint8_t {
    kNothing,  // more bytes are needed
    kReply,
    kRefused  // too long, or not what was asked for: nothing behind it can be trusted, and nothing more is read
  };

  /// Room for bytes to come; `filled` of them are there then. Never empty once next() has found nothing.
  [[nodiscard]] std::span<std::uint8_t> room();
  void filled(std::size_t count) { end_ += count; }

  /// The next whole reply, read as the answer to `asked`; what lies before its 'W' is skipped. Its picture, sentence
  /// and sensors stay until the next call of room().
  [[nodiscard]] Found next(const Request& asked, Reply& reply);

  [[nodiscard]] std::size_t pending() const { return end_ - begin_; }
  void forget() { begin_ = end_ = 0; }

 private:
  [[nodiscard]] std::size_t stated() const;  // length of the reply under way; 0: not known yet

  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(4096);
  std::size_t begin_ = 0, end_ = 0;
  Sensors seen_{};
};

}  // namespace darwinop::remote
