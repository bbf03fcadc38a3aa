#!/usr/bin/python3
"""~sheet, ~state, ~energy, ~markers and /tf tell of one and the same paper."""

import math
import subprocess

import rospy
import rostest
import tf2_ros
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from origami_client import NodeTest, Origami, Recorder, distance, line
from shell_origami.msg import Energy

SIDE = 0.15


def times(q, r):
    """Product of two quaternions (x, y, z, w)."""
    (a, b, c, d), (e, f, g, h) = q, r
    return (d * e + a * h + b * g - c * f, d * f - a * g + b * h + c * e,
            d * g + a * f - b * e + c * h, d * h - a * e - b * f - c * g)


def turn_between(first, second):
    """Angle of the rotation from one transform to the other [rad]."""
    q, r = ((t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w) for t in (first, second))
    x, y, z, w = times((-q[0], -q[1], -q[2], q[3]), r)
    return 2 * math.atan2(math.sqrt(x * x + y * y + z * z), abs(w))


class TopicsTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()
        cls.frames = Recorder('/tf', TFMessage)
        cls.markers = Recorder('/origami/markers', MarkerArray)
        cls.tf = tf2_ros.Buffer()
        cls.tf_listener = tf2_ros.TransformListener(cls.tf)
        cls.energies = Recorder('/origami/energy', Energy)

    def frames_at(self, stamp):
        message = self.frames.wait(lambda m: m.transforms[0].header.stamp == stamp)
        return {t.child_frame_id: t for t in message.transforms}

    def markers_at(self, stamp):
        message = self.markers.wait(lambda m: m.markers[0].header.stamp == stamp)
        return {m.ns: m for m in message.markers}

    def test_flat_paper(self):
        state, sheet = self.origami.state(), self.origami.sheet()
        self.assertEqual(sheet.header.frame_id, 'world')
        self.assertEqual(state.header.frame_id, 'world')
        self.assertEqual(len(state.positions), len(sheet.flat_positions))
        self.assertTrue(state.settled)
        for now, flat in zip(state.positions, sheet.flat_positions):
            self.assertLess(distance(now, flat), 1e-7)
        for triangle in sheet.triangles:
            a, b, c = (sheet.flat_positions[v] for v in triangle.vertex_indices)
            self.assertGreater((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0)
        frames = self.frames_at(state.header.stamp)
        self.assertEqual(set(frames), {'paper', 'panel_0', 'paper_view'})
        self.assertEqual(frames['paper'].header.frame_id, 'world')
        self.assertAlmostEqual(frames['paper'].transform.rotation.w, 1, delta=1e-9)
        panel = frames['panel_0'].transform
        self.assertEqual(frames['panel_0'].header.frame_id, 'paper')
        self.assertAlmostEqual(panel.translation.x, SIDE / 2, delta=1e-6)
        self.assertAlmostEqual(panel.translation.y, SIDE / 2, delta=1e-6)

    def test_panels_turn_by_the_fold_angle(self):
        for angle in (1.2, -2.0):
            self.origami.do('reset')
            self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=angle, duration=0.3)
            flat = self.frames_at(self.origami.state().header.stamp)
            self.assertEqual(turn_between(flat['panel_0'].transform, flat['panel_1'].transform), 0)
            self.origami.do('step', steps=90)
            state = self.origami.state()
            frames = self.frames_at(state.header.stamp)
            self.assertEqual(set(frames), {'paper', 'panel_0', 'panel_1', 'paper_view'})
            turn = turn_between(frames['panel_0'].transform, frames['panel_1'].transform)
            self.assertAlmostEqual(turn, abs(state.creases[0].angle), delta=0.03)
            self.assertAlmostEqual(turn, abs(angle), delta=0.05)
            # As tf_echo panel_0 panel_1 shows it: about the crease, which runs along y.
            between = self.tf.lookup_transform('panel_0', 'panel_1', state.header.stamp,
                                               rospy.Duration(5)).transform.rotation
            about_y = 2 * math.atan2(between.y, between.w)
            self.assertAlmostEqual(abs(about_y), turn, delta=1e-3)
            self.assertLess(max(abs(between.x), abs(between.z)), 1e-3)

    def test_markers_show_the_state(self):
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.0, duration=0.3)
        self.origami.do('pin', vertices=[0, 1])
        self.origami.do('step', steps=30)
        state, sheet = self.origami.state(), self.origami.sheet()
        markers = self.markers_at(state.header.stamp)
        for name in ('front', 'back'):
            marker = markers[name]
            self.assertEqual((marker.type, marker.action), (Marker.TRIANGLE_LIST, Marker.ADD))
            self.assertEqual(len(marker.points), 3 * len(sheet.triangles))
            self.assertEqual(len(marker.colors), len(sheet.triangles))
        for i, triangle in enumerate(sheet.triangles):
            for k, v in enumerate(triangle.vertex_indices):
                drawn = markers['front'].points[3 * i + k]
                self.assertAlmostEqual(distance(drawn, state.positions[v]), SIDE / 4000, delta=1e-6)
        edges = len(sheet.creases[0].vertices) - 1
        self.assertEqual(len(markers['creases'].points), 4 * edges)
        self.assertEqual(len(markers['creases'].colors), 4 * edges)
        self.assertEqual(len(markers['pins'].points), 2)
        self.assertEqual(markers['border'].action, Marker.ADD)

    def test_nothing_to_show_deletes_the_marker(self):
        state = self.origami.state()
        markers = self.markers_at(state.header.stamp)
        self.assertEqual(markers['pins'].action, Marker.DELETE)
        self.assertEqual(markers['creases'].action, Marker.DELETE)

    def test_energy(self):
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.0, duration=0.3)
        self.origami.do('step', steps=10)
        stamp = self.origami.state().header.stamp
        energy = self.energies.wait(lambda m: m.header.stamp == stamp)
        self.assertGreater(energy.bending, 0)
        self.assertGreater(energy.kinetic, 0)
        self.assertEqual(energy.strain_energy, energy.membrane + energy.bending)
        self.assertGreater(energy.newton_iterations, 0)
        self.assertGreater(energy.max_strain, 0)
        self.assertLess(energy.max_strain, 0.05)

    def test_energy_is_ready_for_plotting(self):
        # What a plotting program reads: one column a figure, under its name.
        command = ['rostopic', 'echo', '-p', '-n', '3', '/origami/energy']
        heard = subprocess.check_output(command, timeout=10, universal_newlines=True).splitlines()
        columns = heard[0].split(',')
        self.assertEqual(columns[0], '%time')
        self.assertEqual([name for name in columns if 'header' not in name][1:],
                         ['field.' + name for name in Energy.__slots__[1:]])
        self.assertEqual(len(heard), 4)
        for row in heard[1:]:
            figures = dict(zip(columns, row.split(',')))
            for name in Energy.__slots__[1:]:
                float(figures['field.' + name])

    def test_late_subscribers_see_the_whole_paper(self):
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.0)
        self.origami.do('pin', vertices=[0])
        def echo(field, count):
            command = ['rostopic', 'echo', '-p', '-n', str(count), '/origami/' + field]
            heard = subprocess.check_output(command, timeout=10, universal_newlines=True)
            return [text.split(',')[-1] for text in heard.splitlines()[1:]]

        self.assertEqual(echo('edits/kind', 1), ['paper'])
        self.assertEqual(echo('edits/number', 1), [str(self.origami.state().edits)])
        self.assertEqual(echo('sheet/revision', 1), [str(self.origami.sheet().revision)])

    def test_no_frame_is_sent_twice_with_one_stamp(self):
        self.origami.do('resume')
        self.origami.pass_steps(30)
        self.origami.do('pause')
        for _ in range(2):
            self.frames.wait(since=len(self.frames.all()))
        stamps = [m.transforms[0].header.stamp for m in self.frames.all()]
        self.assertEqual(stamps, sorted(set(stamps)))


if __name__ == '__main__':
    rospy.init_node('topics_test')
    rostest.rosrun('shell_origami', 'topics_test', TopicsTest)
