#!/usr/bin/python3
"""Two grippers lift the edge of a sheet, fold it over, and let go; it stays folded."""

import math
import unittest

import rosnode
import rospy
import rostest
from geometry_msgs.msg import WrenchStamped

from launched_demo import LaunchedDemo
from origami_client import Recorder
from shell_origami.msg import Edit, SheetState

SIDE, EDGE = 0.15, 0.09  # [m] of the sheet, and where the table ends
WEIGHT = 800 * 2e-4 * SIDE * SIDE * 9.81  # [N]
GRASPS = ('left', 'right')
BEARERS = ('table', 'weight')


class GripperTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.states = Recorder('/origami/state', SheetState)
        cls.edits = Recorder('/origami/edits', Edit)
        cls.wrenches = {id: Recorder('/origami/wrench/' + id, WrenchStamped)
                        for id in GRASPS + BEARERS}
        cls.demo = LaunchedDemo('gripper.launch', 'gripper_demo', 'clock:=lead',
                                'real_time_factor:=2')
        # Whatever fails from here on, nothing is left running.
        cls.addClassCleanup(cls.demo.end)
        cls.said = cls.demo.listen(90)
        cls.state = cls.states.wait(lambda state: state.settled and state.header.stamp >
                                    cls.edit('release').header.stamp)

    @classmethod
    def edit(cls, kind, id=None):
        return cls.edits.wait(lambda edit: edit.kind == kind and (id is None or id in edit.ids))

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
        way = self.between(self.edit('fold'), self.edit('release'))
        for id in GRASPS:
            held = self.edit('grasp', id).vertices
            self.assertGreater(len(held), 1)
            for v in held:
                heights = [state.positions[v].z for state in way]
                self.assertGreater(max(heights), 0.045)
                self.assertLess(heights[0], 0.001)
                self.assertLess(heights[-1], 0.01)
                self.assertLess(way[-1].positions[v].x, 2 * EDGE - SIDE + 0.02)

    def test_the_crease_bends_as_the_edge_goes(self):
        # A sheet that is creased where the arc has its middle goes over nearly flat. On a busy
        # machine transforms come late, and the edge follows the grippers that much behind the fold.
        v = self.edit('grasp', GRASPS[0]).vertices[0]
        for state in self.between(self.edit('fold'), self.edit('release'))[::10]:
            place = state.positions[v]
            arc = math.atan2(place.z, place.x - EDGE)
            self.assertAlmostEqual(state.creases[0].angle, arc, delta=math.radians(30))

    def test_it_lies_on_the_table_under_the_weight_and_is_held_by_nothing_else(self):
        for state in self.between(self.edit('fold'), self.edit('release'))[30:] + [self.state]:
            self.assertFalse(state.pinned)
            on_table = [p.z for p in state.positions if p.x < EDGE]
            self.assertGreater(min(on_table), -5e-5)
        left = [v for v, p in enumerate(self.state.positions) if p.x < 0.001]
        self.assertGreater(len(left), 10)

    def test_it_stays_folded_when_they_have_let_go(self):
        self.assertFalse(self.state.grasped)
        angle = math.degrees(self.state.creases[0].angle)
        self.assertGreater(angle, 160)
        self.assertLess(angle, 179)

    def test_what_the_edge_weighs_is_felt(self):
        # Level and at rest: the grippers bear part of what hangs, the table the rest.
        rest = self.edit('fold').header.stamp - rospy.Duration(0.05)
        force = {id: [m for m in recorder.all() if m.header.stamp <= rest][-1].wrench.force.z
                 for id, recorder in self.wrenches.items()}
        held = sum(force[id] for id in GRASPS)
        self.assertAlmostEqual((held - sum(force[id] for id in BEARERS)) / WEIGHT, 1, delta=0.02)
        share = held / WEIGHT
        self.assertGreater(share, 0.1)
        self.assertLess(share, 0.30)


if __name__ == '__main__':
    rospy.init_node('gripper_test')
    rostest.rosrun('shell_origami', 'gripper_test', GripperTest)
