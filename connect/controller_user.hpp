// User account of controllers, remote server and monitor: not root; its group may use the runtime. Table in
// docs/run-on-the-robot.md.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "connect/robot_file.hpp"
#include "runtime/users.hpp"

namespace darwinop::connect {

/// User and group that the installer creates: the default if robot.ini names no other, if they exist.
inline constexpr const char* kControllerUser = "darwinop";

/// Group whose members may use the runtime. `asked`: from the command line; takes precedence over robot.ini. gid_t(-1):
/// none. Throws std::runtime_error if a configured group does not exist.
gid_t runtimeGroup(const RobotFile& robot, const std::optional<std::string>& asked = std::nullopt,
                   const runtime::UserFiles& files = {});

/// Account of robot.ini, else of kControllerUser. Empty: robot.ini has `root`, or the default user does not exist.
/// Throws std::runtime_error if the user of robot.ini does not exist.
std::optional<process::Account> controllerAccount(const RobotFile& robot, const runtime::UserFiles& files = {});

/// The same for programs started at boot, which must not run as root by accident: throws if there is no user, unless
/// robot.ini has `root`.
std::optional<process::Account> defaultControllerAccount(const RobotFile& robot, const runtime::UserFiles& files = {});

/// For programs that use the runtime: if started by root, switches to the controllers' account, if there is one.
void leaveRoot();

/// True if a controller with this `setting` (as DARWINOP_ROBOT; may be empty) uses the runtime of this computer.
bool usesRuntime(const std::string& setting);

}  // namespace darwinop::connect
