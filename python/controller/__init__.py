"""The Webots API of a robot: from controller import Robot, Motor, Camera, Keyboard, ... (docs/python.md)."""

from _darwinop import *
from _darwinop import Reading as _Reading  # not offered

from .absent import *
from .robot import Robot, Supervisor
