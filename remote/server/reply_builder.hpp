// The values of a reply, out of a sensor image and the newest picture.
#pragma once

#include <bitset>
#include <span>

#include "core/sensors.hpp"
#include "remote/picture_source.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

/// Age in cycles from which on a value counts as old. It is answered all the same: a controller that stabilises itself
/// with a value of a tenth of a second ago fares better than with an absurd one.
inline constexpr std::uint32_t kOldAge = 4;

/// What a reply could not say truly. By joint, and the board behind them.
struct Doubts {
  static constexpr std::size_t kBoard = kJoints;
  std::bitset<kJoints + 1> old;    // the last known value was given
  std::bitset<kJoints + 1> never;  // kNoValue was given
};

/// Values that were never received are kNoValue; a sensor that does not exist is 0, as the old server answers it.
[[nodiscard]] Reply answerTo(const Request& request, const Sensors& seen, std::span<const std::uint8_t> jpeg,
                             Doubts& doubts);

/// Adds the extension's part, which looks at `seen`. A picture that the client has already is taken out.
void extend(Reply& reply, const Extension& asked, const Sensors& seen, const JpegPicture& newest, Nanos held);

}  // namespace darwinop::remote
