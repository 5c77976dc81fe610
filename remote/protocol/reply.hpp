// A reply: values in the order in which they were asked for, without tags.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "remote/protocol/request.hpp"

namespace darwinop::remote {

inline constexpr std::size_t kReplyHead = 5;  // 'W' and the length, 32 bits, big-endian, without the NUL at the end

/// Numbers as on the wire.
struct Reply {
  std::array<std::int32_t, 3> accelerometer{}, gyro{};  // counts, 0..1023
  std::span<const std::uint8_t> jpeg;
  Few<std::int32_t, kJoints> positions, torques;  // 1/10000 rad, 1/10000 N m
};

/// Puts the reply to `request` and its NUL into `bytes`, whose memory is used again: it has to leave in one piece, as a
/// client of 2013 that meets the NUL alone throws the next reply away.
void writeReply(const Request& request, const Reply& reply, std::vector<std::uint8_t>& bytes);

}  // namespace darwinop::remote
