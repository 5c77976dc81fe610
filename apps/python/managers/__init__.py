"""Gait, motion and vision managers of the ROBOTIS OP2 and the DARwIn-OP (docs/python.md)."""

from _darwinop import (
    DARwInOPDirectoryManager,
    DARwInOPGaitManager,
    DARwInOPMotionManager,
    DARwInOPMotionTimerManager,
    DARwInOPVisionManager,
    RobotisOp2DirectoryManager,
    RobotisOp2GaitManager,
    RobotisOp2MotionManager,
    RobotisOp2MotionTimerManager,
    RobotisOp2VisionManager,
)
