"""Scenes and runs in other processes, as joblib and Dask start them; skipped where these are not installed."""

import unittest
from importlib.util import find_spec

import numpy as np

import talus
from program import BALL


def run_of(scene, restitution):
    return scene.changed({"contact.impact.restitution": restitution}).run()


class Tasks(unittest.TestCase):
    restitutions = (0.3, 0.6, 0.9)

    def compare(self, runs_of):
        """Compares the runs that `runs_of` gets of the scene with those of this process, bit by bit."""
        scene = talus.Scene.parse(BALL)
        for run, restitution in zip(runs_of(scene), self.restitutions, strict=True):
            self.assertIsInstance(run, talus.Run)
            np.testing.assert_array_equal(run.history, run_of(scene, restitution).history)

    @unittest.skipUnless(find_spec("joblib"), "joblib is not installed (scripts/setup --test)")
    def test_joblib(self):
        from joblib import Parallel, delayed

        self.compare(lambda scene: Parallel(n_jobs=2)(delayed(run_of)(scene, ratio) for ratio in self.restitutions))

    @unittest.skipUnless(find_spec("dask"), "Dask is not installed (scripts/setup --test)")
    def test_dask(self):
        from dask import compute, delayed

        tasks = lambda scene: [delayed(run_of)(scene, ratio) for ratio in self.restitutions]
        self.compare(lambda scene: compute(*tasks(scene), scheduler="processes", num_workers=2))


if __name__ == "__main__":
    unittest.main()
