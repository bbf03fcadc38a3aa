#!/usr/bin/python3
"""The hand that rviz shows takes a vertex that is picked, drags it along, and lets go."""

import math

import rosnode
import rospy
import rostest
from geometry_msgs.msg import Point32, PointStamped, Polygon, Pose
from rosgraph_msgs.msg import Log
from visualization_msgs.msg import (InteractiveMarkerFeedback, InteractiveMarkerInit,
                                    InteractiveMarkerUpdate)

from origami_client import NodeTest, Recorder, wait_until

SIDE = 0.15
NAN, INF = float('nan'), float('inf')
LEFT = Polygon([Point32(0, 0, 0), Point32(0.001, 0, 0), Point32(0.001, SIDE, 0), Point32(0, SIDE, 0)])


def pose_at(x, y, z, qx=0, qy=0, qz=0, qw=1):
    pose = Pose()
    pose.position.x, pose.position.y, pose.position.z = x, y, z
    orientation = pose.orientation
    orientation.x, orientation.y, orientation.z, orientation.w = qx, qy, qz, qw
    return pose


class HandTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(HandTest, cls).setUpClass()
        cls.clicks = rospy.Publisher('/clicked_point', PointStamped, queue_size=10)
        cls.feedback = rospy.Publisher('/hand/feedback', InteractiveMarkerFeedback, queue_size=10)
        cls.shown = Recorder('/hand/update_full', InteractiveMarkerInit)
        cls.updates = Recorder('/hand/update', InteractiveMarkerUpdate)
        cls.log = Recorder('/rosout', Log)
        cls.shown.wait(lambda shown: shown.markers)
        wait_until(cls.clicks.get_num_connections, 'someone hears clicks')

        def answers():  # once both hear each other
            cls.choose('let go')
            return any(log.name == '/hand' for log in cls.log.all())
        wait_until(answers, 'the hand says something', period=0.1)

    @classmethod
    def send(cls, event, **fields):
        message = InteractiveMarkerFeedback(client_id='test', marker_name='hand', event_type=event)
        message.header.frame_id = 'world'
        for name, value in fields.items():
            setattr(message, name, value)
        cls.feedback.publish(message)

    @classmethod
    def choose(cls, title):
        marker, = cls.shown.all()[-1].markers
        entry, = [entry.id for entry in marker.menu_entries if entry.title == title]
        cls.send(InteractiveMarkerFeedback.MENU_SELECT, menu_entry_id=entry)

    def setUp(self):
        super(HandTest, self).setUp()
        self.table = self.origami.do('pin', region=LEFT).vertices
        self.last_edit = self.origami.state().edits

    def tearDown(self):
        super(HandTest, self).tearDown()
        self.assertTrue(rosnode.rosnode_ping('/hand', max_count=1, verbose=False), 'the hand died')

    def edit(self, kind):
        """The next edit of this kind."""
        edit = self.origami.edits.wait(lambda e: e.number > self.last_edit and e.kind == kind)
        self.last_edit = edit.number
        return edit

    def said(self, words, since):
        return self.log.wait(lambda log: log.name == '/hand' and words in log.msg, since=since)

    def click(self, x, y, z=0):
        click = PointStamped()
        click.header.frame_id = 'world'
        click.point.x, click.point.y, click.point.z = x, y, z
        self.clicks.publish(click)

    def take_corner(self):
        self.click(SIDE, SIDE)
        edit = self.edit('pin')
        self.assertEqual(edit.frame_id, 'hand')
        corner, = edit.vertices
        self.origami.do('resume')
        return corner

    def drag(self, pose, **fields):
        self.send(InteractiveMarkerFeedback.POSE_UPDATE, pose=pose, **fields)

    def drag_until_said(self, pose, words, since, **fields):
        """Drags again and again, for the hand warns once a second; returns the warning."""
        def warning():
            self.drag(pose, **fields)
            return next((log for log in self.log.all()[since:]
                         if log.name == '/hand' and words in log.msg), None)
        return wait_until(warning, 'the hand warns: ' + words)

    def place(self, vertex):
        p = self.origami.states.all()[-1].positions[vertex]
        return p.x, p.y, p.z

    def follows(self, vertex, x, y, z):
        """Waits until the vertex is there."""
        self.origami.states.wait(lambda state: math.dist(
            (x, y, z), (state.positions[vertex].x, state.positions[vertex].y,
                        state.positions[vertex].z)) < 1e-6, since=len(self.origami.states.all()))

    def test_a_picked_vertex_stays_where_it_is_until_it_is_dragged(self):
        corner = self.take_corner()
        self.origami.pass_steps(30)  # in which it does not move
        self.follows(corner, SIDE, SIDE, 0)
        self.drag(pose_at(0.13, 0.14, 0.05))
        self.follows(corner, 0.13, 0.14, 0.05)
        self.drag(pose_at(0.14, 0.15, 0.03))
        self.follows(corner, 0.14, 0.15, 0.03)

    def test_the_marker_goes_where_the_hand_jumps(self):
        since = len(self.updates.all())
        self.take_corner()
        self.updates.wait(lambda update: any(
            abs(p.pose.position.x - SIDE) + abs(p.pose.position.y - SIDE) < 1e-6
            for p in update.poses), since=since)

    def test_a_hand_that_holds_something_takes_nothing_else(self):
        corner, since = self.take_corner(), len(self.log.all())
        self.click(SIDE, 0)
        self.said('is left', since)
        self.drag(pose_at(0.14, 0.15, 0.02))
        self.follows(corner, 0.14, 0.15, 0.02)
        self.assertEqual(sorted(self.origami.state().pinned), sorted([*self.table, corner]))

    def test_the_menu_takes_more_and_lets_go(self):
        corner = self.take_corner()
        self.choose('hold all within 1 cm')
        near = self.edit('pin').vertices
        self.assertIn(corner, near)
        self.assertGreater(len(near), 1)
        start = {v: self.place(v) for v in near}
        # A turn of 90 degrees around z.
        self.drag(pose_at(SIDE, SIDE, 0.01, 0, 0, 0.5 ** 0.5, 0.5 ** 0.5))
        for v, (x, y, _) in start.items():
            self.follows(v, SIDE - (y - SIDE), SIDE + (x - SIDE), 0.01)
        self.choose('let go')
        self.assertEqual(sorted(self.edit('unpin').vertices), sorted(near))
        self.assertEqual(sorted(self.origami.state().pinned), sorted(self.table))

        since = len(self.log.all())
        self.choose('let go')
        self.said('holds nothing', since)

    def test_what_others_let_go_of_the_hand_does_not_hold(self):
        corner = self.take_corner()
        self.origami.do('unpin', vertices=[corner])
        self.edit('unpin')

        def taken_again():  # once the hand has heard of it, too
            self.click(SIDE, SIDE)
            return any(edit.kind == 'pin' and edit.number > self.last_edit
                       for edit in self.origami.edits.all())
        wait_until(taken_again, 'the corner is taken again')
        self.assertEqual(list(self.edit('pin').vertices), [corner])

    def test_poses_that_make_no_sense_move_nothing(self):
        corner = self.take_corner()
        for pose in (pose_at(NAN, 0, 0), pose_at(0, 0, INF), pose_at(0, 0, 0, 0, 0, 0, 0),
                     pose_at(0, 0, 0, NAN)):
            since = len(self.log.all())
            self.assertEqual(self.drag_until_said(pose, 'the hand stays', since).level, Log.WARN)
        self.drag(pose_at(0, 0, 1), marker_name='foot')
        since = len(self.log.all())
        elsewhere = InteractiveMarkerFeedback().header
        elsewhere.frame_id = 'elsewhere'
        self.drag_until_said(pose_at(0, 0, 1), 'the hand stays', since, header=elsewhere)
        self.follows(corner, SIDE, SIDE, 0)
        self.send(InteractiveMarkerFeedback.MENU_SELECT, menu_entry_id=12345)
        self.drag(pose_at(0.14, 0.15, 0.02))
        self.follows(corner, 0.14, 0.15, 0.02)


if __name__ == '__main__':
    rospy.init_node('hand_test')
    rostest.rosrun('shell_origami', 'hand_test', HandTest)
