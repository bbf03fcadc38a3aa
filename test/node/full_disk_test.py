#!/usr/bin/python3
"""Where the disk is full a save and a recipe's results fail with the reason, and what was there
stays as it was."""

import os
import shutil
import signal
import subprocess
import tempfile
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray

from origami_client import Recorder
from own_node import OwnNode, limit_files, program

LARGEST_FILE = 1000  # [bytes]
RECIPE = ('sheet: {size: [0.1, 0.05], max_edge: 0.02}\nsteps:\n'
          '  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: 90}]\n    duration: 0.1\n')
REASON = 'File too large'  # a full disk's is "No space left on device"


class FullDiskTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.out = os.path.join(self.folder, 'out')
        os.mkdir(self.out)
        self.old = {name: 'old ' + name for name in
                    ('diagrams.fold', 'final.fold', 'final.obj', 'frames.fold', 'report.json')}
        for name, text in self.old.items():
            with open(os.path.join(self.out, name), 'w') as old:
                old.write(text)
        self.recipe = os.path.join(self.folder, 'strip.yaml')
        with open(self.recipe, 'w') as recipe:
            recipe.write(RECIPE)

    def contents(self):
        texts = {}
        for name in os.listdir(self.out):
            with open(os.path.join(self.out, name)) as written:
                texts[name] = written.read()
        return texts

    def node(self, **parameters):
        node = OwnNode('crowded', largest_file=LARGEST_FILE, **parameters)
        self.addCleanup(node.end, signal.SIGTERM)
        return node

    def test_save(self):
        origami = self.node(paused=True).origami
        before = origami.state()
        for name in ('final.fold', 'final.obj', 'new.stl', 'new.ply'):
            path = os.path.join(self.out, name)
            answer = origami.call('save', path=path)
            self.assertFalse(answer.success)
            self.assertEqual(answer.message, 'cannot write %s: %s' % (path, REASON))
        self.assertEqual(self.contents(), self.old)
        self.assertEqual(origami.state().positions, before.positions)
        origami.do('step', steps=1)

    def test_results_of_a_recipe(self):
        diagnostics = Recorder('/diagnostics', DiagnosticArray)
        origami = self.node(recipe=self.recipe, output=self.out).origami
        diagnostics.wait(lambda array: any(REASON in s.message for s in array.status))
        self.assertEqual(self.contents(), self.old)
        # The paper is folded, and paused.
        self.assertGreater(abs(origami.state().creases[0].rest_angle), 1.5)
        origami.do('step', steps=1)

    def test_results_of_the_batch_tool(self):
        batch = subprocess.run(
            [program('origami_batch'), self.recipe, '--out', self.out], restore_signals=False,
            preexec_fn=lambda: limit_files(LARGEST_FILE), stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)
        self.assertEqual((batch.returncode, batch.stdout), (1, ''))
        self.assertEqual(batch.stderr, 'origami_batch: cannot write %s/frames.fold: %s\n' %
                         (self.out, REASON))
        self.assertEqual(self.contents(), self.old)


if __name__ == '__main__':
    rospy.init_node('full_disk_test')
    rostest.rosrun('shell_origami', 'full_disk_test', FullDiskTest)
