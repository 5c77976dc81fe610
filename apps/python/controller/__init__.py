"""The Webots API of a robot: from controller import Robot, Motor, Camera, Keyboard, ... (docs/python.md)."""

import os as _os

from _darwinop import *

from .absent import *
from .absent import add_getters as _add_getters
from .ansi_codes import AnsiCodes
from .robot import Robot
from .supervisor import Supervisor

_add_getters(Robot)
for _name in filter(str.isupper, dir(Keyboard)):  # names of 2013
    setattr(Robot, "KEYBOARD_" + _name, getattr(Keyboard, _name))
# Public code looks for the managers below this folder first. They are beside this package.
_os.environ.setdefault("WEBOTS_HOME", "/usr/local/webots")
