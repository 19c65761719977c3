"""What the tests of the module compare with: the program, run on the same scene."""

import csv
import json
import os
import subprocess
import tempfile
from pathlib import Path

TALUS = os.environ["TALUS"]
CASES = Path("cases")

# A ball on a spring; the numbers in the text are quantities of its reader.
BALL = """
title = "Ball"
units = "SI"
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[[body]]
name = "ball"
mobility = "particle"
mass = "2 kg"
shape = { kind = "circle", radius = "0.1 m" }
position = ["0 m", "0.3 m"]
[[body]]
name = "floor"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]
[[contact]]
name = "impact"
between = ["ball", "floor"]
law = "linear_spring_dashpot"
stiffness = "20 kN/m"
restitution = 0.5
[run]
end = "1 s"
step = "0.2 ms"
interval = "10 ms"
integrator = "velocity_verlet"
"""


def talus(*arguments, code=0):
    """Standard output of the program."""
    ended = subprocess.run([TALUS, *map(str, arguments)], capture_output=True, text=True)
    assert ended.returncode == code, (ended.returncode, ended.stderr)
    return ended.stdout


def history_of(scene, *options, code=0):
    """Columns of the history that the program writes, and its summary."""
    with tempfile.TemporaryDirectory() as folder:
        talus("run", scene, "--out", folder, *options, code=code)
        with open(Path(folder) / "history.csv", newline="") as file:
            rows = list(csv.reader(file))
        summary = json.loads((Path(folder) / "summary.json").read_text())
    columns = {}
    for i, head in enumerate(rows[0]):
        name, unit = head[:-1].split(" [")
        columns[name] = (unit, [float(row[i]) for row in rows[1:]])
    return columns, summary


def text_file(folder, name, text):
    path = Path(folder) / name
    path.write_text(text)
    return str(path)
