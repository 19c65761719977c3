"""Scenes from files, texts and dicts: what they hold, and errors of input."""

import errno
import pickle
import tempfile
import unittest
import unittest.mock
from decimal import Decimal
from types import MappingProxyType

import numpy as np

import talus
from program import BALL, CASES, text_file


def ball():
    """The scene of BALL as a dict."""
    return {
        "title": "Ball",
        "units": "SI",
        "gravity": ["0 m/s^2", "-9.81 m/s^2"],
        "body": [
            talus.Table(name="ball", mobility="particle", mass="2 kg", position=("0 m", "0.3 m"),
                        shape={"kind": "circle", "radius": "0.1 m"}),
            MappingProxyType({"name": "floor", "mobility": "fixed", "shape": {"kind": "half_plane"},
                              "position": ["0 m", "0 m"]}),
        ],
        "contact": [{"name": "impact", "between": ["ball", "floor"], "law": "linear_spring_dashpot",
                     "stiffness": "20 kN/m", "restitution": np.float64(0.5)}],
        "run": {"end": "1 s", "step": "0.2 ms", "interval": "10 ms", "integrator": "velocity_verlet"},
    }


class Scenes(unittest.TestCase):
    def test_a_dict_is_the_scene_of_its_text(self):
        of_text, of_dict = talus.Scene.parse(BALL), talus.Scene(ball())
        self.assertEqual(of_text.document, of_dict.document)
        np.testing.assert_array_equal(of_text.run().history, of_dict.run().history)

    def test_what_a_scene_says_of_itself(self):
        scene = talus.Scene.read(str(CASES / "two_cable.toml"))
        self.assertEqual(scene.units, "SI")
        self.assertEqual(talus.Scene.read(str(CASES / "fence/table_2.toml")).units, "US")
        self.assertEqual(scene.bodies, ["particle", "striker"])
        self.assertEqual(scene.cables, ["upper", "lower"])
        self.assertEqual(scene.contacts, ["impact"])
        self.assertEqual(scene.name, "cases/two_cable.toml")
        self.assertIn(scene.integrator, talus.integrators())
        self.assertIn("two_cable", scene.name)
        self.assertTrue(repr(scene).startswith("<talus.Scene '"))
        scene = talus.Scene.parse(BALL)
        self.assertEqual((scene.title, scene.units, scene.step, scene.end), ("Ball", "SI", 0.2e-3, 1.0))
        self.assertEqual((scene.bodies, scene.contacts), (["ball", "floor"], ["impact"]))

    def test_whole_numbers_of_numpy_are_whole(self):
        fence = talus.Scene.read(str(CASES / "fence/table_2.toml"))
        columns = fence.document["fence"]["columns"]
        same = fence.changed({"fence.columns": np.int64(columns)})
        self.assertEqual(same.document, fence.document)

    def test_numbers_of_all_kinds(self):
        scene = talus.Scene.parse(BALL)
        for half in (0.5, np.float32(0.5), np.float64(0.5), np.longdouble(0.5), np.array(0.5), Decimal("0.5")):
            changed = scene.changed({"contact.impact.restitution": half})
            self.assertEqual(changed.document["contact"][0]["restitution"], 0.5)
            self.assertIs(type(changed.document["contact"][0]["restitution"]), float)
        for flag in (True, np.bool_(True), np.array(True)):
            with self.assertRaisesRegex(talus.InputError, "found true"):
                scene.changed({"body.ball.mass": flag})

        class Broken:
            def __index__(self):
                raise ZeroDivisionError("broken")

        with self.assertRaisesRegex(ZeroDivisionError, "broken"):
            scene.changed({"body.ball.mass": Broken()})

    def test_any_mapping_is_a_table(self):
        scene = talus.Scene(MappingProxyType(ball()))
        self.assertEqual(scene.document, talus.Scene(ball()).document)
        same = scene.changed(MappingProxyType({"title": "Other"}))
        self.assertEqual(same.title, "Other")
        for wrong in ([], "x", 3):
            with self.assertRaisesRegex(talus.InputError, "document: found .* it must be a dict"):
                talus.Scene(wrong)

        class NoPairs(dict):
            def items(self):
                return [("a",)]

        with self.assertRaisesRegex(talus.InputError, "not pairs of key and value"):
            talus.Scene(NoPairs())

    def test_changes_make_another_scene(self):
        scene = talus.Scene.parse(BALL)
        heavy = scene.changed({"body.ball.mass": "4 kg", "gravity[1]": "-1.62 m/s^2", "run.ledger": "off"})
        self.assertEqual(heavy.document["body"][0]["mass"], "4 kg")
        self.assertEqual(heavy.document["gravity"], ["0 m/s^2", "-1.62 m/s^2"])
        self.assertEqual(scene.document["body"][0]["mass"], "2 kg")
        self.assertFalse(any(name.startswith("energy.") for name in heavy.run().columns))

    def test_a_deck_of_1993_is_a_fence(self):
        scene = talus.Scene.read(CASES / "fence/sample2.DAT")
        self.assertIn("fence", scene.document)

    def test_scenes_pickle(self):
        for scene in (talus.Scene.parse(BALL, "ball.toml"), talus.Scene(ball()),
                      talus.Scene.read(str(CASES / "fence/table_2.toml"))):
            copy = pickle.loads(pickle.dumps(scene))
            self.assertEqual((copy.document, copy.name), (scene.document, scene.name))

    def test_errors_have_file_line_and_field(self):
        wrong = BALL.replace('mass = "2 kg"', 'mass = "-2 kg"').replace('"20 kN/m"', '"20 kg"')
        with self.assertRaises(talus.InputError) as raised:
            talus.Scene.parse(wrong, "ball.toml")
        first, second = raised.exception.problems
        self.assertEqual(first, ("ball.toml", 8, "body 'ball': mass", 'found "-2 kg"; it must be > 0'))
        self.assertEqual((second.file, second.line, second.field), ("ball.toml", 20, "contact 'impact': stiffness"))
        error = raised.exception
        self.assertEqual((error.file, error.line, error.field), first[:3])
        self.assertIsInstance(error, ValueError)
        self.assertIn("ball.toml:8: body 'ball': mass: found", str(error))

    def test_signatures_have_the_names_of_python(self):
        members = [value for of in vars(talus).values() for value in (of, *getattr(of, "__dict__", {}).values())]
        documented = [member.__doc__ for member in members if isinstance(getattr(member, "__doc__", None), str)]
        self.assertGreater(len(documented), 50)
        self.assertEqual([text for text in documented if "talus::" in text], [])

    def test_errors_are_taken_apart(self):
        scene = talus.Scene.parse(BALL)
        for made, problem in (
            (lambda: scene.run(end="x"), (None, None, "end", 'found "x"; it must be a number with a unit, e.g. "1 s"')),
            (lambda: talus.Scene({"units": "SI", "run": {"end": "1 s"}, "title": "x"}),
             ("scene", None, None, "the scene has no body; it needs at least one")),
            (lambda: scene.run(integrator="verlet"), (None, None, "integrator", unittest.mock.ANY)),
            (lambda: talus.calibrate(restitution=1.6, masses="1 kg", stiffness="1 N/m"),
             (None, None, "restitution", "restitution is 1.6; it must be in (0, 1]")),
            (lambda: scene.changed({"run.stepp": "1 s"}),
             ("scene.toml", unittest.mock.ANY, "run: stepp", unittest.mock.ANY)),
            (lambda: scene.run(end="1e300 s"), (None, None, "run", unittest.mock.ANY)),
            (lambda: scene.changed({"body.bal.mass": "1 kg"}), (None, None, "'body.bal.mass'", unittest.mock.ANY)),
            (lambda: scene.calibrate("impct", restitution=0.5), (None, None, "contact", unittest.mock.ANY)),
            (lambda: talus.Scene.parse(BALL.replace("mass =", "masss ="), "C:\\x.toml"),
             ("C:\\x.toml", 8, "body 'ball': masss", unittest.mock.ANY)),
            (lambda: talus.Scene.parse(BALL.replace('"floor"]', '"flor"]'), "/a:8/b: c.toml"),
             ("/a:8/b: c.toml", 18, "contact 'impact': between", unittest.mock.ANY)),
            (lambda: talus.Scene({**ball(), "units": "S\nI"}), ("scene", None, "units", unittest.mock.ANY)),
            (lambda: talus.calibrate(masses="1 kg", restitution=0.5, stiffness="1 N/m", end_rule="x"),
             (None, None, "end_rule", unittest.mock.ANY)),
            (lambda: talus.Scene({**ball(), "units": 3}, "a script"),
             ("a script", None, "units", "found 3; it must be a text in quotes")),
        ):
            with self.assertRaises(talus.InputError) as raised:
                made()
            self.assertEqual(raised.exception.problems, [problem])
            copy = pickle.loads(pickle.dumps(raised.exception))
            self.assertEqual((copy.problems, str(copy)), ([problem], str(raised.exception)))

    def test_errors_of_a_dict_have_no_line(self):
        wrong = ball()
        wrong["body"][0].mass = "-2 kg"
        with self.assertRaises(talus.InputError) as raised:
            talus.Scene(wrong, "script")
        self.assertEqual(raised.exception.problems,
                         [("script", None, "body 'ball': mass", 'found "-2 kg"; it must be > 0')])

    def test_objects_that_are_no_values(self):
        for field, value in (("mass", 2j), ("mass", None), ("mass", b"2 kg"), ("mass", 1 << 64)):
            wrong = ball()
            wrong["body"][0][field] = value
            with self.assertRaisesRegex(talus.InputError, r"body\[0\]\.mass: found "):
                talus.Scene(wrong)
        for made in (lambda: talus.Scene({3: "x"}), lambda: talus.Scene.parse(BALL).changed({3: "x"})):
            with self.assertRaisesRegex(talus.InputError, "the key 3; it must be a text"):
                made()
        with self.assertRaisesRegex(talus.InputError, r"title: found a text that is not Unicode: a\?"):
            talus.Scene({**ball(), "title": "a\ud800"})
        endless = []
        endless.append(endless)
        with self.assertRaisesRegex(talus.InputError, "more than 100 levels"):
            talus.Scene({"body": endless})
        with self.assertRaisesRegex(talus.InputError, "it must be an array of 2 texts"):
            talus.Scene({**ball(), "contact": [{**ball()["contact"][0], "between": np.zeros(2)}]})

    def test_wrong_changes(self):
        scene = talus.Scene.parse(BALL)
        with self.assertRaisesRegex(talus.InputError, "bal"):
            scene.changed({"body.bal.mass": "3 kg"})
        with self.assertRaisesRegex(talus.InputError, "mass: found \"3 m\""):
            scene.changed({"body.ball.mass": "3 m"})

    def test_two_names_of_one_field(self):
        with self.assertRaisesRegex(talus.InputError, "'body.ball.mass' and 'body\\[0\\].mass' are the same field"):
            talus.Scene.parse(BALL).changed({"body.ball.mass": "3 kg", "body[0].mass": "4 kg"})

    def test_files_that_cannot_be_read(self):
        with self.assertRaisesRegex(talus.IoError, "no_such.toml"):
            talus.Scene.read("no_such.toml")
        self.assertTrue(issubclass(talus.IoError, OSError))
        with self.assertRaises(FileNotFoundError) as raised:
            talus.Scene.read("no_such.toml")
        for error in (raised.exception, pickle.loads(pickle.dumps(raised.exception))):
            self.assertIsInstance(error, talus.IoError)
            self.assertEqual((error.errno, error.filename), (errno.ENOENT, "no_such.toml"))
            self.assertEqual(str(error), "no_such.toml: " + error.strerror)
        with self.assertRaises(talus.IoError) as raised:
            talus.Scene.read("/")
        self.assertEqual(raised.exception.errno, errno.EISDIR)
        self.assertIsInstance(talus.errors.io_error("a: b.csv: Permission denied"), PermissionError)
        self.assertEqual(talus.errors.io_error("a: b.csv: Permission denied").filename, "b.csv")
        self.assertIsNone(talus.errors.io_error("a: no system's reason").errno)
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(talus.InputError, "not TOML"):
                talus.Scene.read(text_file(folder, "wrong.toml", "a = [1"))
        with self.assertRaisesRegex(talus.InputError, "use talus.Cell"):
            talus.Scene.read(str(next(iter((CASES / "cell").glob("*.toml")))))


class Tables(unittest.TestCase):
    def test_fields_are_attributes(self):
        table = talus.Table(name="ball")
        table.mass = "2 kg"
        self.assertEqual(table, {"name": "ball", "mass": "2 kg"})
        self.assertEqual(table.mass, "2 kg")
        with self.assertRaises(AttributeError):
            table.radius


if __name__ == "__main__":
    unittest.main()
