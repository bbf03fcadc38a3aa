#!/usr/bin/python3
"""What a viewer of the paper meets: the start waits for it, it hears where its camera is to stand, its
camera's frame follows the paper, contact is shown on demand, and paper at rest costs nothing."""

import math
import os
import signal

import rospy
import rostest
import tf2_ros
from dynamic_reconfigure.client import Client
from rosgraph_msgs.msg import Log
from shell_origami.msg import FoldRecipeActionGoal, View
from visualization_msgs.msg import Marker, MarkerArray

from moving_frame import MovingFrame
from origami_client import NodeTest, Origami, Recorder, line, wait_until
from own_node import OwnNode

HERE = os.path.dirname(os.path.abspath(__file__))
SIDE = 0.15
MOST_REPEATS = 6  # of a drawing in which nothing moves
VIEW_OF_GOAL = 'view: {yaw_deg: 90, pitch_deg: 30, distance: 0.7}'
FALLING = 'sheet: {size: [0.15, 0.15], max_edge: 0.03}\ngravity: [0, 0, -9.81]\n'


def in_namespace(array, name):
    return [marker for marker in array.markers if marker.ns == name]


def norm(v):
    return math.sqrt(v.x**2 + v.y**2 + v.z**2)


def vertex_areas(sheet):
    """A third of the area of each vertex's triangles [m^2]."""
    areas = [0] * len(sheet.flat_positions)
    for triangle in sheet.triangles:
        a, b, c = (sheet.flat_positions[v] for v in triangle.vertex_indices)
        for v in triangle.vertex_indices:
            areas[v] += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 6
    return areas


class ViewTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()
        cls.log = Recorder('/rosout', Log)
        cls.goals = rospy.Publisher('/origami/fold_recipe/goal', FoldRecipeActionGoal, queue_size=1)
        cls.tf = tf2_ros.Buffer()
        cls.tf_listener = tf2_ros.TransformListener(cls.tf)

    def send_goal(self, yaml):
        goal = FoldRecipeActionGoal()
        goal.goal.yaml = yaml
        wait_until(self.goals.get_num_connections, 'the node hears goals')
        self.goals.publish(goal)

    def begin(self, name, **parameters):
        node = OwnNode(name, **parameters)
        self.addCleanup(node.end, signal.SIGINT)
        return node.origami

    def at_rest(self):
        """The number of the state from which on the paper rests."""
        states = self.origami.states
        self.origami.do('resume')
        states.wait(lambda state: state.settled and not state.paused, since=len(states.all()))
        return len(states.all())

    def test_the_start_waits_for_a_viewer(self):
        paper = self.begin('waits', wait_for_viewer=60.0)
        paper.states.wait(lambda state: state.paused and state.step == 0, since=len(paper.states.all()))
        markers = Recorder('/waits/markers', MarkerArray)
        first = markers.wait()
        self.assertEqual(len(in_namespace(first, 'front')), 1)
        running = paper.states.wait(lambda state: not state.paused)
        self.assertGreater(running.header.stamp, first.markers[0].header.stamp)

    def test_the_start_waits_no_longer_than_it_is_to(self):
        paper = self.begin('impatient', wait_for_viewer=0.5)
        paper.states.wait(lambda state: not state.paused)
        warning = self.log.wait(lambda m: m.name == '/impatient' and m.level == Log.WARN)
        self.assertIn('within 0.5 s', warning.msg)

    def test_paper_at_rest_is_not_sent_again(self):
        markers = Recorder('/origami/markers', MarkerArray)
        markers.wait()
        since = self.at_rest()
        seen = len(markers.all())
        self.origami.states.wait(lambda state: len(self.origami.states.all()) > since + 40)
        self.assertLessEqual(len(markers.all()) - seen, MOST_REPEATS)
        # Who comes later is sent all of it, and so is everyone when it moves.
        late = Recorder('/origami/markers', MarkerArray)
        drawn = {marker.ns: marker.action for marker in late.wait().markers}
        for name in ('front', 'back', 'border', 'ground', 'shadow'):
            self.assertEqual(drawn[name], Marker.ADD)
        seen = len(markers.all())
        self.origami.do('pin', vertices=[0])
        markers.wait(lambda m: in_namespace(m, 'pins')[0].action == Marker.ADD, since=seen)

    def test_a_paused_paper_is_sent_to_who_comes_late(self):
        self.origami.do('pin', vertices=[3])
        late = Recorder('/origami/markers', MarkerArray)
        self.assertEqual(len(in_namespace(late.wait(), 'pins')[0].points), 1)

    def test_the_camera_stands_where_the_recipe_says(self):
        views = Recorder('/origami/view', View)
        view = views.wait()
        self.assertEqual((view.header.frame_id, view.target_frame), ('world', 'paper_view'))
        self.send_goal(VIEW_OF_GOAL)
        view = views.wait(lambda v: v.distance == 0.7)
        self.assertAlmostEqual(view.yaw, 1.5707963, delta=1e-6)
        self.assertAlmostEqual(view.pitch, 0.5235988, delta=1e-6)

    def test_paper_that_falls_stays_in_view(self):
        self.send_goal(FALLING)
        fallen = self.origami.states.wait(
            lambda state: state.positions and state.positions[0].z < -10 * SIDE, timeout=30)
        stamp = fallen.header.stamp
        frame = self.tf.lookup_transform('world', 'paper_view', stamp, rospy.Duration(5)).transform
        z = [p.z for p in fallen.positions]
        self.assertLess(abs(frame.translation.z - (min(z) + max(z)) / 2), 0.21 * SIDE)
        self.assertEqual(frame.rotation.w, 1)

    def test_contact_is_seen_on_demand(self):
        # A letter: the second flap comes to lie on the first.
        paper = self.begin('letter', colouring='contact', contact_points=True, **{'sheet/max_edge': 0.03})
        markers = Recorder('/letter/markers', MarkerArray)
        for x, duration in ((SIDE / 3, 0.3), (2 * SIDE / 3, 0.8)):
            paper.do('fold', line=line(x, 0, x, SIDE), angle=3.05, duration=duration)
        state = paper.states.wait(lambda state: state.contact_points and state.settled, timeout=30)
        # Pressures carry the forces: each pushes two layers, and of a layer that is pushed from both
        # sides one counts.
        force = sum(norm(point.force) for point in state.contact_points)
        areas = vertex_areas(paper.sheets.wait(lambda sheet: sheet.revision == state.revision))
        carried = sum(p * area for p, area in zip(state.pressures, areas))
        self.assertEqual(len(state.pressures), len(state.positions))
        self.assertTrue(force < carried < 2.0001 * force, carried / force)
        drawn = markers.wait(lambda m: m.markers[0].header.stamp == state.header.stamp)
        balls, = in_namespace(drawn, 'contact_points')
        self.assertEqual((balls.action, len(balls.points)), (Marker.ADD, 2 * len(state.contact_points)))
        label, = in_namespace(drawn, 'pressure')
        self.assertIn('%.0f Pa' % max(state.pressures), label.text)
        # Who does not ask for them pays for none.
        Client('/letter/live', timeout=10).update_configuration({'contact_points': False})
        markers.wait(lambda m: in_namespace(m, 'contact_points')[0].action == Marker.DELETE,
                     since=len(markers.all()) - 1)
        self.assertEqual(paper.state().contact_points, [])
        other = self.origami.state()
        self.assertEqual((other.pressures, other.contact_points), ((), []))

    def test_overstretched_paper_is_told(self):
        markers = Recorder('/origami/markers', MarkerArray)
        puller = MovingFrame('puller', period=0.02)
        self.tf.can_transform('world', 'puller', rospy.Time(), rospy.Duration(5))
        sheet = self.origami.sheet()
        columns = [[i for i, p in enumerate(sheet.flat_positions) if abs(p.x - x) < 1e-6]
                   for x in (0, SIDE)]
        self.origami.do('pin', vertices=columns[0])
        self.origami.do('pin', vertices=columns[1], frame_id='puller')
        self.origami.do('resume')
        puller.go((0.1 * SIDE, 0, 0, 0), 1)
        state = self.origami.states.wait(lambda state: state.max_strain > 0.09, timeout=30)
        self.assertLess(state.max_strain, 1)
        warning = self.log.wait(lambda m: m.name == '/origami' and 'stretched' in m.msg)
        self.assertEqual(warning.level, Log.WARN)
        text = markers.wait(lambda m: in_namespace(m, 'warning')[0].action == Marker.ADD)
        self.assertIn('further than paper bears', in_namespace(text, 'warning')[0].text)
        puller.silent = True


if __name__ == '__main__':
    rospy.init_node('view_test')
    rostest.rosrun('shell_origami', 'view_test', ViewTest)
