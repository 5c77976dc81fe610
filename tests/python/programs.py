"""Starts the commands of the build folder DARWINOP_BIN, and reads their recordings."""

import contextlib
import csv
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

BIN = pathlib.Path(os.environ["DARWINOP_BIN"])
CONTROLLERS = pathlib.Path(__file__).parent / "controllers"
TIMEOUT_S = 60
DRIVEN = "4"  # safety.state


class Programs(unittest.TestCase):
    """Each test has a folder of its own, and no runtime of another one."""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="darwinop-python-")))
        self.environment = dict(os.environ, DARWINOP_RUNTIME_NAME=str(self.folder / "runtime"), DARWINOP_KEYS="none")
        self.environment.pop("PYTHONUNBUFFERED", None)

    def run_controller(self, controller, *arguments, robot="virtual", record=None, status=0):
        """`darwinop run`; returns what was written to stdout and stderr."""
        path = controller if "/" in str(controller) else CONTROLLERS / controller
        options = ["--robot", robot] + (["--record", str(record)] if record else [])
        ended = subprocess.run([BIN / "darwinop", "run", *options, path, *arguments], env=self.environment,
                               capture_output=True, text=True, timeout=TIMEOUT_S)
        self.assertEqual(ended.returncode, status, ended.stdout + ended.stderr)
        return ended.stdout, ended.stderr

    @contextlib.contextmanager
    def started(self, *command, ready):
        """A program that runs meanwhile; yields the match of `ready` in its output."""
        with subprocess.Popen([BIN / command[0], *command[1:]], env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as program:
            try:
                output = ""
                for line in program.stdout:
                    output += line
                    if found := re.search(ready, line):
                        break
                else:
                    self.fail(f"{command[0]} ended: {output}")
                yield found
            finally:
                program.send_signal(signal.SIGTERM)
                program.communicate(timeout=TIMEOUT_S)


def rows_of(recording):
    """Names of the columns, and the rows."""
    with open(recording, encoding="utf-8") as file:
        names, *rows = csv.reader(line for line in file if not line.startswith("#"))
    return names, rows


def movements(recording):
    """Rows of what the controller asked for, what was sent, and where the joints were; the names first."""
    names, rows = rows_of(recording)
    columns = [i for i, name in enumerate(names) if re.search(r"\.(asked|commanded|position)", name)]
    return [[row[i] for i in columns] for row in [names, *rows]]


def goals(recording):
    """Of each session, in order, while it drove all joints: goals in rad by column, "asked" and "commanded", by cycle."""
    names, rows = rows_of(recording)
    state, session = names.index("safety.state"), names.index("driver.session")
    columns = {name: [i for i, title in enumerate(names) if title.endswith(f".{name} [rad]")]
               for name in ("asked", "commanded")}
    sessions = {}
    for row in rows:
        if row[state] != DRIVEN or row[session] == "0":
            continue
        found = sessions.setdefault(row[session], {name: [] for name in columns})
        for name, indices in columns.items():
            if all(row[i] for i in indices):
                found[name].append([float(row[i]) for i in indices])
    return list(sessions.values())
