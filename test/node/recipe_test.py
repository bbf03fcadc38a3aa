#!/usr/bin/python3
"""A recipe given as a parameter is carried out as fast as the machine can, recorded from its first
moment, and reported on."""

import json
import math
import os
import shutil
import unittest

import rosbag
import rosnode
import rospy
import rostest

from origami_client import Origami, wait_until


def wait_for(path):
    wait_until(lambda: os.path.exists(path), path + ' is there')


class RecipeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.output = rospy.get_param('/origami/output')
        cls.bag = cls.output + '.bag'
        wait_for(os.path.join(cls.output, 'report.json'))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.output)
        os.remove(cls.bag)

    def test_leaves_its_results(self):
        self.assertEqual(set(os.listdir(self.output)), {'final.fold', 'final.obj', 'report.json'})
        with open(os.path.join(self.output, 'report.json')) as written:
            report = json.load(written)
        self.assertEqual(report['recipe'], 'half_fold')
        self.assertEqual([crease['name'] for crease in report['creases']], ['middle'])
        self.assertAlmostEqual(report['creases'][0]['angle_deg_mean'], 90, delta=3)

    def test_the_node_goes_on(self):
        origami = Origami()
        before = origami.do('step', steps=1).time
        self.assertGreater(origami.do('step', steps=1).time, before)
        state = origami.states.all()[-1]
        self.assertAlmostEqual(state.creases[0].angle, math.pi / 2, delta=0.05)
        self.assertGreater(len(state.pinned), 5)
        self.assertTrue(origami.alive())

    def test_the_recording_is_whole(self):
        rosnode.kill_nodes(['/record'])
        wait_for(self.bag)
        with rosbag.Bag(self.bag) as bag:
            edits = [m for _, m, _ in bag.read_messages(['/origami/edits'])]
            states = [m for _, m, _ in bag.read_messages(['/origami/state'])]
        self.assertEqual([edit.kind for edit in edits], ['paper', 'pin', 'fold'])
        self.assertEqual([edit.step for edit in edits], [0, 0, 0])
        self.assertEqual([edit.number for edit in edits], [0, 1, 2])
        stamps = [state.header.stamp.to_sec() for state in states]
        self.assertLess(stamps[0], 1e-6)
        self.assertLess(max(b - a for a, b in zip(stamps, stamps[1:])), 0.25)
        self.assertGreater(stamps[-1], 0.5)


if __name__ == '__main__':
    rospy.init_node('recipe_test')
    rostest.rosrun('shell_origami', 'recipe_test', RecipeTest)
