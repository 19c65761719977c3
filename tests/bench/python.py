"""Microseconds a step from Python: many steps in a call, one step in a call, and a callback after each step.

Medians of alternating runs, in processor time, which other processes disturb least; the difference to the first
column is the cost of a call. Exit status: 1 if a call costs more than 1 us.
"""

import statistics
import sys
import time

import talus

ROUNDS = 9
MAXIMUM = 1.0  # us a call
SCENES = ("cases/two_cable.toml", "cases/damped_disc.toml", "cases/fence/table_2.toml")


def many(simulation):
    simulation.advance(10**9)


def single(simulation):
    advance = simulation.advance
    while advance():
        pass


def callback(simulation):
    simulation.run(lambda seen: None)


print(f"{'us a step':28}{'many steps':>12}{'one step':>12}{'callback':>12}{'cost of a call':>18}")
worst = 0.0
for name in SCENES:
    scene = talus.Scene.read(name)
    times = {way: [] for way in (many, single, callback)}
    for _ in range(ROUNDS):
        for way, taken in times.items():
            simulation = talus.Simulation(scene, integrator="velocity_verlet", step="10 us")
            start = time.process_time()
            way(simulation)
            taken.append(1e6 * (time.process_time() - start) / simulation.steps)
    bare, one, called = (statistics.median(taken) for taken in times.values())
    print(f"{name:28}{bare:12.3f}{one:12.3f}{called:12.3f}{one - bare:10.2f}, {called - bare:.2f}")
    worst = max(worst, one - bare, called - bare)
if worst > MAXIMUM:
    sys.exit(f"bench: a call costs {worst:.2f} us; it must be at most {MAXIMUM:g} us")
