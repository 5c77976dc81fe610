"""The robot of this process."""

import atexit
import os
import sys

import _darwinop

# step() returns -1 so often before it ends a program that does not look at it.
_CALLS_AFTER_THE_END = 100


def _program_directory():
    """Folder of the script, where config.ini is; the current one in an interactive session."""
    script = getattr(sys.modules.get("__main__"), "__file__", None)
    return os.path.dirname(os.path.abspath(script)) if script else os.getcwd()


class Robot(_darwinop.ConnectedRobot):
    """Connects to the robot and waits until it is in its start pose: one object in a process.

    The methods are those of C++ (docs/python.md); each getX() is also a property.
    """

    created = None

    def __init__(self):
        if Robot.created is not None:
            raise RuntimeError("only one Robot can be created in a process")
        try:
            sys.stdout.reconfigure(line_buffering=True)  # into a pipe also, as in C++
        except AttributeError:
            pass  # replaced by the program
        _darwinop.set_program_directory(_program_directory())
        super().__init__()
        Robot.created = self
        self._calls_after_the_end = 0
        # Before Python ends: after Ctrl-C it ends itself by the signal, and no other handler runs.
        atexit.register(_darwinop.end_session)

    @staticmethod
    def getInstance():
        return Robot.created

    def getControllerName(self):
        """Name of the script, without its folder and ending."""
        return os.path.splitext(os.path.basename(sys.argv[0]))[0]

    def getControllerArguments(self):
        return " ".join(sys.argv[1:])

    def step(self, duration=None):
        """Sends the commands, waits `duration` ms (default: the basic time step), and takes a new sensor image.

        0: in time. Positive: late by this many ms. -1: end the program, for example after Ctrl-C. A program that
        goes on calling gets KeyboardInterrupt, or SystemExit if the loop has ended for another reason.
        """
        result = super().step(int(self.getBasicTimeStep() if duration is None else duration))
        if result == -1:
            self._calls_after_the_end += 1
            if self._calls_after_the_end >= _CALLS_AFTER_THE_END:
                raise KeyboardInterrupt if _darwinop.stop_requested() else SystemExit(1)
        return result

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Ends the session: the robot is brought to rest."""
        _darwinop.end_session()


for _name in ("getControllerName", "getControllerArguments"):
    _darwinop.add_property(Robot, _name)
