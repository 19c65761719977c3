"""The built programs as the `use.py` of a recipe starts them: `talus`, `verify`, and comparisons of what they give."""

import csv
import json
import os
import pathlib
import subprocess


class Failure(Exception):
    """What a recipe's new part does not do, as text."""


def run(program, *arguments, status=0):
    """Output of a program; Failure if it ends with another status."""
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != status:
        shown = (done.stdout + done.stderr).strip()[-2000:]
        raise Failure(f"{pathlib.Path(program).name} {' '.join(map(str, arguments))}: status {done.returncode}, "
                      f"expected {status}:\n{shown}")
    return done.stdout + done.stderr


def talus(*arguments, status=0):
    return run(os.environ["TALUS"], *arguments, status=status)


def verify(*arguments, status=0):
    return run(os.environ["TALUS_VERIFY"], *arguments, status=status)


def run_scene(text, out="out"):
    """The folder of a run of this scene."""
    pathlib.Path("scene.toml").write_text(text)
    talus("run", "scene.toml", "--out", out)
    return pathlib.Path(out)


def guide_script(heading):
    """The first script in Python below a heading of docs/python.md."""
    guide = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"
    return guide.read_text().split(f"# {heading}\n", 1)[1].split("```python\n", 1)[1].split("```", 1)[0]


def final_body(folder, name):
    """Position, velocity, ... of a body at the end of a run, as in final_state.json."""
    bodies = json.loads((folder / "final_state.json").read_text())["bodies"]
    return next(body for body in bodies if body["name"] == name)


def rows(file):
    """The rows of a CSV file, as dictionaries of texts."""
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def expect(holds, what):
    if not holds:
        raise Failure(what)


def expect_near(what, found, wanted, relative):
    expect(abs(found - wanted) <= relative * abs(wanted), f"{what}: found {found!r}, expected {wanted!r}")
