// Messages of the client, or the parts that identify them.
#pragma once

namespace darwinop::remote::messages {

// Connection. Before some of them the server's name, after some of them a time or a reason.
inline constexpr const char* kNoServer =
    ". Start `darwinop remote` there, with --listen and --allow for this computer. It also refuses connections while "
    "another client drives";
inline constexpr const char* kInvalidReply = "the reply is not valid; check that the port is that of darwinop remote";
inline constexpr const char* kNoReplyFor = "no reply for ";
inline constexpr const char* kConnectionLost = " is lost (";
inline constexpr const char* kConnectedAgain = " is connected again; the robot continues from its present position";
inline constexpr const char* kNotRestored = " ago and could not be restored: ";

// Speed of the network.
inline constexpr const char* kNetworkTooSlow = "the link to the robot is too slow for steps of ";
inline constexpr const char* kSizeFits = " would fit: start the server with darwinop remote ";

// Pictures.
inline constexpr const char* kRobotsCameraIsBlind =
    "Camera: every picture is black: the robot's camera gives no pictures; see the log of its server";

}  // namespace darwinop::remote::messages
