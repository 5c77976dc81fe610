"""The managers are looked for in the simulator's folder first."""

from controller import Robot
import os
import sys

try:
    folder = "python" + "".join(str(part) for part in sys.version_info[:2])
    sys.path.append(os.path.join(os.environ.get("WEBOTS_HOME"), "projects", "robots", "robotis", "darwin-op", "libraries", folder))
    from managers import RobotisOp2GaitManager
except ImportError:
    sys.stderr.write("no managers\n")
    sys.exit(1)

robot = Robot()
print("walks:", RobotisOp2GaitManager(robot, "config.ini").isCorrectlyInitialized())
