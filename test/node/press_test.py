#!/usr/bin/python3
"""Two fingers bend a strip over, a roller presses the bend, and the strip keeps a fold."""

import math
import re
import unittest

import rospy
import rostest

from launched_demo import LaunchedDemo
from origami_client import Recorder
from shell_origami.msg import Edit, SheetState

GAP = 0.002  # [m] to which the roller presses
YIELD, HARDENING = 200, 0.4  # of copy paper, [1/m]


class PressTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.states = Recorder('/origami/state', SheetState)
        cls.edits = Recorder('/origami/edits', Edit)
        cls.demo = LaunchedDemo('press.launch', 'press_demo', 'real_time_factor:=0')
        # Whatever fails from here on, nothing is left running.
        cls.addClassCleanup(cls.demo.end)
        cls.said = cls.demo.listen(300)

    def test_it_ends_well(self):
        self.assertIn('finished cleanly', self.said.splitlines()[-1], self.said)
        phases = ['left grasps', 'right grasps', 'bend the end over', 'hold it down',
                  'presses the bend to 2 mm', 'let go', 'keeps a fold']
        places = [self.said.find(phase) for phase in phases]
        self.assertNotIn(-1, places, self.said)
        self.assertEqual(places, sorted(places))

    def test_only_fingers_weight_table_and_roller_touch_the_strip(self):
        self.assertTrue(self.states.all())
        self.assertFalse(any(state.pinned for state in self.states.all()))
        self.assertEqual({edit.kind for edit in self.edits.all()} & {'pin', 'fold'}, set())
        pressed = [state for state in self.states.all() if len(state.obstacles) == 3]
        self.assertGreater(len(pressed), 30)

    def test_the_fold_is_that_of_a_pressed_bend(self):
        # doc/contact.md, "Creases pressed into paper". Yielding changes the shape of the bend, by a
        # twentieth; the roller is no plate.
        expected = (1.332 - 1.690 * math.log(YIELD * GAP)) / (1 + HARDENING)
        kept = math.radians(float(re.search('keeps a fold of ([0-9]+) degrees', self.said).group(1)))
        self.assertAlmostEqual(kept / expected, 1, delta=0.1)


if __name__ == '__main__':
    rospy.init_node('press_test')
    rostest.rosrun('shell_origami', 'press_test', PressTest)
