#!/usr/bin/python3
"""Killed, a node goes on from its checkpoint; ended cleanly it loses nothing."""

import json
import os
import shutil
import signal
import subprocess
import tempfile
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import Point

from origami_client import Origami, Recorder, line, wait_until
from shell_origami import msg

PERIOD = 0.5
STEP = 1.0 / 60
RECIPE = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'half_fold.yaml')


class Node(object):
    def __init__(self, *parameters):
        program = roslib.packages.find_node('shell_origami', 'origami_node')[0]
        self.process = subprocess.Popen(
            [program, '__name:=origami', '_publish_rate:=1000', '_checkpoint/period:=%g' % PERIOD] +
            ['_%s:=%s' % parameter for parameter in parameters],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)

    def end(self, how):
        self.process.send_signal(how)
        return self.process.wait(10)

    def said(self):
        return self.process.communicate(timeout=10)[0]


class CheckpointTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.file = os.path.join(self.folder, 'run.checkpoint')
        self.states = Recorder('/origami/state', msg.SheetState)
        self.nodes = []
        self.addCleanup(self.end_nodes)

    def end_nodes(self):
        for node in self.nodes:
            if node.process.poll() is None:
                node.process.kill()
            node.process.wait()
            node.process.stdout.close()
        self.states.subscriber.unregister()
        for name in ('recipe', 'output', 'paused', 'checkpoint', 'publish_rate', 'sheet',
                     'fold_duration'):
            if rospy.has_param('/origami/' + name):
                rospy.delete_param('/origami/' + name)

    def start(self, *parameters):
        node = Node(('checkpoint/file', self.file), *parameters)
        self.nodes.append(node)
        return node

    def wait_for(self, wanted, since=0):
        return self.states.wait(wanted, since=since, timeout=20)

    def wait_for_checkpoint(self):
        """Waits until the next one is written."""
        def written():
            return os.path.exists(self.file) and os.stat(self.file).st_mtime_ns
        before = written()
        wait_until(lambda: written() not in (False, before), self.file + ' is written')

    def test_killed_in_a_recipe_it_goes_on_to_the_bit(self):
        output = os.path.join(self.folder, 'results')
        parameters = [('recipe', RECIPE), ('output', output)]
        node = self.start(*parameters)
        self.wait_for(lambda s: s.creases and 0.4 < s.creases[0].angle < 1.2)
        self.wait_for_checkpoint()
        # Steps beyond the checkpoint, which are to be taken again.
        saved = self.states.all()[-1].step
        self.wait_for(lambda s: s.step > saved + 5)
        node.end(signal.SIGKILL)
        before = {(s.edits, s.step): s for s in self.states.all()}
        last = max(step for _, step in before)
        self.assertFalse(os.path.exists(os.path.join(output, 'report.json')))

        since = len(self.states.all())
        node = self.start(*parameters)
        self.wait_for(lambda s: os.path.exists(os.path.join(output, 'report.json')), since)
        after = self.states.all()[since:]
        # A checkpoint takes a moment, too.
        self.assertGreater(after[0].step, last - (PERIOD + 0.2) / STEP)
        again = [s for s in after if (s.edits, s.step) in before]
        for state in again:
            then = before[(state.edits, state.step)]
            self.assertEqual(state.positions, then.positions)
            self.assertEqual([c.angle for c in state.creases], [c.angle for c in then.creases])
        self.assertGreater(len(again), 0)
        self.assertAlmostEqual(after[-1].creases[0].angle, 1.5708, delta=0.1)
        self.assertEqual(node.end(signal.SIGTERM), 0)
        self.assertIn('going on from ' + self.file, node.said())

    def test_a_recipe_goes_on_with_the_parameters_it_was_read_with(self):
        recipe, output = os.path.join(self.folder, 'two.yaml'), os.path.join(self.folder, 'results')
        with open(recipe, 'w') as file:
            file.write('sheet: {size: [0.1, 0.05], max_edge: 0.05}\n'
                       'steps:\n'
                       '  - fold: [{line: [[0.03, 0], [0.03, 0.05]], angle_deg: 20, name: first}]\n'
                       '  - fold: [{line: [[0.07, 0], [0.07, 0.05]], angle_deg: 20, name: second}]\n')
        parameters = [('recipe', recipe), ('output', output), ('fold_duration', '1.5')]
        node = self.start(*parameters)
        self.wait_for(lambda s: s.creases and s.creases[0].angle > 0.05)
        self.wait_for_checkpoint()
        node.end(signal.SIGKILL)
        self.assertFalse(os.path.exists(os.path.join(output, 'report.json')))

        since = len(self.states.all())
        node = self.start(*parameters)
        self.wait_for(lambda s: os.path.exists(os.path.join(output, 'report.json')), since)
        with open(os.path.join(output, 'report.json')) as file:
            self.assertAlmostEqual(json.load(file)['sim_time'], 3.0, delta=3 * STEP)
        self.assertEqual(node.end(signal.SIGTERM), 0)

    def test_a_clean_end_loses_nothing(self):
        node = self.start(('paused', 'true'), ('checkpoint/period', '1000'))
        origami = Origami()
        origami.do('step', steps=3)
        origami.do('fold', line=line(0.05, 0, 0.05, 0.15), angle=1.0)
        origami.do('step', steps=7)
        state = origami.state()
        self.assertEqual(node.end(signal.SIGINT), 0)

        since = len(self.states.all())
        node = self.start()
        again = self.wait_for(lambda s: True, since)
        self.assertEqual((again.step, again.edits, again.revision),
                         (state.step, state.edits, state.revision))
        self.assertEqual(again.positions, state.positions)
        # It is paused, as it was, and knows how the paper was when it was loaded.
        origami = Origami()
        self.assertEqual(origami.state().step, state.step)
        origami.do('reset')
        self.assertEqual(len(origami.state().creases), 0)
        self.assertEqual(node.end(signal.SIGTERM), 0)

    def test_the_side_that_is_looked_at_is_kept(self):
        node = self.start(('paused', 'true'), ('checkpoint/period', '1000'))
        Origami().do('turn_over')
        self.assertEqual(node.end(signal.SIGINT), 0)
        node = self.start()
        points = [msg.Landmark(flat=Point(x, x, 0)) for x in (0, 0.15)]
        fold = Origami().do('fold_through', axiom='bring', points=points, dry_run=True)
        self.assertLess(fold.segments[0].angle, 0)
        self.assertEqual(node.end(signal.SIGTERM), 0)

    def test_a_damaged_checkpoint_stops_the_start(self):
        node = self.start()
        self.wait_for(lambda s: True)
        node.end(signal.SIGTERM)
        with open(self.file, 'rb') as file:
            whole = file.read()
        for content in (b'', b'no checkpoint', whole[:len(whole) // 2], b'\xa0',
                        b'\x81' * 1000000, b'\x7f' * 1000000):
            with open(self.file, 'wb') as file:
                file.write(content)
            node = self.start()
            said = node.said()
            self.assertNotEqual(node.process.returncode, 0, said)
            self.assertIn('checkpoint/file is "%s"' % self.file, said)
            with open(self.file, 'rb') as file:
                self.assertEqual(file.read(), content)

    def test_one_that_cannot_be_written_stops_nothing(self):
        self.file = os.path.join(self.folder, 'nowhere', 'run.checkpoint')
        node = self.start()
        since = len(self.states.all())
        self.wait_for(lambda s: s.step > 2 * PERIOD / STEP, since)
        self.assertEqual(node.end(signal.SIGTERM), 0)
        self.assertIn('no checkpoint: ', node.said())

    def test_a_bad_period_stops_the_start(self):
        for period in ('0', '-1', '.nan', '1e7', 'often'):
            node = Node(('checkpoint/period', period))
            self.nodes.append(node)
            said = node.said()
            self.assertNotEqual(node.process.returncode, 0)
            self.assertIn('checkpoint/period', said)


if __name__ == '__main__':
    rospy.init_node('checkpoint_test')
    rostest.rosrun('shell_origami', 'checkpoint_test', CheckpointTest)
