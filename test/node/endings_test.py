#!/usr/bin/python3
"""SIGINT and SIGTERM end the node cleanly, whatever it does; a recording that is under way is
complete."""

import os
import shutil
import signal
import subprocess
import tempfile
import threading
import unittest

import rosbag
import rosnode
import rospy
import rostest

from origami_client import Recorder, line
from own_node import OwnNode, program
from shell_origami.msg import SheetState

SIGNALS = (signal.SIGINT, signal.SIGTERM)
RECIPE = ('sheet: {size: [0.1, 0.05], max_edge: 0.03}\nsteps:\n'
          '  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: 90}]\n    duration: 1000\n')


class EndingsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.recipe = os.path.join(self.folder, 'long.yaml')
        with open(self.recipe, 'w') as recipe:
            recipe.write(RECIPE)

    def check_end(self, begin=lambda node: None, **parameters):
        for number in SIGNALS:
            node = OwnNode('mortal', **parameters)
            self.addCleanup(node.process.kill)
            begin(node)
            self.assertEqual(node.end(number), 0, number)
            self.assertNotIn(node.name, rosnode.get_node_names(), 'the master has forgotten it')

    def test_paused(self):
        self.check_end(paused=True)

    def test_while_the_paper_folds(self):
        self.check_end(lambda node: node.origami.do(
            'fold', line=line(0, 0, 0.15, 0.15), angle=2.0, duration=5.0))

    def test_amid_long_steps(self):
        def begin(node):
            node.origami.do('fold', line=line(0, 0, 0.15, 0.15), angle=2.0, duration=1000.0)
            stepping = threading.Thread(target=self.step, args=(node,), daemon=True)
            self.addCleanup(stepping.join)
            before = node.origami.state().step
            stepping.start()
            node.origami.states.wait(lambda state: state.step > before)
        self.answers = []
        self.check_end(begin, paused=True)
        for answer in self.answers:
            self.assertRegex(answer.message, 'the node ends$')

    def step(self, node):
        try:
            self.answers.append(node.origami.call('step', steps=100000))
        except rospy.ServiceException:
            pass  # the node ends

    def test_amid_a_recipe(self):
        self.check_end(lambda node: node.origami.states.wait(lambda state: state.step > 3),
                       recipe=self.recipe)

    def test_while_it_waits_for_a_recorder(self):
        self.check_end(wait_for_recorder=True)

    def test_a_recorder_that_does_not_come_is_not_waited_for_for_ever(self):
        node = OwnNode('waiting', wait_for_recorder=True)
        self.addCleanup(node.process.kill)
        # This test listens to all that a recorder listens to, so that the node begins.
        node.origami.states.wait(lambda state: state.step > 0)
        self.assertEqual(node.end(signal.SIGINT), 0)
        rospy.set_param('/alone', {'wait_for_recorder': True})
        alone = subprocess.Popen([program('origami_node'), '__name:=alone'], stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, universal_newlines=True)
        self.addCleanup(alone.kill)
        said, _ = alone.communicate(timeout=60)
        self.assertEqual(alone.returncode, 1)
        self.assertRegex(said, 'FATAL.*wait_for_recorder is true, but nobody')

    def test_while_it_is_recorded(self):
        states = Recorder('/origami/state', SheetState)
        for number in SIGNALS:
            bag = os.path.join(self.folder, 'run%d.bag' % number)
            states.forget()
            launched = subprocess.Popen(
                ['roslaunch', 'shell_origami', 'origami.launch', 'rviz:=false',
                 'recipe:=' + self.recipe, 'record:=' + bag], stdout=subprocess.DEVNULL)
            self.addCleanup(launched.kill)
            states.wait(lambda state: state.step > 30, timeout=30)  # it waited for the recorder
            launched.send_signal(number)
            self.assertEqual(launched.wait(30), 0)
            self.assertEqual([name for name in os.listdir(self.folder) if 'active' in name], [])
            with rosbag.Bag(bag) as recorded:
                self.assertGreater(recorded.get_message_count('/origami/state'), 5)
            self.assertNotIn('/origami', rosnode.get_node_names())


if __name__ == '__main__':
    rospy.init_node('endings_test')
    rostest.rosrun('shell_origami', 'endings_test', EndingsTest)
