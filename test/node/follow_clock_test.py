#!/usr/bin/python3
"""With clock: follow, simulation time keeps pace with /clock, which this test publishes."""

import time

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Clock, Log
from sensor_msgs.msg import CameraInfo

from moving_frame import MovingFrame
from origami_client import NodeTest, Origami, Recorder, repeat

STEP = 1.0 / 60


class FakeClock(object):
    """Publishes /clock at about twice the wall clock's pace, from `seconds` on, while it runs."""

    def __init__(self):
        self.publisher = rospy.Publisher('/clock', Clock, queue_size=10)
        self.seconds = 100.0
        self.running = True
        repeat(self._tick, 0.01)

    def _tick(self):
        if self.running:
            self.seconds += 0.02
        self.publisher.publish(Clock(rospy.Time.from_sec(self.seconds)))


class FollowClockTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.clock = FakeClock()
        cls.origami = Origami()

    def setUp(self):
        self.clock.running = True
        self.origami.do('resume')
        # The test before may have left the clock elsewhere: its states are not to be taken for new ones.
        self.origami.states.wait(
            lambda state: abs(state.header.stamp.to_sec() - self.clock.seconds) < 0.3,
            since=len(self.origami.states.all()))

    def stamp(self):
        state = self.origami.states.wait(since=len(self.origami.states.all()), timeout=2)
        return state.header.stamp.to_sec()

    def test_keeps_pace(self):
        start = self.stamp()
        self.origami.states.wait(lambda state: state.header.stamp.to_sec() > start + 2)
        self.assertAlmostEqual(self.stamp(), self.clock.seconds, delta=0.3)

    def test_stands_still_with_the_clock_and_answers(self):
        self.clock.running = False
        seen = len(self.origami.states.all())
        self.origami.do('pin', vertices=[0])
        self.origami.do('unpin')
        time.sleep(0.3)  # in which no time passes
        for state in self.origami.states.all()[seen:]:
            self.assertLess(state.header.stamp.to_sec(), self.clock.seconds + 2 * STEP)

    def test_goes_on_after_a_jump_back(self):
        self.clock.seconds = 50.0
        self.origami.states.wait(lambda state: 50 < state.header.stamp.to_sec() < 90)
        self.assertAlmostEqual(self.stamp(), self.clock.seconds, delta=0.3)

    def test_steps_while_paused_advance_time_exactly_and_nothing_else_does(self):
        self.origami.do('pause')
        start = self.origami.do('step', steps=1).time
        self.origami.stand_still()  # a second of ROS time, in which no time of the paper's passes
        self.assertAlmostEqual(self.origami.do('step', steps=60).time, start + 60 * STEP, delta=1e-9)
        self.clock.running = False
        self.assertAlmostEqual(self.origami.do('step', steps=60).time, start + 120 * STEP,
                               delta=1e-9)

    def jump(self, seconds):
        self.clock.seconds = seconds
        self.origami.states.wait(lambda state: abs(state.header.stamp.to_sec() - seconds) < 100)

    def test_jumps_of_a_hundred_years_end_nothing(self):
        frame = MovingFrame('far')
        seen = Recorder('/origami/depth/camera_info', CameraInfo)  # from there, until the last test ends
        self.origami.do('pin', vertices=[0], frame_id='far')
        self.jump(1.0)
        self.jump(4.0e9)
        # Time runs on from there, and the paper still hears of frames and is seen from them.
        seen.wait(lambda info: info.header.stamp.to_sec() >= 4.0e9)
        stamp = self.stamp()
        self.origami.states.wait(lambda state: state.header.stamp.to_sec() > stamp + 1)
        self.origami.do('unpin')
        self.origami.do('pin', vertices=[1], frame_id='far')
        frame.silent = True
        self.jump(100.0)
        self.origami.do('unpin')

    def test_the_end_of_ros_time_ends_nothing(self):
        said = Recorder('/rosout', Log)
        self.clock.running = False
        self.jump(2.0 ** 32 - 1)
        said.wait(lambda log: 'no diagnostics are published' in log.msg)
        self.jump(100.0)

    def test_a_jump_forward_is_not_made_up_for(self):
        diagnostics = Recorder('/diagnostics', DiagnosticArray)
        jump = self.clock.seconds + 1000
        self.clock.seconds = jump
        self.origami.states.wait(lambda state: state.header.stamp.to_sec() > jump)
        self.origami.do('pause')
        time_now = self.origami.do('step', steps=1).time
        self.assertLess(time_now, 100)
        # By how much it fell behind is told.
        behind = [s for s in diagnostics.wait(lambda m: m.status[1].level == 1).status
                  if s.name == 'origami: pace'][0]
        self.assertIn('falls behind', behind.message)
        dropped = {value.key: float(value.value) for value in behind.values}
        self.assertAlmostEqual(dropped['dropped'], 1000, delta=1)
        self.assertGreaterEqual(dropped['dropped_so_far'], dropped['dropped'])


if __name__ == '__main__':
    rospy.init_node('follow_clock_test')
    rostest.rosrun('shell_origami', 'follow_clock_test', FollowClockTest)
