"""Classes of the simulator's API for devices that this robot does not have: Robot.getDevice() returns None for them."""

from _darwinop import Device

__all__ = [
    "Altimeter", "Brake", "Compass", "Connector", "Display", "DistanceSensor", "Emitter", "GPS", "InertialUnit",
    "Joystick", "Lidar", "LightSensor", "LinearMotor", "Mouse", "Pen", "Radar", "RangeFinder", "Receiver", "Skin",
    "VacuumGripper",
]

for _name in __all__:
    globals()[_name] = type(_name, (Device,), {"__doc__": "This robot has none.", "__module__": __name__})
