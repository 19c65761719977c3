"""Talus: discrete-element runs of scenes of rigid bodies, contacts and cables, and of shear cells.

    import talus
    run = talus.Scene.read("cases/two_cable.toml").run()
    print(run["particle.y"].min(), run.unit("particle.y"))

Numbers are in the consistent units of the scene (`Scene.units`); quantities that are given are
texts with units ("3 kg"). The guide's page "Talus in Python" has more.
"""

from . import _talus
from ._talus import Cell, CellRun, Run, Scene, Simulation, __version__, integrators, read_sweep, sweep
from .errors import InputError, IoError, Problem

__all__ = [
    "Cell",
    "CellRun",
    "InputError",
    "IoError",
    "Problem",
    "Run",
    "Scene",
    "Simulation",
    "Table",
    "calibrate",
    "integrators",
    "read_sweep",
    "sweep",
]


class Table(dict):
    """A table of a scene file as an object: `Table(name="ball", mass="2 kg").mass`."""

    def __init__(self, **fields):
        super().__init__(fields)

    def __getattr__(self, field):
        try:
            return self[field]
        except KeyError:
            raise AttributeError(field) from None

    def __setattr__(self, field, value):
        self[field] = value


def calibrate(
    *,
    masses,
    restitution=None,
    law="linear_spring_dashpot",
    dashpot=None,
    end_rule=None,
    pivot=(),
    offset=(),
    speed=None,
    bound=1e-3,
    integrator="velocity_verlet",
    **parameters,
):
    """The damping that gives a single impact its restitution, and a step for it.

    The arguments are those options of `talus calibrate` which describe one impact along the
    normal, the result is the dict that its --json prints, in SI units. `masses`: of body 1 and
    body 2; a single one hits a fixed body. `parameters`: those of the law, e.g.
    stiffness="1 MN/m"; with damping="3 kN s/m" in place of `restitution`, the restitution that
    this dashpot gives. Raises InputError.
    """
    if isinstance(masses, str):
        masses = [masses]
    return _talus.calibrate(
        restitution=restitution,
        masses=list(masses),
        law=law,
        parameters=parameters,
        dashpot=dashpot,
        end_rule=end_rule,
        pivot=list(pivot),
        offset=list(offset),
        speed=speed,
        bound=bound,
        integrator=integrator,
    )
