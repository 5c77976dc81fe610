"""What the simulator's API has for devices that this robot lacks: the classes, and getters that return None."""

import _darwinop
from _darwinop import Device

_DEVICES = [
    "Altimeter", "Brake", "Compass", "Connector", "Display", "DistanceSensor", "Emitter", "GPS", "InertialUnit",
    "Lidar", "LightSensor", "LinearMotor", "Pen", "Radar", "RangeFinder", "Receiver", "Skin", "VacuumGripper",
]

__all__ = [name for name in _DEVICES if not hasattr(_darwinop, name)]

for _name in __all__:
    globals()[_name] = type(_name, (Device,), {"__doc__": "This robot has none.", "__module__": __name__})
for _name, _constants in {
    "Brake": {"ROTATIONAL": 0, "LINEAR": 1},
    "Display": {"RGB": 3, "RGBA": 4, "ARGB": 5, "BGRA": 6, "ABGR": 7},
    "DistanceSensor": {"GENERIC": 0, "INFRA_RED": 1, "SONAR": 2, "LASER": 3},
    "Emitter": {"CHANNEL_BROADCAST": -1},
    "GPS": {"LOCAL": 0, "WGS84": 1},
    "Receiver": {"CHANNEL_BROADCAST": -1},
}.items():
    for _constant, _value in _constants.items():
        setattr(globals()[_name], _constant, _value)
globals()["GPS"].convertToDegreesMinutesSeconds = staticmethod(_darwinop.degrees_minutes_seconds)


def _getter(kind):
    def get(self, name=""):
        device = self.getDevice(name)  # logs once that there is none
        return device if isinstance(device, kind) else None

    return get


def add_getters(robot):
    """Adds getGPS(name) and its siblings to the class of the robot."""
    for name in __all__:
        if not hasattr(robot, "get" + name):
            setattr(robot, "get" + name, _getter(globals()[name]))
