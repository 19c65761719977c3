"""Shear cells: the numbers of the program, interval by interval, views of the discs, sweeps, errors."""

import copy
import csv
import json
import multiprocessing
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import talus
from program import CASES, talus as program, text_file

# Thirty discs, a short run with outputs at 21 times.
SHORT = {"cell.columns": 6, "cell.rows": 5, "cell.wall_discs": 6, "run.end": "40 ms", "run.every": "2 ms"}


def cell(name="rough.toml", **changes):
    return talus.Cell.read(CASES / "cell" / name).changed({**SHORT, **changes})


def written(scene):
    """What the program writes and prints: history, profile and summary."""
    with tempfile.TemporaryDirectory() as folder:
        toml = text_file(folder, "cell.toml", to_toml(scene.document))
        summary = json.loads(program("cell", toml, "--out", str(Path(folder) / "out"), "--json"))
        tables = []
        for name in ("history.csv", "profile.csv"):
            with open(Path(folder) / "out" / name, newline="") as file:
                rows = list(csv.reader(file))
            tables.append({head: [float(row[i]) for row in rows[1:]] for i, head in enumerate(rows[0])})
    return tables[0], tables[1], summary


def to_toml(document):
    """Tables of numbers and texts."""
    text = "".join(f"{key} = {json.dumps(value)}\n" for key, value in document.items() if not isinstance(value, dict))
    for name, table in document.items():
        if isinstance(table, dict):
            text += f"[{name}]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in table.items())
    return text


def final_height(run):
    """In another process."""
    run.run()
    return float(run.y.max())


class Cells(unittest.TestCase):
    def test_numbers_are_those_of_the_program(self):
        for name in ("rough.toml", "ice.toml", "spheres.toml"):
            with self.subTest(name):
                scene = cell(name)
                history, profile, summary = written(scene)
                run = scene.run()
                self.assertEqual(run.outcome, "finished")
                for found, expected in ((run.history, history), (run.profile, profile)):
                    heads = [f"{column} [{run.unit(column)}]" if run.unit(column) != "1" else column
                             for column in found]
                    self.assertEqual(heads, list(expected))
                    for column, head in zip(found, heads):
                        np.testing.assert_array_equal(found[column], expected[head])
                summary.pop("resume", None), summary.pop("files", None)
                self.assertEqual(run.summary, summary)
                self.assertEqual(run.warnings, summary["warnings"])
                self.assertEqual(run.steps, summary["counts"]["steps"])
                self.assertGreaterEqual(run.evaluations, 1)

    def test_interval_by_interval(self):
        scene = cell()
        whole, parts, rows = scene.run(), talus.CellRun(scene), []
        self.assertIsNone(parts.outcome)
        self.assertTrue(parts.advance())
        self.assertAlmostEqual(parts.time, 2e-3, delta=1.01 * scene.step)
        self.assertEqual(len(parts.history["time"]), 1)
        self.assertTrue(parts.advance(0))
        parts.run(lambda run: rows.append((run.time, run.y.max())), every=3)
        self.assertEqual(len(rows), 7)  # 19 intervals left
        self.assertFalse(parts.advance(10**9))
        np.testing.assert_array_equal(whole.x, parts.x)
        np.testing.assert_array_equal(whole.spin, parts.spin)
        self.assertEqual(whole.summary, parts.summary)
        self.assertEqual(parts.time, rows[-1][0])

    def test_a_callback_stops_the_run(self):
        calls = []
        run = cell().run(lambda seen: calls.append(seen.time) or len(calls) < 4)
        self.assertEqual((len(calls), run.outcome), (4, None))
        self.assertEqual(run.summary["outcome"]["kind"], "stopped")
        self.assertEqual(run.warnings, [])
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            run.run(lambda seen: 1 / 0)

    def test_discs_and_contacts(self):
        scene = cell()
        run = talus.CellRun(scene)
        run.advance(12)
        count = scene.discs + 12
        for numbers in (run.x, run.y, run.vx, run.vy, run.spin, run.radius, run.wall):
            self.assertEqual(len(numbers), count)
        self.assertEqual([int((run.wall == wall).sum()) for wall in (0, 1, 2)], [scene.discs, 6, 6])
        self.assertEqual(len(set(run.vx[run.wall == 2])), 1)
        self.assertEqual(set(run.vx[run.wall == 1]), {0.0})
        self.assertFalse(run.x.flags.writeable)
        contacts = run.contacts
        self.assertGreater(len(contacts["force"]), 0)
        # The contacts are those of the last evaluation, half a step away; x is periodic, with a column for each disc.
        width, moved = 6 * 1e-3, 0.5 * scene.step * 2 * np.hypot(run.vx, run.vy).max()
        for (a, b), normal, overlap in zip(contacts["discs"], contacts["normal"], contacts["overlap"]):
            apart = np.array([run.x[b] - run.x[a], run.y[b] - run.y[a]])
            away = apart - (run.radius[a] + run.radius[b] - overlap) * normal
            away[0] -= width * round(away[0] / width)
            self.assertLess(np.hypot(*away), moved)
            self.assertAlmostEqual(np.hypot(*normal), 1.0, places=12)
        self.assertLess(np.abs(contacts["friction"] / contacts["force"]).max(),
                        scene.document["cell"]["friction"] * (1 + 1e-9))

    def test_without_friction_nothing_turns(self):
        run = talus.CellRun(cell("ice.toml"))
        self.assertEqual((len(run.spin), "spin" in run.profile), (0, False))

    def test_views_and_copies(self):
        run = talus.CellRun(cell())
        y, kept = run.y, run.y.copy()
        run.advance(5)
        np.testing.assert_array_equal(y, run.y)  # a view shows the run as it is
        self.assertFalse(np.array_equal(run.y, kept))
        copied, pickled = copy.deepcopy(run), pickle.loads(pickle.dumps(run))
        for other in (copied, pickled):
            self.assertEqual((other.time, other.steps), (run.time, run.steps))
            np.testing.assert_array_equal(other.x, run.x)
        run.run(), copied.run(), pickled.run()
        for other in (copied, pickled):
            np.testing.assert_array_equal(other.y, run.y)
            self.assertEqual(other.summary, run.summary)
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual(pool.map(final_height, [talus.CellRun(cell())]), [float(run.y.max())])
        self.assertEqual(len(y), len(kept))

    def test_a_run_that_fails(self):
        run = cell(**{"cell.block_speed": "1e6 m/s"}).run()
        self.assertEqual(run.outcome, "diverged")
        self.assertTrue(run.message)
        self.assertEqual(run.summary["outcome"]["message"], run.message)
        copied = pickle.loads(pickle.dumps(run))
        self.assertEqual((copied.outcome, copied.message, copied.summary), (run.outcome, run.message, run.summary))
        self.assertFalse(copied.advance())

    def test_cells_are_not_changed(self):
        scene = cell()
        other = scene.changed({"cell.seed": 5, "title": "Other"})
        self.assertEqual((other.title, scene.document["cell"].get("seed", 0) == 5), ("Other", False))
        self.assertFalse(np.array_equal(other.run().y, scene.run().y))
        again = talus.Cell(scene.document, "again")
        self.assertEqual((again.name, again.units, again.integrator, again.step, again.every, again.end, again.discs),
                         ("again", "SI", scene.integrator, scene.step, 2e-3, 0.04, 30))
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(scene)).run().x, again.run().x)
        self.assertIn("30 discs", repr(scene))
        self.assertIn("t = 0 s, 0 steps", repr(talus.CellRun(scene)))

    def test_sweeps(self):
        scene = cell()
        outputs = ["cell.stress_ratio_top", "cell.depth", "cell.depth.error"]
        found = talus.sweep(scene, [{"cell.seed": 1}, {"cell.seed": 2}, {"cell.mass": "-1 kg"}], outputs)
        self.assertEqual(found["end"], ["finished", "finished", "refused"])
        results = scene.changed({"cell.seed": 2}).run().summary["results"]
        self.assertEqual(found["cell.depth"][1], results["depth"]["value"])
        self.assertEqual(found["cell.depth.error"][1], results["depth"]["error"])
        self.assertEqual(found["cell.stress_ratio_top"][1], results["stress_ratio_top"]["value"])
        self.assertTrue(np.isnan(found["cell.depth"][2]))
        planned = talus.read_sweep(CASES / "sweeps/shear.toml")
        self.assertIsInstance(planned["scene"], talus.Cell)

    def test_errors(self):
        with self.assertRaisesRegex(talus.InputError, "cell: this is a shear cell; use talus.Cell"):
            talus.Scene.read(CASES / "cell/ice.toml")
        with self.assertRaisesRegex(talus.InputError, "cell: it is missing; use talus.Scene for a scene of bodies"):
            talus.Cell.read(CASES / "pendulum.toml")
        with self.assertRaisesRegex(talus.InputError, "CNTRL.DAT has no units"):
            talus.Cell.read(CASES / "cell/CNTRL.DAT")
        with self.assertRaises(talus.InputError) as raised:
            cell(**{"cell.mass": "-1 kg", "cell.columns": 0})
        self.assertEqual(len(raised.exception.problems), 2)
        with self.assertRaisesRegex(talus.InputError, "column 'depht' is not known; nearest: depth"):
            talus.CellRun(cell()).unit("depht")
        with self.assertRaisesRegex(talus.InputError, "^intervals: found -1"):
            talus.CellRun(cell()).advance(-1)
        with self.assertRaisesRegex(talus.InputError, "^every: found 0"):
            talus.CellRun(cell()).run(every=0)
        with self.assertRaises(talus.IoError):
            talus.Cell.read("none.toml")


if __name__ == "__main__":
    unittest.main()
