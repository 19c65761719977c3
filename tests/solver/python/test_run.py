"""Runs of a scene: the bits of the program, arrays without copies, errors, threads, signals."""

import json
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import talus
from program import BALL, CASES, history_of, talus as program, text_file

SCENES = ["two_cable.toml", "damped_disc.toml", "rolling_disc.toml", "fence/table_2.toml", "fence/sample2.DAT"]


class Runs(unittest.TestCase):
    def test_the_bits_of_the_program(self):
        for name in SCENES:
            with self.subTest(name):
                columns, summary = history_of(CASES / name)
                run = talus.Scene.read(str(CASES / name)).run()
                self.assertEqual(run.columns, list(columns))
                for column, (unit, values) in columns.items():
                    self.assertEqual(run.unit(column), unit)
                    self.assertEqual(run[column].tolist(), values, column)
                # The program runs a fence a second time, and notes what its files do not contain.
                of_program, of_module = ({key: value for key, value in of.items() if key not in ("quality", "notes")}
                                         for of in (summary, run.summary))
                self.assertEqual(of_module, of_program)
                self.assertEqual(run.summary["quality"]["usable"], summary["quality"]["usable"])

    def test_arguments_are_the_options(self):
        scene = CASES / "damped_disc.toml"
        options = {"end": "0.05 s", "integrator": "rk4", "step": "0.1 ms"}
        columns, _ = history_of(scene, *sum(([f"--{name}", text] for name, text in options.items()), []))
        run = talus.Scene.read(str(scene)).run(**options)
        self.assertEqual(run["time"].tolist(), columns["time"][1])
        self.assertEqual(run["disc.y"].tolist(), columns["disc.y"][1])
        with_tolerance = talus.Scene.read(str(scene)).run(integrator="odeint_dopri5", tolerance=1e-6)
        self.assertEqual(with_tolerance.summary["integrator"], "odeint_dopri5")
        coarse = talus.Scene.read(str(scene)).run(integrator="odeint_dopri5", tolerance=1e-3)
        self.assertLess(coarse.summary["evaluations"], with_tolerance.summary["evaluations"])

    def test_arrays_are_views(self):
        run = talus.Scene.parse(BALL).run()
        height, history = run["ball.y"], run.history
        self.assertEqual(history.shape, (run.rows, len(run.columns)))
        self.assertTrue(np.shares_memory(height, history))
        np.testing.assert_array_equal(history[:, run.columns.index("ball.y")], height)
        with self.assertRaises(ValueError):
            height[0] = 0.0
        with self.assertRaises(ValueError):
            history[0, 0] = 0.0
        del run  # the arrays keep their numbers
        self.assertEqual(height[0], 0.3)

    def test_a_run_is_a_container_of_columns(self):
        run = talus.Scene.parse(BALL).run()
        self.assertIn("ball.y", run)
        self.assertNotIn("ball.z", run)
        self.assertNotIn(3, run)
        self.assertEqual((run.rows, len(run)), (101, len(run.columns)))
        self.assertEqual(list(run), run.columns)
        columns = dict(run)
        self.assertEqual(list(columns), run.columns)
        self.assertEqual(columns["ball.y"][0], 0.3)
        with self.assertRaisesRegex(talus.InputError, "column 'bal.y' is not known; nearest: ball.y"):
            run["bal.y"]
        with self.assertRaisesRegex(talus.InputError, "column 'y' is not known"):
            run.unit("y")
        self.assertEqual((run.outcome, run.usable, run.warnings), ("finished", True, []))
        self.assertEqual(repr(run), f"<talus.Run: finished, {len(run.columns)} columns, 101 rows>")

    def test_a_diverged_run_is_a_result(self):
        scene = talus.Scene.parse(BALL).changed({"run.step": "50 ms", "run.interval": "50 ms"})
        run = scene.run()
        self.assertEqual(run.outcome, "diverged")
        self.assertFalse(run.usable)
        self.assertTrue(run.summary["quality"]["flaw"])
        self.assertEqual(run.outcome, run.summary["outcome"]["kind"])
        copy = pickle.loads(pickle.dumps(run))
        self.assertEqual((copy.outcome, copy.usable), ("diverged", False))
        self.assertTrue(run.warnings)
        with tempfile.TemporaryDirectory() as folder:
            text = BALL.replace('"0.2 ms"', '"1e200 s"').replace('"10 ms"', '"1e200 s"').replace('"1 s"', '"1e203 s"')
            file = text_file(folder, "ball.toml", text)
            _, summary = history_of(file, code=3)
            run = talus.Scene.read(file).run()
        for part in ("outcome", "quality"):
            self.assertEqual(run.summary[part], summary[part])
        self.assertIn("the linear limit of velocity_verlet", run.summary["outcome"]["message"])

    def test_runs_pickle(self):
        run = talus.Scene.parse(BALL).run()
        copy = pickle.loads(pickle.dumps(run))
        np.testing.assert_array_equal(copy.history, run.history)
        self.assertEqual((copy.columns, copy.summary, copy.warnings), (run.columns, run.summary, run.warnings))
        self.assertEqual((copy.outcome, copy.usable), (run.outcome, run.usable))
        self.assertEqual(copy.unit("ball.vy"), "m/s")

    def test_wrong_arguments(self):
        scene = talus.Scene.parse(BALL)
        for arguments, message in (
            ({"end": "1 kg"}, '^end: found "1 kg"'),
            ({"step": "-1 s"}, '^step: found "-1 s"'),
            ({"integrator": "verlet"}, "integrator 'verlet' is not known; nearest: velocity_verlet"),
            ({"tolerance": 1e-6}, "tolerance"),
            ({"step": ""}, '^step: found ""; leave it out'),
        ):
            with self.assertRaisesRegex(talus.InputError, message):
                scene.run(**arguments)
        with self.assertRaises(TypeError):
            scene.run("1 s")

    def test_other_threads_continue(self):
        scene = talus.Scene.parse(BALL).changed({"run.end": "300 s", "run.interval": "1 s"})
        counted = 0
        run = threading.Thread(target=scene.run)
        run.start()
        while run.is_alive():
            counted += 1
            time.sleep(0.001)
        # With the lock held no turn would come between start and end.
        self.assertGreater(counted, 20)

    def test_an_interrupt_ends_a_run(self):
        scene = talus.Scene.parse(BALL).changed({"run.end": "100000 s", "run.interval": "1000 s"})
        simulation = talus.Simulation(scene)
        # It meets the floor after a day.
        slow = scene.changed({"body[0].velocity": ["0 m/s", "-1 mm/s"], "gravity[1]": "0 m/s^2",
                              "body[0].position[1]": "100 m"})
        # Of the last one, the calling thread would have the short run.
        for work in (scene.run, lambda: simulation.advance(10**9), simulation.run,
                     lambda: slow.calibrate("impact", restitution=0.5),
                     lambda: talus.sweep(scene, [{}] * 4, ["ball.y.end"], threads=2),
                     lambda: talus.sweep(scene, [{"run.end": "1000 s"}, {}], ["ball.y.end"], threads=2)):
            threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
            start = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                work()
            self.assertLess(time.monotonic() - start, 20.0)
        self.assertGreater(simulation.steps, 0)

    def test_the_interpreter_ends_while_a_run_does_not(self):
        script = ("import threading, time, talus\nfrom program import BALL\n"
                  "scene = talus.Scene.parse(BALL).changed({'run.end': '100000 s', 'run.interval': '1000 s'})\n"
                  "for work in (scene.run, talus.Simulation(scene).run, lambda: talus.sweep(scene, [{}], [])):\n"
                  "    threading.Thread(target=work, daemon=True).start()\n"
                  "time.sleep(0.2)\n")
        ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60,
                               cwd=os.path.dirname(__file__))
        self.assertEqual(ended.returncode, 0, ended.stderr)

    def test_the_version_is_that_of_the_program(self):
        self.assertIn(f"talus {talus.__version__}\n", program("--version"))


if __name__ == "__main__":
    unittest.main()
