// A reply: values in the order in which they were asked for, without tags.
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

inline constexpr std::size_t kReplyHead = 5;  // 'W' and the length, 32 bits, big-endian, without the NUL at the end

/// Bytes of the extension's part: tag, version, length; then flags, times and picture, the sensors, a sentence.
inline constexpr std::size_t kExtensionHead = 6, kExtensionFigures = 13;

/// The part of a reply to a request with an Extension.
struct ReplyExtension {
  bool real_time = true;       // false: simulated time, which stands still between two requests
  bool holds_picture = false;  // the client has the newest one; it has 0 bytes here
  std::uint32_t held_us = 0;   // from the request to this reply, at the server
  std::uint32_t picture = 0;   // number of the newest one; 0: none, or a black one
  std::uint32_t picture_age_us = 0;
  const Sensors* seen = nullptr;  // null: there is no robot to see
  std::string_view why_ended{};   // a sentence: this is the last reply; empty: it is not
};

/// Numbers as on the wire.
struct Reply {
  std::array<std::int32_t, 3> accelerometer{}, gyro{};  // counts, 0..1023
  std::span<const std::uint8_t> jpeg;
  Few<std::int32_t, kJoints> positions, torques;  // 1/10000 rad, 1/10000 N m
  std::optional<ReplyExtension> extension;        // sent when it was asked for
};

/// Puts the reply to `request` and its NUL into `bytes`, whose memory is used again: it has to leave in one piece, as a
/// client of 2013 that meets the NUL alone throws the next reply away.
void writeReply(const Request& request, const Reply& reply, std::vector<std::uint8_t>& bytes);

}  // namespace darwinop::remote
