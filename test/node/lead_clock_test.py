#!/usr/bin/python3
"""With clock: lead, the node publishes /clock: simulation time, at the pace that was asked for."""

import time

import rospy
import rostest
from rosgraph_msgs.msg import Clock

from origami_client import NodeTest, Origami, Recorder

STEP = 1.0 / 60
FACTOR = 2.0


class LeadClockTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.clock = Recorder('/clock', Clock)
        cls.origami = Origami()

    def setUp(self):
        self.origami.do('pause')

    def test_stamps_are_simulation_time(self):
        before = self.origami.do('step', steps=1).time
        self.origami.stand_still()
        now = self.origami.do('step', steps=6).time
        self.assertAlmostEqual(now, before + 6 * STEP, delta=1e-9)
        for recorder, stamp in ((self.origami.states, lambda m: m.header.stamp),
                                (self.clock, lambda m: m.clock)):
            recorder.wait(lambda m: abs(stamp(m).to_sec() - now) < 1e-6, timeout=2)

    def test_keeps_the_pace_that_was_asked_for(self):
        before = self.origami.do('step', steps=1).time
        self.origami.do('resume')
        began = time.time()
        self.origami.pass_steps(60)
        self.origami.do('pause')
        elapsed = time.time() - began
        after = self.origami.do('step', steps=1).time
        self.assertAlmostEqual((after - before) / (FACTOR * elapsed), 1, delta=0.2)
        clocks = [m.clock for m in self.clock.all()]
        self.assertEqual(clocks, sorted(clocks))


if __name__ == '__main__':
    rospy.init_node('lead_clock_test')
    rostest.rosrun('shell_origami', 'lead_clock_test', LeadClockTest)
