// Messages of the server, or the parts that identify them.
#pragma once

namespace darwinop::remote::messages {

inline constexpr const char* kNoPassword =
    "the protocol has no password: every allowed address can move the robot and read its camera, and traffic can be "
    "read and changed on the way. In a shared network, listen on loopback and connect through ssh";

// After the client's name.
inline constexpr const char* kDrives = " drives; other clients are refused until it ends";
inline constexpr const char* kDisconnected = "has disconnected";
inline constexpr const char* kSessionEnded = "has ended its session";
inline constexpr const char* kOtherProtocol =
    "was disconnected: it uses another protocol; its first byte does not start a request";
inline constexpr const char* kSkippedBytes = ": skipped bytes that do not start a request";
inline constexpr const char* kUnknownSection = "received unknown message: byte ";
inline constexpr const char* kNoPictures = " requests pictures, but there are none: ";
inline constexpr const char* kUnknownJoints = "sends 0 for joints above 19, which do not exist";

// Why a client must end.
inline constexpr const char* kServerEnds = "the server was requested to end; start it again with: darwinop remote";

// Why a session is not resumed.
inline constexpr const char* kTorqueSwitchedOff =
    "torque has been switched off in the meantime, at rest or by hand; start the controller again";

// After a device's name.
inline constexpr const char* kNeverAnswered = " has never answered: its values are sent as -2147483648 (unknown)";
inline constexpr const char* kAnsweredLongAgo =
    " has not answered for more than 3 cycles: its last known values are sent";

}  // namespace darwinop::remote::messages
