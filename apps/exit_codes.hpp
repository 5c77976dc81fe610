// Exit codes of darwinop experiment, motion, demo and gap record; docs/experiments.md and docs/motion-command.md list
// them for users. Of other programs kWrong, for arguments, and kFailed.
#pragma once

namespace darwinop::app {

inline constexpr int kDone = 0;
/// It began, and did not end as asked: ended by the robot, a fall, an incomplete recording, findings.
inline constexpr int kFailed = 1;
/// Nothing has begun: arguments, files, or a robot that cannot be opened.
inline constexpr int kWrong = 2;
inline constexpr int kNeedsYes = 3;
inline constexpr int kStopped = 130;  // by Ctrl-C or another signal that asks for the end

}  // namespace darwinop::app
