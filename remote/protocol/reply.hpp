// Reply of the remote-control protocol: values in the order of the request, without tags.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/sensors.hpp"
#include "remote/protocol/request.hpp"

namespace darwinop::remote {

inline constexpr std::size_t kReplyHead = 5;  // 'W' and the length (32 bits, big-endian, without the final NUL)

/// Size of the extension in bytes: tag, version, length; then flags, times and picture, sensor block, message.
inline constexpr std::size_t kExtensionHead = 6, kExtensionFigures = 13;

/// The extension in a reply to a request with an Extension.
struct ReplyExtension {
  bool real_time = true;       // false: simulated time, which stands still between requests
  bool holds_picture = false;  // the client already has the newest picture; 0 bytes are sent
  std::uint32_t held_us = 0;   // hold time at the server, from request to reply
  std::uint32_t picture = 0;   // number of the newest picture; 0: none, or black
  std::uint32_t picture_age_us = 0;
  const Sensors* seen = nullptr;  // null: no robot is connected
  /// Why the client must end; empty: it may go on. With sensors it may finish its last steps first; without, this is
  /// the last reply.
  std::string_view why_ended{};
};

/// Values in wire units.
struct Reply {
  std::array<std::int32_t, 3> accelerometer{}, gyro{};  // counts, 0..1023
  std::span<const std::uint8_t> jpeg;
  Few<std::int32_t, kJoints> positions, torques;  // 1/10000 rad, 1/10000 N m
  std::optional<ReplyExtension> extension;        // sent if requested
};

/// Writes the reply to `request` and its NUL to `bytes`, reusing its memory. Send it in one piece: a client of 2013
/// that receives the NUL alone discards the next reply.
void writeReply(const Request& request, const Reply& reply, std::vector<std::uint8_t>& bytes);

}  // namespace darwinop::remote
