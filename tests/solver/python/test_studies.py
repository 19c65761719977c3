"""Checks, advice, calibrations and sweeps: what the commands of the program print."""

import csv
import json
import math
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import talus
from program import BALL, CASES, talus as program, text_file


class Calibrations(unittest.TestCase):
    def test_of_a_scene(self):
        scene = CASES / "pivoted_cylinder.toml"
        printed = json.loads(program("calibrate", scene, "--contact", "impact", "--restitution", "0.5", "--json"))
        self.assertEqual(talus.Scene.read(str(scene)).calibrate("impact", restitution=0.5), printed)

    def test_of_an_impact(self):
        for arguments, options in (
            (dict(restitution=0.5, masses=["2 kg", "1 kg"], stiffness="1 MN/m"),
             ["--restitution", "0.5", "--masses", "2 kg", "1 kg", "--stiffness", "1 MN/m"]),
            (dict(restitution=0.7, masses="8 g", law="hertz", modulus="35 GPa", radius="1 cm", dashpot="constant",
                  speed="2 m/s", bound=5e-3, integrator="rk4"),
             ["--restitution", "0.7", "--masses", "8 g", "--law", "hertz", "--modulus", "35 GPa", "--radius", "1 cm",
              "--dashpot", "constant", "--speed", "2 m/s", "--bound", "5e-3", "--integrator", "rk4"]),
            (dict(masses=["2 kg", "1 kg"], stiffness="1 MN/m", damping="300 N s/m", end_rule="attractive",
                  pivot=["3 kg m^2", "1 m"]),
             ["--masses", "2 kg", "1 kg", "--stiffness", "1 MN/m", "--damping", "300 N s/m", "--end-rule",
              "attractive", "--pivot", "3 kg m^2", "1 m"]),
            (dict(restitution=0.6, masses=["2 kg", "1 kg"], stiffness="1 MN/m", offset=["3 kg m^2", "1 m"]),
             ["--restitution", "0.6", "--masses", "2 kg", "1 kg", "--stiffness", "1 MN/m", "--offset", "3 kg m^2",
              "1 m"]),
        ):
            self.assertEqual(talus.calibrate(**arguments), json.loads(program("calibrate", *options, "--json")))

    def test_errors(self):
        with self.assertRaisesRegex(talus.InputError, "contact 'impct' is not known; nearest: impact"):
            talus.Scene.parse(BALL).calibrate("impct", restitution=0.5)
        with self.assertRaisesRegex(talus.InputError, "stiffness"):
            talus.calibrate(restitution=0.5, masses="2 kg")
        with self.assertRaisesRegex(talus.InputError, "parameter 'stifness' is not known; nearest: stiffness"):
            talus.calibrate(restitution=0.5, masses="2 kg", stifness="1 MN/m")
        for wrong, message in ((dict(law="latching_spring"), "^law: latching_spring is calibrated at a step"),
                               (dict(masses=[]), "^masses: it is missing"),
                               (dict(masses=["1 kg"] * 3), "^masses: found 3; it must be one or two"),
                               (dict(pivot=["1 kg m^2"]), "^pivot: found 1 texts; it must be an inertia and an arm"),
                               (dict(offset=["1 kg m^2"] * 3), "^offset: found 3 texts"),
                               (dict(pivot=["1 kg m^2", "1 m"], offset=["1 kg m^2", "1 m"]), "^pivot: found both"),
                               (dict(dashpot="tsuji"), "^dashpot: the law 'linear_spring_dashpot' does not use"),
                               (dict(restitution=None), "^restitution: found none"),
                               (dict(restitution=2.0), "it must be in"), (dict(bound=-1.0), "it must be > 0")):
            with self.assertRaisesRegex(talus.InputError, message):
                talus.calibrate(**{**dict(restitution=0.5, masses="2 kg", stiffness="1 MN/m"), **wrong})


class Advice(unittest.TestCase):
    def test_is_that_of_the_program(self):
        scene = CASES / "cable_pendulum.toml"
        with tempfile.TemporaryDirectory() as folder:
            printed = json.loads(program("advise", scene, "--accuracy", "1e-3", "--of", "cable.tension.max", "--out",
                                         Path(folder) / "x.toml", "--among", "velocity_verlet,rk4", "--json"))
        advice = talus.Scene.read(str(scene)).advise("cable.tension.max", accuracy=1e-3,
                                                     among=["velocity_verlet", "rk4"])
        self.assertEqual(advice, printed)

    def test_warnings_are_allowed_on_request(self):
        scene, request = CASES / "damped_disc.toml", ("--accuracy", "0.2", "--of", "disc.y.max")
        for option, allowed in (([], False), (["--allow-warnings"], True)):
            with tempfile.TemporaryDirectory() as folder:
                printed = json.loads(program("advise", scene, *request, *option, "--out", Path(folder) / "x.toml",
                                             "--among", "velocity_verlet", "--json"))
            advice = talus.Scene.read(str(scene)).advise("disc.y.max", accuracy=0.2, among=["velocity_verlet"],
                                                         allow_warnings=allowed)
            self.assertEqual(advice, printed)
            tried = advice["tried"] if not allowed else tried
        self.assertNotEqual(advice["tried"], tried)

    def test_a_refusal_has_a_reason(self):
        advice = talus.Scene.parse(BALL).advise("ball.vx.max", accuracy=1e-3)
        self.assertEqual(advice["refusal"]["kind"], "vanishing")
        self.assertNotIn("advice", advice)

    def test_limits_are_kept(self):
        scene = talus.Scene.parse(BALL)
        few = scene.advise("ball.y.end", accuracy=1e-6, evaluations=2000)
        self.assertIn("refusal", few)
        self.assertLess(few["evaluations_of_pilots"], 200_000)
        with self.assertRaisesRegex(talus.InputError, "accuracy"):
            scene.advise("ball.y.end", accuracy=2.0)
        with self.assertRaisesRegex(talus.InputError, "'ball.z.end'|'ball.z'"):
            scene.advise("ball.z.end", accuracy=1e-3)


class Checks(unittest.TestCase):
    def test_the_numbers_of_a_ball(self):
        scene = talus.Scene.parse(BALL)
        found = scene.check()
        omega = math.sqrt(20e3 / 2.0)
        self.assertTrue(found["usable"])
        self.assertEqual(found["warnings"], [])
        (spring,) = found["springs"]
        self.assertEqual((spring["name"], spring["contact"], spring["stiffness"]), ("impact", True, 20e3))
        self.assertAlmostEqual(spring["effective_mass"], 2.0, delta=1e-14)
        self.assertAlmostEqual(found["highest_frequency"], omega, delta=1e-10 * omega)
        self.assertAlmostEqual(spring["damping_ratio"], spring["damping"] / (2 * math.sqrt(20e3 * 2.0)), delta=1e-14)
        self.assertEqual(found["shortest_contact"], spring["contact_time"])
        # The limit of velocity Verlet with lagged damping is below 2/omega.
        self.assertLess(found["step_limit"], 2 / omega)
        self.assertGreater(found["step_limit"], 1 / omega)
        self.assertEqual((found["integrator"], found["step"]), ("velocity_verlet", 0.2e-3))

    def test_a_step_beyond_the_limit(self):
        found = talus.Scene.parse(BALL).changed({"run.step": "50 ms", "run.interval": "50 ms"}).check()
        self.assertFalse(found["usable"])
        self.assertIn("the linear limit of velocity_verlet", found["warnings"][0])
        self.assertIn("`scene.run(integrator='auto')` chooses its own steps", found["warnings"][0])

    def test_warnings_are_those_of_the_program(self):
        text = BALL.replace('"0.3 m"', '"0.09 m"')
        warnings = talus.Scene.parse(text).check()["warnings"]
        self.assertEqual(len(warnings), 1)
        with tempfile.TemporaryDirectory() as folder:
            ended = subprocess.run([os.environ["TALUS"], "check", text_file(folder, "b.toml", text)],
                                   capture_output=True, text=True)
        self.assertIn(warnings[0], ended.stderr)


class Sweeps(unittest.TestCase):
    def test_a_file_gives_what_the_program_collects(self):
        with tempfile.TemporaryDirectory() as folder:
            text_file(folder, "ball.toml", BALL)
            sweep = text_file(folder, "sweep.toml", """
base = "ball.toml"
outputs = ["ball.y.max", "impact.force.max"]
[[axis]]
field = "body.ball.mass"
values = ["1 kg", "2 kg", "-1 kg"]
[[axis]]
field = "run.step"
values = ["0.2 ms", "0.1 ms", "1e200 s"]
[limits]
evaluations = 8000
""")
            out = Path(folder) / "out"
            program("sweep", "plan", sweep, "--out", out)
            program("sweep", "run", out, code=6)
            program("sweep", "collect", out, code=6)
            with open(out / "results.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            planned = talus.read_sweep(sweep)
            table = talus.sweep(**planned)
        self.assertEqual(planned["outputs"], ["ball.y.max", "impact.force.max"])
        self.assertEqual(len(planned["runs"]), 9)
        self.assertEqual(planned["runs"][0], {"body.ball.mass": "1 kg", "run.step": "0.2 ms"})
        self.assertEqual(list(table["end"]), [row["end"] for row in rows])
        # The folder of a sweep has a copy of its base, of another name.
        self.assertEqual([reason.replace(str(Path(folder) / "ball.toml"), "base.toml") for reason in table["reason"]],
                         [row["reason"] for row in rows])
        self.assertEqual(set(table["end"]), {"finished", "limited", "refused"})
        for row, height, force, count in zip(rows, table["ball.y.max"], table["impact.force.max"],
                                             table["evaluations"]):
            self.assertEqual(int(row["evaluations"]), count)
            of_program = row["ball.y.max [m]"]
            self.assertEqual(of_program == "", math.isnan(height))
            if of_program:
                self.assertEqual((float(of_program), float(row["impact.force.max [N]"])), (height, force))

    def test_the_same_for_any_number_of_threads(self):
        fence = talus.Scene.read(str(CASES / "fence/table_2.toml"))
        runs = [{"fence.rock[0].mass": f"{mass} lb"} for mass in (300, 600, 900)]
        one, two = (talus.sweep(fence, runs, ["fence.anchor_force"], threads=n) for n in (1, 2))
        self.assertEqual(one["verdict"], two["verdict"])
        np.testing.assert_array_equal(one["fence.anchor_force"], two["fence.anchor_force"])
        self.assertEqual(len(set(one["fence.anchor_force"])), 3)

    def test_runs_with_a_reason(self):
        table = talus.sweep(talus.Scene.parse(BALL), [{}, {"body.ball.mass": "-1 kg"}], ["ball.y.end"])
        self.assertEqual(table["end"], ["finished", "refused"])
        self.assertEqual(table["reason"][0], "")
        self.assertIn("it must be > 0", table["reason"][1])
        self.assertTrue(math.isnan(table["ball.y.end"][1]))
        limited = talus.sweep(talus.Scene.parse(BALL), [{}], ["ball.y.end"], evaluations=100)
        self.assertEqual((limited["end"], limited["reason"]), (["limited"], ["limit of 100 evaluations"]))
        limited = talus.sweep(talus.Scene.parse(BALL), [{"run.end": "9000 s", "run.interval": "1 s"}], [], time=0.05)
        self.assertEqual((limited["end"], limited["reason"]), (["limited"], ["limit of 0.05 s"]))

    def test_errors(self):
        scene = talus.Scene.parse(BALL)
        with self.assertRaisesRegex(talus.InputError, "outputs: "):
            talus.sweep(scene, [{}], ["ball.z.end"])
        with self.assertRaisesRegex(talus.InputError, "outputs: found 'ball.y.end' twice; remove one"):
            talus.sweep(scene, [{}], ["ball.y.end", "ball.y.end"])
        with self.assertRaisesRegex(talus.InputError, "are the same field"):
            talus.sweep(scene, [{}, {"body.ball.mass": "1 kg", "body[0].mass": "9 kg"}], [])
        with self.assertRaisesRegex(talus.InputError, "evaluations: found -1"):
            talus.sweep(scene, [{}], [], evaluations=-1)
        for threads in (-1, 2000):
            with self.assertRaisesRegex(talus.InputError, f"threads: found {threads}; it must be between 0 and 1024"):
                talus.sweep(scene, [{}], [], threads=threads)
        with self.assertRaisesRegex(talus.InputError, "time: found -1"):
            talus.sweep(scene, [{}], [], time=-1)
        with self.assertRaises(talus.IoError):
            talus.read_sweep("no_such.toml")
        with tempfile.TemporaryDirectory() as folder:
            text_file(folder, "ball.toml", BALL)
            for field, message in (("body[0].mass", "'body.ball.mass' and 'body\\[0\\].mass' are the same field"),
                                   ("body.bal.mass", "'body.bal.mass'")):
                axes = "".join(f'[[axis]]\nfield = "{name}"\nvalues = ["1 kg"]\n'
                               for name in ("body.ball.mass", field))
                file = text_file(folder, "same.toml", f'base = "ball.toml"\noutputs = ["ball.y.end"]\n{axes}')
                with self.assertRaisesRegex(talus.InputError, message) as raised:
                    talus.read_sweep(file)
                self.assertEqual(raised.exception.file, file)

    def test_whole_numbers_of_a_field_that_takes_others(self):
        with tempfile.TemporaryDirectory() as folder:
            text_file(folder, "ball.toml", BALL)
            file = text_file(folder, "whole.toml", 'base = "ball.toml"\noutputs = ["ball.y.end"]\n[[axis]]\n'
                             'field = "run.tolerance"\nrange = [0, 1]\ncount = 2\n[[axis]]\n'
                             'field = "run.integrator"\nvalues = ["stormer_cowell"]\n')
            with self.assertRaisesRegex(talus.InputError, "range: found whole numbers for 'run.tolerance'"):
                talus.read_sweep(file)

    def test_no_runs(self):
        table = talus.sweep(talus.Scene.parse(BALL), [], ["ball.y.end"])
        self.assertEqual((table["end"], len(table["ball.y.end"])), ([], 0))


if __name__ == "__main__":
    unittest.main()
