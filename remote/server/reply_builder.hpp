// Builds a reply from a sensor image and the newest picture.
#pragma once

#include <bitset>
#include <span>

#include "core/sensors.hpp"
#include "remote/picture_source.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

/// Values of a reply that are stale or unknown, by joint; the last bit is the board. Stale ones are sent nevertheless:
/// a balance controller works better with a value that is 0.1 s old than with kNoValue.
struct StaleValues {
  static constexpr std::size_t kBoard = kJoints;
  std::bitset<kJoints + 1> old;    // the last known value was sent
  std::bitset<kJoints + 1> never;  // kNoValue was sent
};

/// Values never received are kNoValue; a sensor that does not exist is 0, as in the 2013 server.
[[nodiscard]] Reply makeReply(const Request& request, const Sensors& seen, std::span<const std::uint8_t> jpeg,
                              StaleValues& stale);

/// Adds the extension, which refers to `seen`. Removes a picture that the client already has.
void addExtension(Reply& reply, const Extension& request, const Sensors& seen, const JpegPicture& newest, Nanos held);

}  // namespace darwinop::remote
