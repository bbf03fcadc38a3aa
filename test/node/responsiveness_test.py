#!/usr/bin/python3
"""While the paper moves the node answers at once and keeps pace; while paused it sleeps."""

import os
import time
import xmlrpc.client

import rosnode
import rospy
import rostest
from geometry_msgs.msg import Point32, Polygon

from origami_client import NodeTest, line

SIDE = 0.15
LOWER_RIGHT = Polygon([Point32(0.01, 0, 0), Point32(SIDE, 0, 0), Point32(SIDE, 0.14, 0)])


def cpu_seconds(pid):
    with open('/proc/%d/stat' % pid) as stat:
        fields = stat.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


class ResponsivenessTest(NodeTest):
    def test_answers_while_the_paper_moves(self):
        held = self.origami.do('pin', region=LOWER_RIGHT).vertices
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.9, duration=2.0)
        name = self.origami.sheet().creases[0].name
        self.origami.do('resume')
        slowest = 0
        for i in range(40):
            start = time.time()
            if i % 2:
                self.origami.do('pin', vertices=held)
            else:
                self.origami.do('fold', crease=name, angle=2.9 - 0.01 * i, duration=1.0)
            slowest = max(slowest, time.time() - start)
            self.origami.pass_steps(2)
        rospy.loginfo('slowest answer: %.1f ms', 1e3 * slowest)
        self.assertLess(slowest, 0.3)
        self.assertGreater(self.origami.state().creases[0].angle, 0.3)

    def test_a_fold_may_interrupt_a_fold(self):
        self.origami.do('resume')
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.0, duration=2.0)
        self.origami.pass_steps(20)
        self.origami.do('fold', line=line(0, SIDE, SIDE, 0), angle=-1.0, duration=0.5)
        self.origami.pass_steps(20)
        self.assertGreaterEqual(len(self.origami.state().creases), 2)

    def test_stamps_grow_and_stay_close_to_now(self):
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.0, duration=0.5)
        seen = len(self.origami.states.all())
        self.origami.do('resume')
        end = time.time() + 1.5
        while time.time() < end:
            state = self.origami.states.wait(since=len(self.origami.states.all()))
            self.assertLess(abs((rospy.Time.now() - state.header.stamp).to_sec()), 0.4)
        states = self.origami.states.all()[seen:]
        stamps = [state.header.stamp for state in states]
        self.assertEqual(stamps, sorted(stamps))
        self.assertGreater(len(states), 20)
        self.assertNotEqual(states[0].positions, states[-1].positions)

    def test_a_paused_node_sleeps(self):
        _, _, pid = xmlrpc.client.ServerProxy(
            rosnode.get_api_uri(rospy.get_master(), '/origami')).getPid('/test')
        start = cpu_seconds(pid)
        rospy.sleep(2)  # over which its work is measured
        self.assertLess(cpu_seconds(pid) - start, 0.2)


if __name__ == '__main__':
    rospy.init_node('responsiveness_test')
    rostest.rosrun('shell_origami', 'responsiveness_test', ResponsivenessTest)
