"""Runs that are advanced step by step: the states of the program, observed quantities, restarts, cost."""

import copy
import multiprocessing
import pickle
import signal
import unittest

import numpy as np

import talus
from program import BALL, CASES


def simulations():
    """Scenes with contacts, friction, cables and located events."""
    names = ["two_cable.toml", "damped_disc.toml", "rolling_disc.toml", "pivoted_cylinder.toml", "fence/table_2.toml"]
    return [talus.Scene.parse(BALL)] + [talus.Scene.read(str(CASES / name)) for name in names]


def last_height(simulation):
    """In another process."""
    simulation.run()
    return float(simulation.y[0])


class Simulations(unittest.TestCase):
    def test_each_step_is_that_of_the_run(self):
        for scene in simulations():
            with self.subTest(scene.name):
                run = scene.run()
                simulation = talus.Simulation(scene)
                times = run["time"]
                every = max(1, round((times[1] - times[0]) / scene.step))
                moving = [name for name in scene.bodies if f"{name}.x" in run]
                index = [scene.bodies.index(name) for name in moving]
                energies = [name.removeprefix("energy.") for name in run.columns
                            if name.startswith(("energy.", "dissipated."))]
                rows = []

                def add(seen):
                    rows.append([seen.time]
                                + [a[i] for i in index for a in (seen.x, seen.y, seen.vx, seen.vy)]
                                + list(seen.overlaps) + list(seen.contact_forces)
                                + list(seen.elongations) + list(seen.tensions)
                                + [seen.energies[name] for name in energies])

                add(simulation)
                simulation.run(add, every=every)
                columns = (["time"]
                           + [f"{name}.{a}" for name in moving for a in ("x", "y", "vx", "vy")]
                           + [f"{name}.overlap" for name in scene.contacts]
                           + [f"{name}.force" for name in scene.contacts]
                           + [f"{name}.elongation" for name in scene.cables]
                           + [f"{name}.tension" for name in scene.cables]
                           + [f"energy.{name}" if f"energy.{name}" in run else name for name in energies])
                np.testing.assert_array_equal(np.array(rows), np.column_stack([run[c] for c in columns]))
                self.assertEqual(simulation.outcome, run.outcome)
                self.assertEqual(simulation.evaluations, run.summary["evaluations"])
                self.assertEqual(simulation.steps, run.summary["steps"])
                parts = ("kinetic", "gravity", "applied", "contacts", "cables")
                self.assertEqual(simulation.energies["total"], sum(simulation.energies[part] for part in parts))

    def test_arguments_are_those_of_a_run(self):
        scene = talus.Scene.parse(BALL)
        for arguments in ({"integrator": "odeint_dopri5", "tolerance": 1e-5}, {"integrator": "rk4", "step": "1 ms"},
                          {"end": "0.5 s"}):
            simulation, run = talus.Simulation(scene, **arguments), scene.run(**arguments)
            simulation.run()
            self.assertEqual(simulation.time, run["time"][-1])
            self.assertEqual(simulation.evaluations, run.summary["evaluations"])
            self.assertEqual(simulation.y[0], run["ball.y"][-1])

    def test_angles_and_spins(self):
        scene = talus.Scene.read(str(CASES / "rolling_disc.toml"))
        run, simulation = scene.run(), talus.Simulation(scene)
        simulation.run()
        disc = scene.bodies.index("disc")
        self.assertEqual(simulation.angle[disc], run["disc.angle"][-1])
        self.assertEqual(simulation.spin[disc], run["disc.spin"][-1])
        self.assertNotEqual(simulation.spin[disc], 0.0)

    def test_coordinates_are_those_of_the_bodies(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL))
        self.assertEqual(simulation.coordinates, ["ball.x", "ball.y"])
        simulation.advance(100)
        self.assertEqual((simulation.q[0], simulation.q[1]), (simulation.x[0], simulation.y[0]))
        self.assertEqual(simulation.v[1], simulation.vy[0])

    def test_steps_one_by_one_are_steps_together(self):
        for scene in simulations():
            with self.subTest(scene.name):
                one, many = talus.Simulation(scene), talus.Simulation(scene)
                for _ in range(150):
                    self.assertTrue(one.advance())
                self.assertTrue(many.advance(150))
                self.assertEqual((one.time, one.steps, one.evaluations), (many.time, many.steps, many.evaluations))
                np.testing.assert_array_equal(one.q, many.q)
                np.testing.assert_array_equal(one.v, many.v)

    def test_the_end(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL), end="10 ms")
        self.assertIsNone(simulation.outcome)
        self.assertTrue(simulation.advance(49))
        self.assertFalse(simulation.advance(10**18))
        self.assertEqual((simulation.steps, simulation.time, simulation.outcome), (50, 0.01, "finished"))
        before = simulation.y.copy()
        self.assertFalse(simulation.advance())
        np.testing.assert_array_equal(before, simulation.y)
        self.assertIn("t = 0.01 s, 50 steps", repr(simulation))

    def test_a_callback_stops_the_run(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL))
        times = []
        simulation.run(lambda seen: times.append(seen.time) or (False if seen.y[0] < 0.2 else None), every=7)
        self.assertEqual(simulation.steps, 7 * len(times))
        self.assertLess(simulation.y[0], 0.2)
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            simulation.run(lambda seen: 1 / 0)
        simulation.restart()
        simulation.run(lambda seen: seen.y[0] > 0.2)
        self.assertLess(simulation.y[0], 0.2)
        self.assertIsNone(simulation.outcome)
        # A callback of the last step can start again.
        simulation = talus.Simulation(talus.Scene.parse(BALL), end="1 ms")
        starts = []
        simulation.run(lambda seen: starts.append(seen.restart()) if seen.outcome and len(starts) < 2 else None)
        self.assertEqual((len(starts), simulation.steps, simulation.outcome), (2, 5, "finished"))

    def test_a_fence_ends_early(self):
        fence = talus.Scene.read(str(CASES / "fence/table_2.toml"))
        whole = talus.Simulation(fence)
        rock = next(i for i, name in enumerate(fence.bodies) if name.startswith("rock"))
        until = fence.changed({"fence.options": {"end": "exit", "exit_x": f"{whole.x[rock] - 0.5!r} ft"}})
        simulation, run = talus.Simulation(until), until.run()
        simulation.run()
        self.assertEqual((simulation.time, simulation.outcome), (run["time"][-1], "finished"))
        self.assertEqual(run.outcome, "finished")
        self.assertLess(simulation.time, until.end)
        self.assertLess(simulation.x[rock], whole.x[rock] - 0.5)

    def test_bodies_at_rest_move_from_a_restart_on(self):
        # The columns are not computed before the rock touches them.
        simulation = talus.Simulation(talus.Scene.read(CASES / "fence/table_2.toml"))
        start = simulation.x.copy()
        simulation.restart(v=[0.01] * len(simulation.v))
        simulation.advance()
        np.testing.assert_allclose((simulation.x - start)[1:], 0.01 * simulation.time, rtol=1e-5)

    def test_a_run_that_diverges(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL), step="1e200 s", end="1e203 s")
        self.assertFalse(simulation.advance(10))
        self.assertEqual(simulation.outcome, "diverged")
        self.assertEqual((simulation.time, simulation.steps), (0.0, 0))
        self.assertRegex(simulation.message, "diverged at t = .* 'ball.x' is not finite")

    def test_the_last_finite_state_stays(self):
        scene = talus.Scene.read(CASES / "two_cable.toml")
        for integrator in ("euler", "velocity_verlet", "rk4"):
            ends = []
            for steps in (1, 7, 10**9):
                simulation = talus.Simulation(scene, integrator=integrator, step="20 s", end="1e6 s")
                while simulation.advance(steps):
                    pass
                ends.append((simulation.time, simulation.steps, simulation.evaluations, list(simulation.q),
                             list(simulation.v), simulation.outcome, simulation.message))
            self.assertEqual(ends[0], ends[1])
            self.assertEqual(ends[0], ends[2])
            self.assertEqual(ends[0][5], "diverged")
            self.assertEqual(ends[0][0], 20.0 * ends[0][1])

    def test_no_use_within_a_step(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL), end="100000 s")
        found = []

        def handler(number, frame):
            for use in (simulation.advance, simulation.restart, lambda: simulation.y, lambda: simulation.energies,
                        lambda: simulation.time, lambda: pickle.dumps(simulation), lambda: repr(simulation)):
                try:
                    use()
                except RuntimeError as error:
                    found.append(str(error))
            raise KeyboardInterrupt

        before = signal.signal(signal.SIGALRM, handler)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            with self.assertRaises(KeyboardInterrupt):
                simulation.advance(10**9)
        finally:
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(len(found), 7)
        self.assertIn("the run is advancing", found[0])
        self.assertTrue(simulation.advance())

    def test_restarts(self):
        scene = talus.Scene.parse(BALL)
        simulation = talus.Simulation(scene)
        simulation.run()
        simulation.restart()
        self.assertEqual((simulation.time, simulation.steps, simulation.outcome), (0.0, 0, None))
        simulation.advance(1200)
        other = talus.Simulation(scene)
        other.advance(1200)
        np.testing.assert_array_equal(simulation.q, other.q)
        # Elsewhere: pressed into the floor by 1 mm, at rest.
        simulation.restart(q=[0.0, 0.099], v=np.zeros(2))
        self.assertAlmostEqual(simulation.overlaps[0], 1e-3, delta=1e-15)
        self.assertAlmostEqual(simulation.contact_forces[0], 20.0, delta=1e-10)
        self.assertAlmostEqual(simulation.energies["contacts"], 0.01, delta=1e-13)
        self.assertTrue(simulation.advance())
        simulation.restart(v=[3.0, -2.0])
        self.assertEqual((simulation.vx[0], simulation.vy[0], simulation.y[0]), (3.0, -2.0, 0.3))
        for wrong, message in (({"q": [0.0]}, "q: found 1 numbers; it must be 2"),
                               ({"v": [0.0, float("nan")]}, r"v\[1\]: found nan; it must be finite")):
            with self.assertRaisesRegex(talus.InputError, message):
                simulation.restart(**wrong)

    def test_wrong_counts(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL))
        with self.assertRaisesRegex(talus.InputError, "steps: found -1; it must be >= 0"):
            simulation.advance(-1)
        with self.assertRaisesRegex(talus.InputError, "every: found 0; it must be >= 1"):
            simulation.run(every=0)
        self.assertTrue(simulation.advance(0))
        self.assertEqual(simulation.steps, 0)

    def test_arrays_show_the_state(self):
        simulation = talus.Simulation(talus.Scene.parse(BALL))
        q = simulation.q
        start = q.copy()
        simulation.advance(100)
        self.assertTrue(np.shares_memory(q, simulation.q))
        self.assertNotEqual(q[1], start[1])
        with self.assertRaises(ValueError):
            q[0] = 1.0
        del simulation
        self.assertEqual(q.shape, (2,))

    def test_simulations_pickle_between_two_steps(self):
        for scene in simulations():
            with self.subTest(scene.name):
                simulation = talus.Simulation(scene)
                simulation.advance(137)
                loaded = pickle.loads(pickle.dumps(simulation))
                self.assertEqual(loaded.time, simulation.time)
                np.testing.assert_array_equal(loaded.tensions, simulation.tensions)
                self.assertEqual(loaded.advance(200), simulation.advance(200))
                np.testing.assert_array_equal(loaded.q, simulation.q)
                self.assertEqual(loaded.energies, simulation.energies)
        disc = talus.Scene.read(CASES / "damped_disc.toml")
        for integrator in talus.integrators():
            for steps in (0, 1, 2):
                with self.subTest(integrator=integrator, steps=steps):
                    tolerance = 1e-6 if integrator.startswith(("odeint_", "stormer")) and integrator != "odeint_abm8" else 0
                    simulation = talus.Simulation(disc, integrator=integrator, tolerance=tolerance, step="1 ms")
                    simulation.advance(steps)
                    copied = copy.deepcopy(simulation)
                    simulation.advance(100), copied.advance(100)
                    self.assertEqual(list(copied.q), list(simulation.q))
                    self.assertEqual((copied.step, copied.end, copied.evaluations),
                                     (simulation.step, simulation.end, simulation.evaluations))
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            scenes = [talus.Scene.parse(BALL), talus.Scene.parse(BALL).changed({"body.ball.mass": "4 kg"})]
            heights = pool.map(last_height, [talus.Simulation(scene) for scene in scenes])
        self.assertEqual(heights, [scene.run()["ball.y"][-1] for scene in scenes])
        ended = talus.Simulation(talus.Scene.parse(BALL), end="10 ms", step="1 ms", integrator="rk4")
        ended.run()
        loaded = pickle.loads(pickle.dumps(ended))
        self.assertEqual((loaded.outcome, loaded.steps, loaded.time), ("finished", 10, 0.01))


if __name__ == "__main__":
    unittest.main()
