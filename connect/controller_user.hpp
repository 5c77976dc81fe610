// Who drives on a robot: controllers, the remote server and the monitor run as a user without rights of root, whose
// group may use the runtime. docs/run-on-the-robot.md has the table.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "connect/robot_file.hpp"
#include "runtime/users.hpp"

namespace darwinop::connect {

/// User and group that the installer makes. Where robot.ini names no other, these are meant, if they exist.
inline constexpr const char* kControllerUser = "darwinop";

/// Group whose members may use the runtime; `asked`, of a command line, comes before robot.ini. gid_t(-1): none. Throws
/// std::runtime_error when a group that was named does not exist.
gid_t runtimeGroup(const RobotFile& robot, const std::optional<std::string>& asked = std::nullopt,
                   const runtime::UserFiles& files = {});

/// Empty: robot.ini says root, or it names nobody and there is no user darwinop. Throws std::runtime_error when the
/// user that it names does not exist.
std::optional<process::Account> controllerAccount(const RobotFile& robot, const runtime::UserFiles& files = {});

/// The same for what is started at boot, where nobody asked for rights of root: without a user it throws, unless
/// robot.ini says root.
std::optional<process::Account> defaultControllerAccount(const RobotFile& robot, const runtime::UserFiles& files = {});

/// For a program that uses the runtime: when root has started it, it goes on as the user of controllers, if there is
/// one.
void leaveRoot();

/// A controller for `setting` (as DARWINOP_ROBOT; may be empty) will use the runtime of this computer.
bool usesRuntime(const std::string& setting);

}  // namespace darwinop::connect
