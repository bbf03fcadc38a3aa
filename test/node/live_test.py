#!/usr/bin/python3
"""What dynamic_reconfigure changes under ~live holds from the next step on; what is out of bounds is
refused, and what is shown follows the paper."""

import os

import rospy
import rostest
from dynamic_reconfigure.client import Client
from dynamic_reconfigure.msg import Config, ConfigDescription
from dynamic_reconfigure.msg import DoubleParameter as Double
from visualization_msgs.msg import Marker, MarkerArray

from origami_client import NodeTest, Origami, Recorder, line

SIDE = 0.15
STEP = 1.0 / 60
START = {'gravity_x': 0, 'gravity_y': 0, 'gravity_z': 0, 'air_damping': 2, 'fold_duration': 0.5,
         'publish_rate': 30, 'real_time_factor': 1, 'vertex_ids': False}
# Those of config/origami.yaml.
BOUNDS = {'gravity_x': (-1e4, 1e4), 'gravity_y': (-1e4, 1e4), 'gravity_z': (-1e4, 1e4),
          'air_damping': (0, 1e6), 'publish_rate': (0.01, 1000),
          'fold_duration': (0, float('inf')), 'real_time_factor': (0, float('inf'))}
HEAVY = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'heavy.yaml')
NAN = float('nan')


def shown(config):
    return {name: config[name] for name in START}


class LiveTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()
        cls.live = Client('/origami/live', timeout=10)
        cls.updates = Recorder('/origami/live/parameter_updates', Config)
        cls.at_start = shown(cls.live.get_configuration(timeout=10))

    def setUp(self):
        super(LiveTest, self).setUp()
        self.assertEqual(self.change(**START), START)

    def change(self, **values):
        return shown(self.live.update_configuration(values))

    def after_steps(self, steps):
        time = self.origami.do('step', steps=steps).time
        return self.origami.states.wait(lambda m: abs(m.header.stamp.to_sec() - time) < 1e-6)

    def edits_since(self, state):
        """Every edit since then, the last of which is one made here."""
        self.origami.do('pin', vertices=[0])
        self.origami.edits.wait(
            lambda m: m.kind == 'pin' and m.header.stamp >= state.header.stamp)
        return [m for m in self.origami.edits.all() if m.header.stamp >= state.header.stamp]

    def test_starts_as_the_node_did_and_not_as_a_former_run_ended(self):
        self.assertEqual(self.at_start, START)

    def test_gravity_pulls_from_the_next_step_on_and_is_on_record(self):
        before = self.after_steps(1)
        self.assertTrue(before.settled)
        self.change(gravity_z=-9.81, air_damping=0)
        after = self.after_steps(30)
        fall = -9.81 / 2 * (30 * STEP) ** 2
        for p, q in zip(before.positions, after.positions):
            self.assertAlmostEqual(q.z - p.z, fall, delta=0.01 * abs(fall))
        edit = self.edits_since(before)[0]
        self.assertEqual(edit.kind, 'configure')
        self.assertEqual((edit.gravity.x, edit.gravity.y, edit.gravity.z), (0, 0, -9.81))
        self.assertEqual((edit.air_damping, edit.duration), (0, 0.5))

    def test_only_what_moves_the_paper_is_an_edit(self):
        before = self.after_steps(1)
        self.change(publish_rate=20, vertex_ids=True)
        self.change(fold_duration=0.25)
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1)
        edits = self.edits_since(before)
        self.assertEqual([edit.kind for edit in edits], ['configure', 'fold', 'pin'])
        self.assertEqual(edits[1].duration, 0.25)

    def test_out_of_bounds_changes_nothing(self):
        before = self.after_steps(1)
        for name, (low, high) in BOUNDS.items():
            beyond = [NAN, low - 0.001 * max(1, abs(low)), high * 1.001]
            if name == 'fold_duration':
                beyond.append(0)
            for value in beyond:
                # One bad value spoils the whole request.
                answer = self.change(**dict({'gravity_y': 1, 'vertex_ids': True}, **{name: value}))
                self.assertEqual(answer, START, '%s = %s' % (name, value))
        self.assertEqual(self.after_steps(1).positions, before.positions)
        self.assertEqual([edit.kind for edit in self.edits_since(before)], ['pin'])

    def test_bounds_are_told_and_may_be_reached(self):
        told = Recorder('/origami/live/parameter_descriptions', ConfigDescription)
        description = told.wait(lambda m: any(v.name == 'gravity_x' and v.value == BOUNDS[v.name][1]
                                              for v in m.max.doubles))
        low = {v.name: v.value for v in description.min.doubles}
        high = {v.name: v.value for v in description.max.doubles}
        self.assertEqual({name: (low[name], high[name]) for name in low}, BOUNDS)
        for name, bounds in BOUNDS.items():
            for value in bounds:
                if value == float('inf') or (name, value) == ('fold_duration', 0):
                    continue
                self.assertEqual(self.change(**{name: value})[name], value)

    def test_publishing_rate(self):
        for rate in (10, 60):
            self.change(publish_rate=rate)
            start = self.after_steps(1).header.stamp
            end = self.after_steps(60).header.stamp
            stamps = {m.header.stamp for m in self.origami.states.all()
                      if start < m.header.stamp <= end}
            self.assertAlmostEqual(len(stamps), rate, delta=1)

    def test_pace(self):
        # At its first pace ten minutes would outlast the test.
        start = self.after_steps(1).header.stamp.to_sec()
        self.change(real_time_factor=0)
        self.origami.do('resume')
        self.origami.states.wait(lambda m: m.header.stamp.to_sec() > start + 600)

    def test_vertex_ids(self):
        markers = Recorder('/origami/markers', MarkerArray)
        for shown_now, action in ((True, Marker.ADD), (False, Marker.DELETE)):
            self.change(vertex_ids=shown_now)
            count = len(self.after_steps(1).positions)
            message = markers.wait(
                lambda m: any(n.ns == 'vertex_ids' and n.action == action for n in m.markers))
            self.assertEqual(sum(n.ns == 'vertex_ids' for n in message.markers), count)

    def test_coloring(self):
        markers = Recorder('/origami/markers', MarkerArray)
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1, duration=0.1)
        self.after_steps(30)

        def colors(name):
            self.assertEqual(self.live.update_configuration({'colouring': name})['colouring'], name)
            # What was on its way until now may have the colors of before.
            stamp = self.after_steps(1).header.stamp
            drawn = markers.wait(
                lambda m: any(n.ns == 'front' and n.header.stamp >= stamp for n in m.markers))
            return {(c.r, c.g, c.b) for m in drawn.markers if m.ns == 'front' for c in m.colors}
        self.assertNotEqual(colors('curvature'), colors('paper'))
        self.assertEqual(self.live.update_configuration({'colouring': 'rainbow'})['colouring'], 'paper')

    def test_a_change_leaves_alone_what_a_loaded_paper_brought(self):
        self.change(gravity_z=-9.81, fold_duration=3)
        self.origami.do('load', path=HEAVY)
        # A change of something else, sent before the new values are shown, leaves them alone.
        answer = self.change(air_damping=7)
        self.assertEqual((answer['gravity_z'], answer['air_damping']), (-1.5, 7))
        self.assertEqual(answer['fold_duration'], 0.5)

    def test_what_a_loaded_paper_brings_is_shown(self):
        self.change(gravity_z=-9.81)
        heard = len(self.updates.all())
        self.origami.do('load', path=HEAVY)
        self.updates.wait(lambda m: Double('gravity_z', -1.5) in m.doubles, since=heard)

    def test_reset_keeps_them(self):
        self.change(gravity_z=-9.81)
        self.origami.do('reset')
        before = self.after_steps(1)
        self.assertLess(self.after_steps(30).positions[0].z, before.positions[0].z - 0.1)
        self.assertEqual(self.change()['gravity_z'], -9.81)


if __name__ == '__main__':
    rospy.init_node('live_test')
    rostest.rosrun('shell_origami', 'live_test', LiveTest)
