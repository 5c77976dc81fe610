"""What the simulator's API has for devices that this robot lacks: the classes, and getters that return None."""

from math import nan

import _darwinop

_VECTOR, _QUATERNION, _EMPTY = (nan,) * 3, (nan,) * 4, ()
_SIZES = "getWidth getHeight"
_RANGES = "getMinRange getMaxRange"
_TABLE = ((_EMPTY, "getLookupTable"), (0, "getLookupTableSize"))

# Sensors, and what each of their calls returns here, as in C++; tuples become lists. A getter with an argument is not a
# property.
_SENSORS = {
    "Altimeter": [(nan, "getValue")],
    "Compass": [(_VECTOR, "getValues"), *_TABLE],
    "DistanceSensor": [(nan, "getValue getMinValue getMaxValue getAperture"), (0, "getType"), *_TABLE],
    "GPS": [(_VECTOR, "getValues getSpeedVector"), (nan, "getSpeed"), (0, "getCoordinateSystem")],
    "InertialUnit": [(_VECTOR, "getRollPitchYaw"), (_QUATERNION, "getQuaternion"), (nan, "getNoise"), *_TABLE],
    "Lidar": [
        (None, "enablePointCloud disablePointCloud setFrequency getRangeImage getLayerRangeImage(layer)"),
        (False, "isPointCloudEnabled"), (_EMPTY, "getPointCloud getLayerPointCloud(layer)"),
        (0, "getNumberOfPoints getHorizontalResolution getNumberOfLayers"),
        (nan, f"getMinFrequency getMaxFrequency getFrequency getFov getVerticalFov {_RANGES}"),
    ],
    "LightSensor": [(nan, "getValue"), *_TABLE],
    "Radar": [(nan, f"{_RANGES} getHorizontalFov getVerticalFov"), (0, "getNumberOfTargets"), (_EMPTY, "getTargets")],
    "RangeFinder": [(None, "getRangeImage"), (0, _SIZES), (nan, f"getFov {_RANGES}"), (-1, "saveImage")],
    "Receiver": [
        (0, "getQueueLength getDataSize"), (None, "nextPacket getData setChannel"), (-1, "getChannel"),
        (nan, "getSignalStrength"), (_VECTOR, "getEmitterDirection"),
    ],
}

# The same for other devices.
_OTHERS = {
    "Brake": [(None, "setDampingConstant getMotor getPositionSensor"), (0, "getType")],
    "Connector": [(-1, "getPresence"), (False, "isLocked"), (None, "lock unlock")],
    "Display": [
        (0, _SIZES),
        (None, "setColor setAlpha setOpacity setFont drawPixel drawLine drawRectangle drawOval drawPolygon drawText "
               "fillRectangle fillOval fillPolygon imageNew imageCopy imageLoad imagePaste imageSave imageDelete "
               "attachCamera detachCamera"),
    ],
    "Emitter": [(0, "send getBufferSize"), (-1, "getChannel"), (nan, "getRange"), (None, "setChannel setRange")],
    "LinearMotor": [],
    "Pen": [(None, "write setInkColor")],
    "Skin": [
        (None, "setBoneOrientation setBonePosition"), (0, "getBoneCount"), ("", "getBoneName(index)"),
        (_QUATERNION, "getBoneOrientation(index)"), (_VECTOR, "getBonePosition(index)"),
    ],
    "VacuumGripper": [(False, "getPresence isOn"), (None, "turnOn turnOff")],
}

_CONSTANTS = {
    "Brake": {"ROTATIONAL": 0, "LINEAR": 1},
    "Display": {"RGB": 3, "RGBA": 4, "ARGB": 5, "BGRA": 6, "ABGR": 7},
    "DistanceSensor": {"GENERIC": 0, "INFRA_RED": 1, "SONAR": 2, "LASER": 3},
    "Emitter": {"CHANNEL_BROADCAST": -1},
    "GPS": {"LOCAL": 0, "WGS84": 1},
    "Receiver": {"CHANNEL_BROADCAST": -1},
}

_CALLS = {**_SENSORS, **_OTHERS}
__all__ = sorted(_CALLS)


class _Absent(_darwinop.AbsentDevice):
    """An object without a device: `GPS("gps")` logs one line per name."""

    def __init__(self, name):
        super().__init__(self._type, name)


def _add_call(kind, call, result):
    name, _, argument = call.partition("(")

    def method(self, *_, **__):
        return list(result) if isinstance(result, tuple) else result

    method.__name__ = name
    setattr(kind, name, method)
    if name.startswith(("get", "is")) and not argument:
        _darwinop.add_property(kind, name)


def _add_sampling(kind, what):
    """enable(), disable() and getSamplingPeriod(), or those of `what`."""
    getter = f"get{what}SamplingPeriod"
    period = "_" + getter

    def enable(self, sampling_period):
        setattr(self, period, sampling_period)

    def disable(self):
        setattr(self, period, 0)

    def get_sampling_period(self):
        return getattr(self, period, 0)

    setattr(kind, "enable" + what, enable)
    setattr(kind, "disable" + what, disable)
    setattr(kind, getter, get_sampling_period)
    _darwinop.add_property(kind, getter)


def _make_class(name):
    kind = type(name, (_Absent,), {"__doc__": "This robot has none.", "__module__": __name__, "_type": name})
    for constant, value in _CONSTANTS.get(name, {}).items():
        setattr(kind, constant, value)
    if name in _SENSORS:
        _add_sampling(kind, "")
    if name in ("Connector", "VacuumGripper"):
        _add_sampling(kind, "Presence")
    for result, calls in _CALLS[name]:
        for call in calls.split():
            _add_call(kind, call, result)
    return kind


def _depth(image, width, x, y):
    return nan if image is None else image[y * width + x]


def _getter(kind):
    def get(self, name=""):
        device = self.getDevice(name)  # logs once that there is none
        return device if isinstance(device, kind) else None

    return get


def add_getters(robot):
    """Adds getGPS(name) and its siblings to the class of the robot."""
    for name in __all__:
        setattr(robot, "get" + name, _getter(globals()[name]))


for _name in __all__:
    globals()[_name] = _make_class(_name)
globals()["GPS"].convertToDegreesMinutesSeconds = staticmethod(_darwinop.degrees_minutes_seconds)
globals()["RangeFinder"].rangeImageGetDepth = staticmethod(_depth)
