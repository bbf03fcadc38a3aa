#!/usr/bin/python3
"""A click at /clicked_point is answered on ~picked with the vertex that is nearest in space."""

import math

import rospy
import rostest
from geometry_msgs.msg import PointStamped

from origami_client import NodeTest, Origami, Recorder, distance, line, wait_for_panels, wait_until
from shell_origami.msg import Picked

SIDE = 0.15
NAN = float('nan')
INF = float('inf')


class PickingTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()
        cls.picked = Recorder('/origami/picked', Picked)
        cls.clicks = rospy.Publisher('/clicked_point', PointStamped, queue_size=10)
        wait_until(lambda: cls.clicks.get_num_connections() and
                   cls.picked.subscriber.get_num_connections(), 'clicks are heard and answered')
        cls.origami.do('reset')
        cls.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=2.0, duration=0.3)
        cls.origami.do('step', steps=90)
        cls.origami.do('fold', line=line(0, 0.05, SIDE, 0.10), angle=0.5, duration=0.3)
        cls.origami.do('step', steps=60)
        cls.state, cls.sheet = cls.origami.state(), cls.origami.sheet()

    def setUp(self):
        pass  # on the paper that setUpClass has folded

    def click(self, x, y, z, frame='world', stamp=None):
        click = PointStamped()
        click.header.frame_id = frame
        click.header.stamp = stamp or rospy.Time.now()
        click.point.x, click.point.y, click.point.z = x, y, z
        self.clicks.publish(click)
        return click.point

    def pick(self, *where, **more):
        seen = len(self.picked.all())
        point = self.click(*where, **more)
        return point, self.picked.wait(since=seen)

    def at(self, x, y):
        """The vertex nearest to a flat point."""
        return min(range(len(self.sheet.flat_positions)), key=lambda i: math.hypot(
            self.sheet.flat_positions[i].x - x, self.sheet.flat_positions[i].y - y))

    def test_the_nearest_vertex_is_found(self):
        for x, y in ((0, 0), (0.04, 0.11), (SIDE, SIDE), (0.075, 0.01), (0.13, 0.05)):
            near = self.state.positions[self.at(x, y)]
            point, picked = self.pick(near.x + 0.002, near.y - 0.001, near.z + 0.002)
            to = [distance(point, p) for p in self.state.positions]
            self.assertAlmostEqual(to[picked.vertex], min(to), delta=1e-7)
            self.assertAlmostEqual(picked.distance, min(to), delta=1e-7)
            self.assertLess(distance(picked.position, self.state.positions[picked.vertex]), 1e-7)
            flat = self.sheet.flat_positions[picked.vertex]
            self.assertLess(distance(picked.flat_position, flat), 1e-7)
            through = [c for c in self.sheet.creases if picked.vertex in c.vertices]
            self.assertEqual(list(picked.crease_ids), [c.id for c in through])
            self.assertEqual(picked.crease, through[0].name if through else '')
            self.assertEqual(picked.revision, self.sheet.revision)
            self.assertEqual(picked.header.frame_id, 'world')
            self.assertGreater(picked.header.stamp, self.state.header.stamp)

    def test_where_creases_cross_both_are_named(self):
        at = self.state.positions[self.at(0.075, 0.075)]
        _, picked = self.pick(at.x, at.y, at.z)
        self.assertAlmostEqual(picked.flat_position.y, 0.075, delta=1e-6)
        self.assertEqual(len(picked.crease_ids), len(set(picked.crease_ids)))
        self.assertGreaterEqual(len(picked.crease_ids), 2)

    def test_far_clicks_find_a_vertex_too(self):
        _, picked = self.pick(0, 0, 5)
        self.assertGreater(picked.distance, 4)

    def test_a_click_may_be_in_any_frame(self):
        wait_for_panels()
        for stamp in (rospy.Time.now(), rospy.Time(1), rospy.Time.now() + rospy.Duration(100)):
            for panel in ('panel_0', 'panel_1'):
                _, picked = self.pick(0, 0, 0, frame=panel, stamp=stamp)
                self.assertLess(picked.distance, 0.01)

    def test_clicks_that_make_no_sense_find_none(self):
        seen = len(self.picked.all())
        self.click(NAN, 0, 0)
        self.click(0, 0, INF)
        self.click(0, 0, 0, frame='no_such_frame')
        self.click(0, 0, 0, frame='/world//')
        corner = self.at(SIDE, 0)
        p = self.state.positions[corner]
        self.click(p.x, p.y, p.z)
        self.picked.wait(lambda m: m.vertex == corner, since=seen)
        self.assertEqual(len(self.picked.all()), seen + 1)


if __name__ == '__main__':
    rospy.init_node('picking_test')
    rostest.rosrun('shell_origami', 'picking_test', PickingTest)
