// A sensor image out of a reply without the extension's part: what the words of 2013 can tell.
#pragma once

#include "core/sensors.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

/// Asks for all that there is, but a picture.
void askForAll(Request& request);

/// `seen` gets the values of a reply to askForAll(). Buttons, voltages, temperatures, velocities and faults stay
/// unknown; such a server answers only when its robot is driven.
void takeOldReply(const Reply& reply, Sensors& seen);

}  // namespace darwinop::remote
