// Converts a reply of the 2013 protocol, without the extension, to a sensor image.
#pragma once

#include "core/sensors.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

/// Requests all sensor values except a picture.
void requestAllSensors(Request& request);

/// Stores the values of a reply to requestAllSensors() in `seen`. Buttons, voltages, temperatures, velocities and
/// faults stay unknown. The state becomes kDriven, because such a server replies only while its robot is driven.
void takeLegacyReply(const Reply& reply, Sensors& seen);

}  // namespace darwinop::remote
