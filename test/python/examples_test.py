#!/usr/bin/python3
"""The examples in Python: the environment gives the same for the same seed, and a sweep over workers gives
what one process gives, also where a worker is killed on the way."""

import os
import signal
import subprocess
import sys
import unittest

import numpy as np
from distributed import Client, LocalCluster

EXAMPLES = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'examples')
sys.path.insert(0, EXAMPLES)

import sweep  # noqa: E402
from fold_env import MOST_FOLDS, FoldEnv  # noqa: E402


def episode(seed):
    env, actions, seen = FoldEnv(), np.random.default_rng(seed), []
    seen.append(env.reset(seed=seed)[0])
    done = False
    while not done:
        observation, reward, terminated, truncated, _ = env.step(actions.uniform(-1, 1, 5))
        seen.append(np.append(observation, reward))
        done = terminated or truncated
    return seen


class EnvironmentTest(unittest.TestCase):
    def test_the_same_seed_gives_the_same(self):
        first, second, other = episode(3), episode(3), episode(4)
        self.assertEqual(len(first), len(second))
        for a, b in zip(first, second):
            self.assertTrue((a == b).all())
        self.assertFalse((first[0] == other[0]).all())
        self.assertLessEqual(len(first), MOST_FOLDS + 1)

    def test_a_fold_that_is_rejected_costs_little_and_is_told(self):
        env = FoldEnv()
        before, _ = env.reset(seed=1)
        after, reward, _, _, info = env.step([0.1, 0.1, 0.1, 0.1, 0.5])  # both points of the line are one
        self.assertTrue((before == after).all())
        self.assertLess(reward, 0)
        self.assertNotEqual(info['rejected'], '')

    def test_it_runs_as_a_program(self):
        said = subprocess.run([sys.executable, os.path.join(EXAMPLES, 'fold_env.py')], check=True,
                              stdout=subprocess.PIPE, universal_newlines=True).stdout
        self.assertEqual(len(said.strip().split('\n')), 5)


class SweepTest(unittest.TestCase):
    def test_a_worker_that_is_killed_loses_nothing(self):
        seeds = list(range(8))
        expected = [sweep.fold_paper(seed) for seed in seeds]
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
            with Client(cluster) as client:
                pids = list(client.run(os.getpid).values())
                self.assertEqual(len(pids), 2)
                killed = []

                def tell(done):
                    if done == 2:
                        os.kill(pids[0], signal.SIGKILL)
                        killed.append(pids[0])
                self.assertEqual(sweep.sweep(client, seeds, tell), expected)
                self.assertEqual(len(killed), 1)
                self.assertNotIn(pids[0], client.run(os.getpid).values())


if __name__ == '__main__':
    unittest.main()
