#!/usr/bin/python3
"""shell_origami.core: the simulation in a Python process, without a master."""

import math
import os
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

from shell_origami import core

SIDE = 0.1
ROOT = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..')


def sheet(**parameters):
    return core.Simulation(SIDE, SIDE, 0.025, parameters)


def folded():
    paper = sheet()
    paper.fold(line=[(0, 0), (SIDE, SIDE)], angle=1.0, duration=0.3, name='diagonal')
    return paper


class CoreTest(unittest.TestCase):
    def test_the_lines_of_the_readme(self):
        with open(os.path.join(ROOT, 'README.md')) as page:
            lines = re.search('```py\n(.*?)```', page.read(), re.DOTALL).group(1)
        said = subprocess.run([sys.executable, '-c', lines], stdout=subprocess.PIPE, check=True,
                              universal_newlines=True).stdout
        self.assertRegex(said, r'^\(\d+, 3\) (1\.00|0\.99)')

    def test_a_sheet(self):
        paper = sheet()
        self.assertEqual(paper.positions.shape, (len(paper.flat_positions), 3))
        self.assertTrue((paper.positions[:, :2] == paper.flat_positions).all())
        a, b, c = (paper.flat_positions[paper.triangles[:, k]] for k in range(3))
        u, v = b - a, c - a
        self.assertAlmostEqual((u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]).sum() / 2, SIDE ** 2, places=12)
        self.assertEqual(paper.creases, [])
        self.assertTrue(paper.settled)

    def test_folds_and_settles(self):
        paper = folded()
        self.assertTrue(paper.folding)
        while not paper.settled:
            paper.step()
        crease, = paper.creases
        self.assertEqual(crease['name'], 'diagonal')
        self.assertAlmostEqual(crease['angle'], 1.0, delta=0.01)
        self.assertEqual(paper.shortfalls(), [])
        self.assertEqual(paper.crossings(), 0)
        paper.fold(crease='diagonal', angle=1.2, duration=0)
        paper.settle()  # at once
        self.assertAlmostEqual(paper.creases[0]['angle'], 1.2, delta=1e-4)

    def test_parameters(self):
        paper = sheet(**{'gravity': [0, 0, -9.81], 'material/air_damping': 0})
        paper.step(6)
        # Newmark's method (gamma 0.6) begins without acceleration: 0.4 of the first step is lost.
        self.assertAlmostEqual(paper.velocities[:, 2].mean(), -9.81 * 5.6 * paper.time_step, places=9)
        self.assertLess(paper.energies['gravity'], 0)

    def test_holds(self):
        paper = sheet(gravity=[0, 0, -9.81])
        held = paper.pin(points=[(0, 0), (SIDE, 0)])
        self.assertEqual(paper.pinned, sorted(held))
        before = paper.positions
        paper.step(10)
        self.assertTrue((paper.positions[held] == before[held]).all())
        self.assertLess(paper.positions[:, 2].min(), -0.001)
        self.assertEqual(paper.unpin(), sorted(held))
        self.assertEqual(paper.pinned, [])

    def test_frames_carry(self):
        paper = sheet()
        held = paper.pin(points=[(0, 0)], frame='hand')
        paper.grasp('soft', points=[(SIDE, SIDE)], stiffness=100, max_force=1, frame='hand')
        paper.add_obstacle('ball', sphere=0.01, position=(0, 0, 0.02), frame='tool')
        steps = 60
        for i in range(1, steps + 1):
            paper.carry('hand', (0, 0, -0.03 * i / steps))
            paper.carry('tool', (0, 0, 0.02 + 0.03 * i / steps))
            paper.step()
        self.assertAlmostEqual(paper.positions[held, 2][0], -0.03, places=12)
        paper.step(120)
        self.assertAlmostEqual(paper.positions[:, 2].mean(), -0.03, delta=1e-3)
        self.assertEqual(paper.wrenches['ball'][0].tolist(), [0, 0, 0])
        with self.assertRaisesRegex(ValueError, 'arm'):
            paper.carry('arm', (0, 0, 0))

    def test_snapshots_are_exact(self):
        paper = folded()
        paper.step(10)
        snapshot = paper.snapshot()
        paper.step(20)
        expected = paper.positions
        paper.restore(snapshot)
        copy = pickle.loads(pickle.dumps(paper))
        for again in (paper, copy, folded()):
            again.step(20 if again.time > 0 else 30)
            self.assertTrue((again.positions == expected).all())

    def test_runs_recipes(self):
        pattern = core.load(os.path.join(ROOT, 'recipes', 'preliminary.yaml'))
        self.assertEqual(pattern.shortfalls(), [])
        paper = sheet()
        warnings = paper.run(text='steps:\n  - fold_through: {bring: [0, 0], to: [0.1, 0.1], angle_deg: 60}\n'
                                  '  - settle: {timeout: 0.1}\n')
        self.assertEqual(len(warnings), 1)
        self.assertIn('had not settled', warnings[0])
        self.assertEqual(len(paper.creases), 1)

    def test_bad_input_is_told_and_changes_nothing(self):
        paper = folded()
        paper.step(5)
        before = paper.snapshot()
        nan = float('nan')
        for words, function in (
                ('nan', lambda: core.Simulation(nan, SIDE, 0.01)),
                ('-0.01', lambda: core.Simulation(SIDE, SIDE, -0.01)),
                ("no 'no'", lambda: sheet(**{'no/such': 1})),
                ('thickness', lambda: sheet(**{'material/thickness': 'thick'})),
                ('(5, 5)', lambda: paper.fold(line=[(5, 5), (6, 6)], angle=1)),
                ('nan', lambda: paper.fold(line=[(0, 0), (SIDE, 0.05)], angle=nan)),
                ('nan', lambda: paper.fold(line=[(0, nan), (SIDE, 0.05)], angle=1)),
                ('3 points', lambda: paper.fold(line=[(0, 0)] * 3, angle=1)),
                ('nobody', lambda: paper.fold(crease='nobody', angle=1)),
                ('one of line and crease', lambda: paper.fold(angle=1)),
                ('1000000', lambda: paper.pin(vertices=[10 ** 6])),
                ('one of vertices and points', paper.pin),
                ('-1', lambda: paper.step(-1)),
                ('no paper', lambda: paper.restore(b'abc')),
                ('no paper', lambda: paper.restore(before[:-5])),
                ('/nowhere', lambda: core.load('/nowhere.yaml')),
                ('steps', lambda: paper.run(text='steps: 3')),
                ('one of path and text', paper.run)):
            with self.assertRaises(ValueError) as raised:
                function()
            self.assertIn(words, str(raised.exception))
            self.assertEqual(paper.snapshot(), before, words)

    def test_a_step_that_does_not_converge_is_an_error(self):
        paper = sheet(**{'solver/max_iterations': 1, 'solver/tolerance': 1e-14})
        paper.fold(line=[(0, 0), (SIDE, SIDE)], angle=3.0, duration=0.0)
        with self.assertRaises(core.SimulationError):
            paper.step(5)
        self.assertTrue(np.isfinite(paper.positions).all())

    def test_other_threads_run_while_it_steps(self):
        counted = [0]
        done = threading.Event()

        def count():
            while not done.wait(0.001):
                counted[0] += 1
        counter = threading.Thread(target=count)
        counter.start()
        paper = core.Simulation(SIDE, SIDE, 0.004)
        paper.fold(line=[(0, 0), (SIDE, SIDE)], angle=2.0)
        before = counted[0]
        paper.step(30)
        done.set()
        counter.join()
        self.assertGreater(counted[0], before)

    def test_an_interrupt_ends_many_steps(self):
        program = ('from shell_origami import core\n'
                   'paper = core.Simulation(0.1, 0.1, 0.005)\n'
                   'paper.fold(line=[(0, 0), (0.1, 0.1)], angle=2.0, duration=1e6)\n'
                   'print("steps", flush=True)\n'
                   'try: paper.step(10 ** 9)\n'
                   'except KeyboardInterrupt: print("interrupted")\n')
        process = subprocess.Popen([sys.executable, '-c', program], stdout=subprocess.PIPE,
                                   universal_newlines=True)
        process.stdout.readline()
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=20)[0], 'interrupted\n')

    def test_angles_are_radians(self):
        paper = sheet()
        paper.fold(line=[(0.05, 0), (0.05, SIDE)], angle=math.radians(90), duration=0)
        paper.settle()
        self.assertAlmostEqual(paper.creases[0]['angle'], math.pi / 2, delta=0.02)


if __name__ == '__main__':
    unittest.main()
