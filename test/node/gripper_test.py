#!/usr/bin/python3
"""Two grippers lift the edge of a sheet, fold it over, and let go; it stays folded."""

import math
import os
import queue
import signal
import subprocess
import threading
import time
import unittest

import rosnode
import rospy
import rostest
from geometry_msgs.msg import WrenchStamped

from origami_client import Recorder
from shell_origami.msg import Edit, SheetState

SIDE = 0.15
WEIGHT = 800 * 2e-4 * SIDE * SIDE * 9.81  # [N]
FRAMES = ('gripper_left', 'gripper_right', 'world')
LAUNCH = ['roslaunch', 'shell_origami', 'gripper.launch', 'rviz:=false', 'clock:=lead',
          'real_time_factor:=2']
# Debian 11's roslaunch keeps what it says to itself until it ends.
AT_ONCE = dict(os.environ, PYTHONUNBUFFERED='1')


class GripperTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.states = Recorder('/origami/state', SheetState)
        cls.edits = Recorder('/origami/edits', Edit)
        cls.wrenches = {frame: Recorder('/origami/wrench/' + frame, WrenchStamped)
                        for frame in FRAMES}
        cls.launched = subprocess.Popen(LAUNCH, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        universal_newlines=True, env=AT_ONCE)
        cls.lines = queue.Queue()
        # Whatever fails from here on, nothing is left running.
        cls.addClassCleanup(cls.end)
        cls.reader = threading.Thread(target=cls.read)
        cls.reader.start()
        cls.said = cls.listen(60)
        cls.state = cls.states.wait(lambda state: state.settled and state.header.stamp >
                                    cls.edit('unpin').header.stamp)

    @classmethod
    def end(cls):
        cls.launched.send_signal(signal.SIGINT)
        cls.launched.wait()
        cls.reader.join()

    @classmethod
    def read(cls):
        with cls.launched.stdout as lines:
            for line in lines:
                cls.lines.put(line)

    @classmethod
    def listen(cls, seconds):
        """What is said until the grippers have done."""
        deadline, said = time.time() + seconds, ''
        while '[gripper_demo' not in said.split('started with pid')[-1]:
            try:
                said += cls.lines.get(timeout=max(0, deadline - time.time()))
            except queue.Empty:
                raise AssertionError('the grippers do not come to an end: ' + said)
        return said

    @classmethod
    def edit(cls, kind, frame=None):
        return cls.edits.wait(lambda edit: edit.kind == kind and
                              (frame is None or edit.frame_id == frame))

    def between(self, first, last):
        return [state for state in self.states.all()
                if first.header.stamp < state.header.stamp < last.header.stamp]

    def test_it_ends_well_and_the_paper_goes_on(self):
        self.assertIn('finished cleanly', self.said.splitlines()[-1], self.said)
        phases = ['approach', 'grips', 'lift', 'hold up', 'fold it over', 'let go', 'stays folded']
        places = [self.said.find(phase) for phase in phases]
        self.assertNotIn(-1, places, self.said)
        self.assertEqual(places, sorted(places))
        self.assertTrue(rosnode.rosnode_ping('/origami', max_count=1, verbose=False))

    def test_the_corners_are_carried_over_in_an_arc(self):
        way = self.between(self.edit('fold'), self.edit('unpin'))
        for frame in FRAMES[:2]:
            held = self.edit('pin', frame).vertices
            self.assertGreater(len(held), 1)
            for v in held:
                heights = [state.positions[v].z for state in way]
                self.assertGreater(max(heights), 0.06)
                self.assertLess(heights[0], 0.001)
                self.assertLess(heights[-1], 0.01)
                self.assertLess(way[-1].positions[v].x, 0.02)

    def test_the_crease_bends_as_the_edge_goes(self):
        # A sheet that is creased where the arc has its middle goes over nearly flat. On a busy
        # machine transforms come late, and the edge follows the grippers that much behind the fold.
        v = self.edit('pin', FRAMES[0]).vertices[0]
        for state in self.between(self.edit('fold'), self.edit('unpin'))[::10]:
            place = state.positions[v]
            arc = math.atan2(place.z, place.x - SIDE / 2)
            self.assertAlmostEqual(state.creases[0].angle, arc, delta=math.radians(30))

    def test_nothing_goes_through_the_table(self):
        for state in self.between(self.edit('fold'), self.edit('unpin'))[30:] + [self.state]:
            self.assertGreater(min(p.z for p in state.positions), -0.001)

    def test_it_stays_folded_when_they_have_let_go(self):
        on_table = self.states.wait(lambda state: state.pinned).pinned
        self.assertGreater(len(on_table), 100)
        self.assertEqual(self.state.pinned, on_table)
        angle = math.degrees(self.state.creases[0].angle)
        self.assertGreater(angle, 160)
        self.assertLess(angle, 178)

    def test_what_the_edge_weighs_is_felt(self):
        # Level and at rest the edge and the table share the half that hangs between them, evenly if
        # both held it all along.
        rest = self.edit('fold').header.stamp - rospy.Duration(0.05)
        up = {frame: [m for m in recorder.all() if m.header.stamp <= rest][-1].wrench.force.z
              for frame, recorder in self.wrenches.items()}
        self.assertAlmostEqual(sum(up.values()) / WEIGHT, 1, delta=0.02)
        share = (up['gripper_left'] + up['gripper_right']) / WEIGHT
        self.assertGreater(share, 0.15)
        self.assertLess(share, 0.30)


if __name__ == '__main__':
    rospy.init_node('gripper_test')
    rostest.rosrun('shell_origami', 'gripper_test', GripperTest)
