"""The simulator's supervisor: a robot has no scene tree and no simulation to supervise."""

import _darwinop

from .robot import Robot

# What each call returns here, as in C++.
_CALLS = {
    None: (
        "exportImage getFromDef getFromDevice getFromDeviceTag getFromId getRoot getSelected getSelf loadWorld "
        "movieStartRecording movieStopRecording setLabel simulationPhysicsReset simulationQuit simulationReset "
        "simulationResetPhysics simulationRevert simulationSetMode startMovie stopMovie "
        "virtualRealityHeadsetGetOrientation virtualRealityHeadsetGetPosition worldLoad worldReload"
    ),
    False: (
        "animationStartRecording animationStopRecording saveWorld virtualRealityHeadsetIsUsed worldSave"
    ),
    True: "movieFailed movieIsReady",
}


class Supervisor(Robot):
    """A Robot whose calls on the simulation have no effect, each with one warning. getSupervisor() is False."""

    SIMULATION_MODE_PAUSE, SIMULATION_MODE_REAL_TIME, SIMULATION_MODE_RUN, SIMULATION_MODE_FAST = 0, 1, 2, 2

    MOVIE_READY, MOVIE_RECORDING, MOVIE_SAVING, MOVIE_WRITE_ERROR, MOVIE_ENCODING_ERROR, MOVIE_SIMULATION_ERROR = range(6)

    @staticmethod
    def getSupervisorInstance():
        return Robot.created if isinstance(Robot.created, Supervisor) else None

    def simulationGetMode(self):
        _darwinop.warn_of_supervisor_call("simulationGetMode()")
        return self.SIMULATION_MODE_REAL_TIME

    def movieGetStatus(self):
        _darwinop.warn_of_supervisor_call("movieGetStatus()")
        return self.MOVIE_READY

    getMovieStatus = movieGetStatus


def _call(name, result):
    def call(self, *_, **__):
        _darwinop.warn_of_supervisor_call(name + "()")
        return result

    call.__name__ = name
    return call


for _result, _names in _CALLS.items():
    for _name in _names.split():
        setattr(Supervisor, _name, _call(_name, _result))
for _name in ("getRoot", "getSelf", "getSelected"):
    _darwinop.add_property(Supervisor, _name)
