#!/usr/bin/python3
"""The Python module shell_origami: its methods do what the node's services do, say what the node says,
and show the paper as it is after them."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

from geometry_msgs.msg import Point, PointStamped
import numpy
import rospy
import rostest

from shell_origami import Origami, OrigamiError, core

SIDE = 0.15
ROOT = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..')
RECIPE = '''names: {tip: [0, 0], far: [0.15, 0.15]}
steps:
  - fold_through: {bring: tip, to: far, angle_deg: 60}
    duration: 0.2
  - settle: {timeout: 2}
'''


class PythonClientTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.paper = Origami()

    def setUp(self):
        self.paper.pause()
        self.paper.reset()

    def refused(self, words, function, *arguments, **fields):
        before = self.paper.state()
        with self.assertRaises(OrigamiError) as raised:
            function(*arguments, **fields)
        self.assertIn(words, str(raised.exception))
        self.assertEqual(self.paper.state().edits, before.edits)

    def test_the_lines_of_the_readme(self):
        with open(os.path.join(ROOT, 'README.md')) as page:
            lines = re.search('```python\n(.*?)```', page.read(), re.DOTALL).group(1)
        self.assertLessEqual(len(lines.strip().split('\n')), 10)
        said = subprocess.run([sys.executable, '-c', lines], stdout=subprocess.PIPE, check=True, timeout=60,
                              universal_newlines=True).stdout
        self.assertRegex(said, r"^\['fold_\d+: 1.50 rad'\]\n$")
        self.assertEqual(self.paper.creases(), [])  # it was undone

    def test_folds(self):
        self.paper.resume()
        answer = self.paper.fold(line=[(0.05, 0), (0.05, SIDE)], angle=0.5, duration=0.2)
        state = self.paper.wait_until_settled()
        self.assertGreaterEqual(state.edits, answer.edit)
        crease, = self.paper.creases()
        self.assertEqual([crease.id], list(answer.crease_ids))
        self.assertAlmostEqual(crease.angle, 0.5, delta=0.01)
        self.assertEqual(crease.vertices, tuple(answer.vertices))
        self.paper.fold(crease=crease.name, angle=-0.3, duration=0.2)
        self.paper.wait_until_settled()
        self.assertAlmostEqual(self.paper.creases()[0].angle, -0.3, delta=0.01)
        self.assertEqual(self.paper.sheet().revision, self.paper.state().revision)

    def test_folds_through_layers_by_every_axiom(self):
        for words in (dict(bring=(0, 0), to=(SIDE, SIDE)),
                      dict(edge=[(0, 0), (0, SIDE)], to_edge=[(SIDE, 0), (SIDE, SIDE)]),
                      dict(across=[(0, 0), (SIDE, 0)], at=(0.05, 0), move=(0, 0.1)),
                      dict(through=[(0.05, 0), (0.05, SIDE)], move=(0, 0.1))):
            segments = self.paper.fold_through(dry_run=True, **words).segments
            self.assertEqual(len(segments), 1, words)
        self.assertEqual(self.paper.creases(), [])
        self.refused('a fold through layers takes one of bring, to;', self.paper.fold_through, bring=(0, 0))
        self.refused('is off the paper', self.paper.fold_through, bring=(1, 1), to=(0, 0))
        self.paper.fold_through(bring=(0, 0), to=(SIDE, SIDE))
        self.paper.step(90)
        layers = self.paper.layers((0.12, 0.12))
        self.assertEqual(len(layers.panels), 2)
        in_space = PointStamped(point=Point(SIDE, SIDE, 0))
        in_space.header.frame_id = 'world'
        for layers, count in (('all', 2), (1, 1)):
            segments = self.paper.fold_through(bring=in_space, to=(0.1, 0.1), layers=layers,
                                               dry_run=True).segments
            self.assertEqual(len(segments), count)
        self.paper.turn_over()

    def test_a_recipe_and_its_names(self):
        doing = []
        result = self.paper.fold_recipe(yaml=RECIPE, feedback=lambda news: doing.append(news.doing))
        self.assertAlmostEqual(result.creases[0].angle, 1.047, delta=0.02)
        self.assertIn('fold_through', doing)
        self.paper.fold_through(bring='tip', to='far', angle=2.0, dry_run=True)
        self.refused('yaml', self.paper.fold_recipe, yaml='steps: 3')
        with self.assertRaises(OrigamiError) as late:
            self.paper.fold_recipe(yaml='steps:\n  - wait: 1000\n', timeout=0.5)
        self.assertIn('within 0.5 s', str(late.exception))

    def test_holds_and_lets_go(self):
        self.assertEqual(list(self.paper.pin(points=[(0, 0)]).vertices), [0])
        self.paper.pin(vertices=[1, 2])
        self.paper.pin(region=[(0, 0), (0.04, 0), (0.04, 0.04), (0, 0.04)])
        center = PointStamped(point=Point(SIDE, SIDE, 0))
        center.header.frame_id = 'world'
        self.assertGreater(len(self.paper.pin(center=center, radius=0.02).vertices), 0)
        self.assertGreater(len(self.paper.state().pinned), 4)
        self.paper.unpin([1])
        self.assertNotIn(1, self.paper.state().pinned)
        self.paper.unpin()
        self.assertEqual(list(self.paper.state().pinned), [])
        self.refused('4000', self.paper.pin, vertices=[4000])

    def test_files_steps_and_undo(self):
        edge = self.paper.sheet().triangles[0].vertex_indices[:2]
        self.paper.add_vertex(list(edge), 0.5)
        self.assertEqual(self.paper.state().edits, self.paper.edit)
        before = self.paper.state().positions
        self.paper.fold(line=[(0, 0), (SIDE, SIDE)], angle=1.0)
        start = self.paper.step().time
        self.assertAlmostEqual(self.paper.step(3).time - start, 3 / 60.0, places=6)
        with self.assertRaises(OrigamiError) as moving:
            self.paper.wait_until_settled()
        self.assertIn('is paused', str(moving.exception))
        self.paper.settle()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'paper.fold')
            self.paper.save(path)
            self.paper.load(path)
        self.assertEqual(len(self.paper.creases()), 1)
        self.paper.undo(3)
        self.assertEqual(self.paper.state().positions, before)
        self.refused('no such file', self.paper.load, '/nowhere/paper.fold')

    def test_the_node_and_the_core_give_the_same_bits(self):
        paper = core.Simulation(SIDE, SIDE, 0.03)
        for hand in (self.paper, paper):
            hand.fold(line=[(0, 0), (SIDE, SIDE)], angle=1.0, duration=0.5)
            hand.step(40)
            hand.pin(points=[(SIDE, 0)])
            hand.fold(line=[(0.05, 0), (0.05, SIDE)], angle=-2.0, duration=0.3)
            hand.step(50)
        told = numpy.array([(p.x, p.y, p.z) for p in self.paper.state().positions])
        self.assertTrue((told == paper.positions.astype(numpy.float32)).all())

    def test_no_such_node(self):
        with self.assertRaises(OrigamiError) as gone:
            Origami('/nobody', timeout=0.2)
        self.assertIn('no node /nobody answers', str(gone.exception))
        self.assertEqual(
            subprocess.run([sys.executable, '-c',
                            'from shell_origami import Origami, OrigamiError\n'
                            'try: Origami()\n'
                            'except OrigamiError as error: print(error)'],
                           stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout,
            'rospy.init_node() must be called first\n')


if __name__ == '__main__':
    rospy.init_node('python_client_test')
    rostest.rosrun('shell_origami', 'python_client_test', PythonClientTest)
