#!/usr/bin/python3
"""Two papers side by side, in two namespaces: each has its own names and frames, and follows its own
gripper."""

import os
import subprocess
import unittest

import rosbag
import rosgraph
import rosnode
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import Point32, Polygon

from moving_frame import MovingFrame
from origami_client import Origami, wait_until
from own_node import program

SIDE = 0.15
EDGE = Polygon([Point32(SIDE - 0.001, 0, 0), Point32(SIDE, 0, 0), Point32(SIDE, SIDE, 0),
                Point32(SIDE - 0.001, SIDE, 0)])
NAMES = ('left', 'right')


def connected(topic, way):
    """The nodes that the master has registered as publishers (way 0) or subscribers (1) of a topic.
    A node's name is known before its topics are."""
    return dict(rosgraph.Master(rospy.get_name()).getSystemState()[way]).get(topic, [])


class TwoNodesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.papers = {name: Origami('/%s/origami' % name) for name in NAMES}
        cls.buffer = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.buffer)

    def setUp(self):
        for paper in self.papers.values():
            paper.do('pause')
            paper.do('reset')

    def tearDown(self):
        for paper in self.papers.values():
            self.assertTrue(paper.alive(), paper.name)

    def test_each_follows_its_own_gripper(self):
        grippers = {name: MovingFrame(name + '/gripper') for name in NAMES}
        held = {name: paper.do('pin', region=EDGE, frame_id=name + '/gripper').vertices
                for name, paper in self.papers.items()}
        before = {name: paper.state().positions for name, paper in self.papers.items()}
        for paper in self.papers.values():
            paper.do('resume')
        ways = {'left': (0, 0, 0.04), 'right': (0, -0.03, 0)}
        for name, way in ways.items():
            grippers[name].go(way + (0,), 0.5)

        def arrived(name):
            now = self.papers[name].states.all()[-1].positions
            return all(abs(getattr(now[v], axis) - getattr(before[name][v], axis) - by) < 1e-6
                       for v in held[name] for axis, by in zip('xyz', ways[name]))
        for name in NAMES:
            wait_until(lambda: arrived(name), '%s follows its gripper, and no other' % name)

    def test_each_has_its_own_frames(self):
        for name in NAMES:
            for frame in ('/paper', '/panel_0'):
                wait_until(lambda: self.buffer.can_transform('world', name + frame, rospy.Time()),
                           name + frame)
        for frame in ('paper', 'panel_0'):
            self.assertFalse(self.buffer.can_transform('world', frame, rospy.Time()), frame)

    def test_only_its_own_frames_cannot_hold_a_paper(self):
        MovingFrame('left/panel_gripper')
        left = self.papers['left']
        for frame in ('left/paper', 'left/panel_0', 'left/panel_12'):
            answer = left.call('pin', vertices=[0], frame_id=frame)
            self.assertIn('paper\'s own', answer.message)
            self.assertFalse(answer.success)
        for frame in ('left/panel_gripper', 'right/paper', 'right/panel_0'):
            wait_until(lambda: self.buffer.can_transform('world', frame, rospy.Time()), frame)
            left.do('pin', vertices=[0], frame_id=frame)

    def test_each_has_a_hand_of_its_own(self):
        for name in NAMES:
            hand = '/%s/hand' % name
            wait_until(lambda: self.buffer.can_transform('world', name + '/hand', rospy.Time()), hand)
            wait_until(lambda: hand in connected(hand + '/update', 0), hand + ' shows itself')
            wait_until(lambda: hand in connected('/%s/origami/picked' % name, 1), hand + ' hears clicks')

    def test_what_draws_a_recording_ends_no_node(self):
        painter = subprocess.Popen([program('origami_markers')],
                                   env=dict(os.environ, ROS_NAMESPACE='left'))
        self.addCleanup(painter.wait)
        self.addCleanup(painter.terminate)
        wait_until(lambda: '/left/origami_markers' in connected('/left/origami/state', 1), 'it listens')
        self.assertIsNone(painter.poll())

    def test_z_each_is_recorded_under_its_own_names(self):
        """The last one, for it ends the recordings."""
        rosnode.kill_nodes(['/%s/record' % name for name in NAMES])
        for name in NAMES:
            path = '%s %s.bag' % (rospy.get_param('/bag'), name)
            self.addCleanup(os.remove, path)
            wait_until(lambda: os.path.exists(path), path)
            with rosbag.Bag(path) as bag:
                for topic in ('sheet', 'state', 'edits'):
                    self.assertGreater(bag.get_message_count('/%s/origami/%s' % (name, topic)), 0)


if __name__ == '__main__':
    rospy.init_node('two_nodes_test')
    rostest.rosrun('shell_origami', 'two_nodes_test', TwoNodesTest)
