// Messages of the window that identify a reason: for its page and its tests.
#pragma once

namespace darwinop::window::messages {

// Drive session and drive thread.
inline constexpr const char* kAnotherPageDrives = "another page drives";
inline constexpr const char* kDrivingEnded = "Driving has ended. The robot holds.";
inline constexpr const char* kTakeoverCancelled = "The takeover was cancelled. A limp robot stays limp.";
inline constexpr const char* kAnotherPageStopped = "Another page has stopped the robot. It holds.";
inline constexpr const char* kAnotherPageCancelled =
    "Another page has cancelled the takeover. A limp robot stays limp.";
inline constexpr const char* kTakesTheRobot = "Taking the robot …";
inline constexpr const char* kCompletesItsStep = "The robot completes its step …";
inline constexpr const char* kSessionEnds = "The session is ending …";
inline constexpr const char* kPreviousSessionEnds = "the previous session is still coming to rest; try again";
inline constexpr const char* kNoHeartbeat = "No heartbeat from this page for half a second. The robot holds.";
inline constexpr const char* kNoRequests = "the window's program did not respond for 0.8 s. The robot holds.";
inline constexpr const char* kNoTorque = "torque did not come on; check the servo power switch and the Faults tab";

// Of the window's program.
inline constexpr const char* kNoRuntimeYet =
    "no runtime runs here; the page shows the robot when one does. Start it with: darwinop runtime";

// Before the monitor's name and the reason.
inline constexpr const char* kNoMonitor = "no connection to the monitor at ";

// Refused requests of the motion planner.
inline constexpr const char* kMotionAborted = "aborted: the robot did not follow";
inline constexpr const char* kRobotDoesNotFollow = "the robot does not follow yet";
inline constexpr const char* kPageIsPlaying = "a motion page is playing: press again when it has ended";
inline constexpr const char* kPageRequiresAFall = "this page requires a fallen robot";
inline constexpr const char* kPageRequiresRest =
    "a page starts only when the robot stands still: it is walking or playing a page";
inline constexpr const char* kWalkRequiresTorque =
    "walking requires both arms and both legs: switch their torque on first";

// Live comparison.
inline constexpr const char* kInvalidLiveRequest =
    "the request must be {\"run\": {\"model\": NAME OR FILE, \"support\": \"clamped\" or \"floor\"}} or {\"run\": "
    "null}";

// Transfer.
inline constexpr const char* kInvalidTransferRequest =
    "the request must be a JSON object with one of start, cancel, more and forget";
inline constexpr const char* kNoControllerFolder = "choose the folder of a controller";
inline constexpr const char* kInvalidPassword = "a password must be a single line of at most 200 bytes";
inline constexpr const char* kAnotherTransferRuns =
    "another transfer is running: wait until it has ended, or cancel it";

// Doctor. Before and in the command for the robot's computer.
inline constexpr const char* kDoctorElsewhere = "The robot's port is on another computer; run there: ";
inline constexpr const char* kDoctorThere = "/opt/darwinop/current/bin/darwinop doctor";
inline constexpr const char* kNoDoctorDocument = "darwinop doctor printed no result; exit status ";
inline constexpr const char* kInvalidDoctorRequest = "the request must be {\"check\": true}";

}  // namespace darwinop::window::messages
