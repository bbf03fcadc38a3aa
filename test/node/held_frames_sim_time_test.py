#!/usr/bin/python3
"""Time jumps back, and a frame that holds the paper carries it on from there."""

import time

import rospy
import rostest
from rosgraph_msgs.msg import Clock

from moving_frame import MovingFrame
from origami_client import NodeTest, repeat


class PlayedClock(object):
    """/clock at wall pace, from a time that can be set."""

    def __init__(self, start):
        self.publisher = rospy.Publisher('/clock', Clock, queue_size=10)
        self.set(start)
        repeat(self._tick, 0.01)

    def set(self, now):
        self.offset = now - time.time()

    def _tick(self):
        self.publisher.publish(rospy.Time(time.time() + self.offset))


class HeldFramesSimTimeTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.clock = PlayedClock(100)
        super(HeldFramesSimTimeTest, cls).setUpClass()
        cls.hand = MovingFrame('hand')

    def height(self, vertex, wanted):
        """Waits until the vertex is at this height."""
        self.origami.states.wait(lambda s: abs(s.positions[vertex].z - wanted) < 1e-6,
                                 since=len(self.origami.states.all()))

    def test_time_jumps_back(self):
        held = self.origami.do('pin', vertices=[0], frame_id='hand').vertices
        self.origami.do('resume')
        self.hand.go((0, 0, 0.01, 0), 0.5)
        self.height(held[0], 0.01)
        steps = self.origami.states.all()[-1].step

        self.clock.set(50)
        self.hand.go((0, 0, 0.02, 0), 0.5)
        self.height(held[0], 0.02)
        self.hand.go((0, 0, 0.005, 0), 0.5)
        self.height(held[0], 0.005)
        state = self.origami.states.all()[-1]
        self.assertGreater(state.step, steps)
        self.assertLess(state.header.stamp.to_sec(), 60)


if __name__ == '__main__':
    rospy.init_node('held_frames_sim_time_test')
    rostest.rosrun('shell_origami', 'held_frames_sim_time_test', HeldFramesSimTimeTest)
