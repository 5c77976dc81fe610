// Incremental parser of replies in a byte stream.
#include "remote/protocol/reply_reader.hpp"

#include <algorithm>
#include <cstring>

#include "remote/protocol/sensor_block.hpp"

namespace darwinop::remote {
namespace {

using ReplyBytes = std::span<const std::uint8_t>;

/// After a read beyond the end, all further reads return nothing.
class ReplyCursor {
 public:
  explicit ReplyCursor(ReplyBytes bytes) : left_{bytes} {}

  [[nodiscard]] ReplyBytes take(std::size_t count) {
    if (count > left_.size()) {
      left_ = {};
      short_ = true;
      return {};
    }
    const ReplyBytes taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }
  [[nodiscard]] std::uint8_t byte() {
    const ReplyBytes taken = take(1);
    return taken.empty() ? std::uint8_t{0} : taken[0];
  }
  [[nodiscard]] std::int32_t word() {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : take(4)) value = value << 8 | byte;
    return static_cast<std::int32_t>(value);
  }
  [[nodiscard]] std::size_t left() const { return left_.size(); }
  [[nodiscard]] bool tooShort() const { return short_; }

 private:
  ReplyBytes left_;
  bool short_ = false;
};

bool readReplyExtension(ReplyCursor& whole, Reply& reply, Sensors& seen) {
  const bool ours = whole.byte() == kExtensionTag && whole.byte() == kExtensionVersion;
  ReplyCursor in{whole.take(static_cast<std::uint32_t>(whole.word()))};
  if (!ours || whole.tooShort() || whole.left() != 0) return false;
  ReplyExtension& extension = reply.extension.emplace();
  const std::uint8_t flags = in.byte();
  extension.real_time = (flags & 1) != 0;
  extension.holds_picture = (flags & 4) != 0;
  extension.held_us = static_cast<std::uint32_t>(in.word());
  extension.picture = static_cast<std::uint32_t>(in.word());
  extension.picture_age_us = static_cast<std::uint32_t>(in.word());
  if ((flags & 2) != 0) {
    const ReplyBytes block = in.take(kSensorBlock);
    if (in.tooShort()) return false;
    seen = readSensors(block);
    extension.seen = &seen;
  }
  const ReplyBytes sentence = in.take(in.left());
  extension.why_ended = {reinterpret_cast<const char*>(sentence.data()), sentence.size()};
  return !in.tooShort();
}

/// False: the content does not match the request.
bool readAnswer(ReplyBytes content, const Request& asked, Reply& reply, Sensors& seen) {
  ReplyCursor in{content};
  reply = {};
  if (asked.accelerometer)
    for (std::int32_t& axis : reply.accelerometer) axis = in.word();
  if (asked.gyro)
    for (std::int32_t& axis : reply.gyro) axis = in.word();
  if (asked.camera) reply.jpeg = in.take(static_cast<std::uint32_t>(in.word()));
  for (std::size_t i = 0; i < asked.positions.size(); ++i) (void)reply.positions.add(in.word());
  for (std::size_t i = 0; i < asked.torques.size(); ++i) (void)reply.torques.add(in.word());
  if (in.tooShort()) return false;
  if (in.left() == 0) return true;  // also from a server without the extension
  return asked.extended && readReplyExtension(in, reply, seen);
}

}  // namespace

std::size_t ReplyReader::stated() const {
  if (pending() < kReplyHead) return 0;
  std::size_t length = 0;
  for (std::size_t i = 1; i < kReplyHead; ++i) length = length << 8 | buffer_[begin_ + i];
  return length;
}

std::span<std::uint8_t> ReplyReader::room() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, pending());
  end_ -= begin_;
  begin_ = 0;
  // next() rejects longer replies.
  const std::size_t needed = std::min(stated(), kLongestReply) + 1;
  if (buffer_.size() < needed) buffer_.resize(needed);
  return std::span{buffer_}.subspan(end_);
}

ReplyReader::Result ReplyReader::next(const Request& asked, Reply& reply) {
  const auto at = buffer_.begin();
  const auto first =
      std::find(at + static_cast<std::ptrdiff_t>(begin_), at + static_cast<std::ptrdiff_t>(end_), kFirstByte);
  begin_ = static_cast<std::size_t>(first - at);
  if (pending() < kReplyHead) return Result::kIncomplete;
  const std::size_t length = stated();
  if (length < kReplyHead || length > kLongestReply) return Result::kInvalid;
  if (pending() < length) return Result::kIncomplete;
  const ReplyBytes content = ReplyBytes{buffer_}.subspan(begin_ + kReplyHead, length - kReplyHead);
  if (!readAnswer(content, asked, reply, seen_)) return Result::kInvalid;
  begin_ += length;
  return Result::kReply;
}

}  // namespace darwinop::remote
