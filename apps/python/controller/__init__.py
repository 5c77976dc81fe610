"""The Webots API of a robot: from controller import Robot, Motor, Camera, Keyboard, ... (docs/python.md)."""

from _darwinop import *

from .absent import *
from .absent import add_getters as _add_getters
from .ansi_codes import AnsiCodes
from .robot import Robot
from .supervisor import Supervisor

_add_getters(Robot)
