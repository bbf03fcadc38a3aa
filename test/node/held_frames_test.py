#!/usr/bin/python3
"""A TF frame holds an edge of the paper and carries it; what holds the paper is felt."""

import math
import threading

import rospy
import rostest
from geometry_msgs.msg import Point, Point32, PointStamped, Polygon, WrenchStamped

from moving_frame import MovingFrame
from origami_client import NodeTest, Recorder, distance, wait_for_transform, wait_until

SIDE = 0.15
WEIGHT = 800 * 1e-4 * SIDE * SIDE * 9.81  # [N]


def strip(x0, x1):
    return Polygon([Point32(x0, 0, 0), Point32(x1, 0, 0), Point32(x1, SIDE, 0),
                    Point32(x0, SIDE, 0)])


LEFT, RIGHT = strip(0, 0.001), strip(SIDE - 0.001, SIDE)


class HeldFramesTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(HeldFramesTest, cls).setUpClass()
        cls.hand = MovingFrame('hand')

    def setUp(self):
        super(HeldFramesTest, self).setUp()
        self.hand.silent = False
        self.hand.pose = (0.2, 0.1, 0, 0.3)
        wait_until(self.knows_the_hand, 'the node knows where the hand is')
        self.origami.do('unpin')
        self.origami.do('pin', region=LEFT)

    def knows_the_hand(self):
        """Whether the node finds the flat sheet's corner where the hand's pose says that it is."""
        corner = PointStamped()
        corner.header.frame_id = 'hand'
        x, y, z, yaw = self.hand.pose
        c, s = math.cos(yaw), math.sin(yaw)
        corner.point = Point(-c * x - s * y, s * x - c * y, -z)
        return self.origami.call('pin', center=corner, radius=1e-4).success

    def hold(self):
        return self.origami.do('pin', region=RIGHT, frame_id='hand').vertices

    def places(self, vertices):
        positions = self.origami.state().positions
        return [(positions[v].x, positions[v].y, positions[v].z) for v in vertices]

    def carried(self, place, start, end):
        """Where a frame that goes from one pose to another takes a place."""
        dx, dy = place[0] - start[0], place[1] - start[1]
        c, s = math.cos(end[3] - start[3]), math.sin(end[3] - start[3])
        return end[0] + c * dx - s * dy, end[1] + s * dx + c * dy, place[2] + end[2] - start[2]

    def wait_until_at(self, vertices, wanted):
        """Until the vertices, which follow a little behind, are there."""
        self.origami.states.wait(lambda state: all(
            distance(state.positions[v], Point(*place)) < 1e-6 for v, place in zip(vertices, wanted)),
            since=len(self.origami.states.all()))

    def test_the_edge_goes_rigidly_where_the_frame_goes(self):
        held = self.hold()
        before, start, end = self.places(held), self.hand.pose, (0.19, 0.11, 0.05, 0.5)
        self.origami.do('resume')
        self.hand.go(end, 1.0)
        self.wait_until_at(held, [self.carried(p, start, end) for p in before])

    def test_between_transforms_it_goes_smoothly(self):
        # Ten transforms a second, thirty states: none waits for a transform and then leaps.
        held = self.hold()
        self.origami.do('resume')
        self.hand.go((0.2, 0.1, 0.005, 0.3), 0.5)  # while it learns how late they are
        since = len(self.origami.states.all())
        self.hand.go((0.2, 0.1, 0.055, 0.3), 2.0)
        heights = [(state.step, state.positions[held[0]].z)
                   for state in self.origami.states.all()[since:]]
        self.assertGreater(len(heights), 20)
        speeds = [(b[1] - a[1]) / (b[0] - a[0]) * 60 for a, b in zip(heights, heights[1:])]
        # 25 mm/s on the average. By leaps and waits it would be 0 and 150.
        middle = speeds[len(speeds) // 4:]
        self.assertLess(max(middle), 0.06)
        self.assertGreater(sum(s > 0.005 for s in middle), 0.8 * len(middle))

    def test_a_silent_frame_holds_the_paper_where_it_is(self):
        held = self.hold()
        flat = self.places(held)
        self.origami.do('resume')
        self.hand.go((0.2, 0.1, 0.01, 0.3), 0.3)
        self.wait_until_at(held, [(x, y, z + 0.01) for x, y, z in flat])
        before = self.places(held)
        self.hand.silent = True
        self.origami.do('resume')
        self.origami.pass_steps(90)  # more than the second after which a frame counts as silent
        for place, was in zip(self.places(held), before):
            self.assertLess(math.dist(place, was), 1e-6)
        # Heard of again it is where it was, and goes on.
        self.hand.silent = False
        self.origami.do('resume')
        self.hand.go((0.2, 0.1, 0.02, 0.3), 0.3)
        self.wait_until_at(held, [(x, y, z + 0.02) for x, y, z in flat])

    def test_a_frame_that_jumps_is_followed_no_faster_than_an_arm_moves(self):
        held = self.hold()
        flat = self.places(held)
        self.origami.do('resume')
        self.origami.pass_steps(10)
        since = len(self.origami.states.all())
        self.hand.pose = (0.2, 0.1, 0.10, 0.3)
        self.wait_until_at(held, [(x, y, z + 0.10) for x, y, z in flat])
        states = self.origami.states.all()[since:]
        for a, b in zip(states, states[1:]):
            rise = b.positions[held[0]].z - a.positions[held[0]].z
            self.assertLessEqual(rise, 2.0 / 60 * (b.step - a.step) + 1e-6)

    def test_what_holds_the_paper_is_felt(self):
        self.hold()
        left = Recorder('/origami/wrench/world', WrenchStamped)
        hand = Recorder('/origami/wrench/hand', WrenchStamped)
        self.origami.do('settle')
        settled = self.origami.state().header.stamp
        in_world = left.wait(lambda wrench: wrench.header.stamp >= settled)
        in_hand = hand.wait(lambda wrench: wrench.header.stamp >= settled)
        self.assertEqual(in_world.header.frame_id, 'world')
        self.assertEqual(in_hand.header.frame_id, 'hand')
        up = in_world.wrench.force.z + in_hand.wrench.force.z  # the hand's z is the world's
        self.assertAlmostEqual(up / WEIGHT, 1, delta=0.01)
        self.assertAlmostEqual(in_hand.wrench.force.z / WEIGHT, 0.5, delta=0.02)
        # The edge pulls the hand's grip back towards the sheet's middle, so it pulls away from it.
        yaw, force = self.hand.pose[3], in_hand.wrench.force
        self.assertGreater(math.cos(yaw) * force.x - math.sin(yaw) * force.y, 0)

    def test_frames_that_no_topic_could_be_called_like_hold_it_too(self):
        for number, name in enumerate(('_', '9 lives', '\u00e4')):
            MovingFrame(name)
            self.origami.do('pin', vertices=[number], frame_id=name)
            self.origami.state()  # which publishes what holds it
            self.assertTrue(self.origami.alive(), name)
        Recorder('/origami/wrench/9_lives', WrenchStamped).wait()

    def test_a_frame_may_be_first_heard_of_a_moment_after_the_request(self):
        held, answers = [1], []
        request = threading.Thread(
            target=lambda: answers.append(self.origami.call('pin', vertices=held, frame_id='late')))
        request.start()
        self.origami.do('pin', vertices=[3])
        self.origami.do('unpin', vertices=[3])
        self.assertEqual(answers, [], 'others are answered meanwhile')
        MovingFrame('late')
        request.join()
        self.assertTrue(answers[0].success, answers[0].message)

    def test_a_frame_that_holds_nothing_any_more_has_no_wrench(self):
        def wrenches():
            return {name for name, _ in rospy.get_published_topics('/origami/wrench')}
        held = self.hold()
        self.origami.state()
        self.assertEqual(wrenches(), {'/origami/wrench/world', '/origami/wrench/hand'})
        self.origami.do('unpin', vertices=held)
        self.origami.state()
        self.assertEqual(wrenches(), {'/origami/wrench/world'})
        self.origami.do('unpin')
        self.origami.state()
        self.assertEqual(wrenches(), set())

    def test_let_go_it_hangs_from_what_is_left(self):
        held = self.hold()
        self.origami.do('unpin', vertices=held)
        self.origami.do('settle')
        self.assertLess(max(z for _, _, z in self.places(held)), -0.01)

    def test_a_frame_farther_than_positions_resolve_is_refused(self):
        self.hand.pose = (1001, 0, 0, 0)
        wait_for_transform(lambda t: t.child_frame_id == 'hand' and t.transform.translation.x == 1001)
        answer = self.origami.call('pin', region=RIGHT, frame_id='hand')
        self.assertFalse(answer.success)
        self.assertIn('(1001, 0, 0), but must be within 1000 m', answer.message)

    def test_frames_that_cannot_hold_paper_are_refused(self):
        for frame in ('nowhere', 'paper', 'panel_0', '/hand', 'a b', 'x' * 100000, '\u00e4'):
            answer = self.origami.call('pin', region=RIGHT, frame_id=frame)
            self.assertFalse(answer.success, frame[:20])
            self.assertIn('frame', answer.message)
        self.assertEqual(len(self.origami.state().pinned), len(self.origami.do('unpin').vertices))


if __name__ == '__main__':
    rospy.init_node('held_frames_test')
    rostest.rosrun('shell_origami', 'held_frames_test', HeldFramesTest)
