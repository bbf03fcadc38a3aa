#!/usr/bin/python3
"""Paper falls on obstacles, is pushed by them and presses on them; they are recorded, saved and drawn."""

import os
import shutil
import tempfile

import rospy
import rostest
from geometry_msgs.msg import Point, PoseStamped, WrenchStamped
from shape_msgs.msg import Plane, SolidPrimitive
from visualization_msgs.msg import MarkerArray

from moving_frame import MovingFrame
from origami_client import NodeTest, Recorder, wait_until

SIDE = 0.15
WEIGHT = 800 * 1e-4 * SIDE * SIDE * 9.81  # [N]
TABLE = -0.01  # its height [m]
DISTANCE = 5e-5  # contact/distance [m]

TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
"""


def primitive(kind, *dimensions):
    return SolidPrimitive(kind, dimensions)


class ObstaclesTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(ObstaclesTest, cls).setUpClass()
        cls.arm = MovingFrame('arm', 0.05)

    def add_table(self):
        return self.origami.add_obstacle('table', plane=(0, 0, 1, -TABLE))

    def felt(self, name):
        """The wrench of a paused node, once the topic, which begins with what it is of, is connected."""
        wrenches = Recorder('/origami/wrench/' + name, WrenchStamped)
        self.addCleanup(wrenches.subscriber.unregister)
        return wait_until(lambda: self.origami.do('pause') and wrenches.all(), 'a wrench')[-1]

    def heights(self):
        return [p.z for p in self.origami.state().positions]

    def rejected(self, words, **fields):
        answer = self.origami.call('add_obstacle', **fields)
        self.assertFalse(answer.success)
        self.assertIn(words, answer.message)

    def test_paper_falls_on_a_table_and_presses_on_it_with_its_weight(self):
        self.add_table()
        self.origami.do('step', steps=60)
        for z in self.heights():
            self.assertLessEqual(z, TABLE + 1e-7)
            self.assertGreaterEqual(z, TABLE - DISTANCE)
        wrench = self.felt('table')
        self.assertEqual(wrench.header.frame_id, 'world')
        self.assertAlmostEqual(wrench.wrench.force.z, -WEIGHT, delta=1e-3 * WEIGHT)
        self.assertAlmostEqual(wrench.wrench.torque.x, -WEIGHT * SIDE / 2, delta=0.02 * WEIGHT * SIDE)
        self.origami.remove_obstacle('table')
        self.origami.do('step', steps=20)
        self.assertLess(max(self.heights()), TABLE - 0.3)

    def test_a_box_that_a_frame_carries_pushes_paper_along(self):
        self.arm.pose = (0, 0, 0, 0)
        self.add_table()
        self.origami.do('step', steps=40)
        before = min(p.x for p in self.origami.state().positions)
        self.origami.add_obstacle('box', box=(0.02, 0.2, 0.02), frame='arm',
                                  position=(-0.03, SIDE / 2, -0.002))
        self.origami.do('resume')
        self.arm.go((0.06, 0, 0, 0), 1.5)
        self.origami.states.wait(
            lambda s: abs(s.obstacles[0].position.x - 0.03) < 1e-4,
            since=len(self.origami.states.all()))
        state = self.origami.state()
        after = min(p.x for p in state.positions)
        # The box's right face has gone on to x = 0.04, and the sheet's edge before it.
        self.assertAlmostEqual(before, 0, delta=0.01)
        self.assertAlmostEqual(after, 0.04, delta=2e-3)

    def test_obstacles_that_cannot_be_are_refused(self):
        ball = primitive(SolidPrimitive.SPHERE, 0.02)
        above = PoseStamped()
        above.pose.position = Point(0.07, 0.07, 0.1)
        self.rejected('give exactly one of primitive, plane, mesh', id='o', pose=above)
        self.rejected('give exactly one of', id='o', primitive=ball, mesh='a.stl', pose=above)
        self.rejected('primitive.type is 4', id='o', primitive=primitive(4, 1, 1), pose=above)
        self.rejected('a box has 1 dimensions', id='o', primitive=primitive(SolidPrimitive.BOX, 1))
        self.rejected('is no name of an obstacle', id='the table', primitive=ball, pose=above)
        self.rejected('would cut the paper', id='o', primitive=ball)
        self.rejected('radius is nan', id='o', pose=above,
                      primitive=primitive(SolidPrimitive.SPHERE, float('nan')))
        self.rejected('friction nan', id='o', primitive=ball, pose=above, friction=float('nan'))
        self.rejected('a finite normal', id='o', plane=Plane((0, 0, float('inf'), 0)))
        self.rejected('there is no package "none_such"', id='o', mesh='package://none_such/a.stl')
        self.rejected('a mesh is a .stl, .obj or .dae file', id='o', mesh='/tmp/a.png')
        away = PoseStamped()
        away.header.frame_id = 'nowhere'
        self.rejected('nowhere', id='o', primitive=ball, pose=away)
        away.header.frame_id = 'paper'
        self.rejected("the paper's own", id='o', primitive=ball, pose=away)
        self.assertFalse(self.origami.call('remove_obstacle', ids=['o']).success)
        self.assertEqual(self.origami.state().obstacles, [])

    def test_a_mesh_is_an_obstacle(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, 'tetrahedron.obj')
        with open(path, 'w') as mesh:
            mesh.write(TETRAHEDRON)
        self.origami.add_obstacle('stone', mesh='file://' + path, scale=(0.05, 0.05, 0.05),
                                  position=(0.05, 0.05, -0.06))
        sheet = self.origami.sheets.wait(lambda s: [o.id for o in s.obstacles] == ['stone'])
        self.assertEqual(len(sheet.obstacles[0].mesh.triangles), 4)
        self.assertEqual(len(sheet.obstacles[0].mesh.vertices), 4)
        self.origami.do('step', steps=8)
        # The tip holds the paper up where it is.
        self.assertGreater(max(self.heights()), -0.02)

    def test_a_grasp_slips_where_it_is_pulled_too_hard(self):
        self.origami.pin(points=[(0, 0), (0, SIDE)])
        answer = self.origami.grasp('fingers', points=[(SIDE, SIDE / 2)], max_force=0.2 * WEIGHT)
        self.assertEqual(list(self.origami.state().grasped), list(answer.vertices))
        self.assertEqual(self.felt('fingers').header.frame_id, 'world')
        # The grasp would have to bear more than the corners do, and gives way.
        self.origami.do('step', steps=60)
        self.assertEqual(list(self.origami.state().grasped), [])
        self.assertFalse(self.origami.call('release', ids=['hand']).success)
        self.assertEqual(self.origami.release().ids, ['fingers'])

    def test_they_are_drawn(self):
        markers = Recorder('/origami/markers', MarkerArray)
        self.add_table()
        self.origami.add_obstacle('ball', sphere=0.02, position=(0.3, 0, 0.1))

        def drawn(array):
            return any(m.ns == 'obstacles' and len(m.points) == 3 * (2 + 2048)
                       for m in array.markers)
        markers.wait(drawn)
        self.origami.remove_obstacle()
        markers.wait(lambda a: any(m.ns == 'obstacles' and m.action == m.DELETE for m in a.markers),
                     since=len(markers.all()))

    def test_an_undo_brings_them_back(self):
        self.add_table()
        self.origami.do('step', steps=5)
        self.origami.remove_obstacle('table')
        self.origami.undo()
        self.assertEqual(len(self.origami.state().obstacles), 1)
        self.origami.undo()
        self.assertEqual(len(self.origami.state().obstacles), 0)

    def test_a_session_with_them_is_saved_as_a_recipe(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, 'session.yaml')
        self.add_table()
        self.origami.do('step', steps=20)
        positions = self.origami.state().positions
        self.origami.save(path)
        self.origami.do('resume')
        self.origami.fold_recipe(recipe=path)
        state = self.origami.state()
        again = self.origami.states.wait(lambda s: s.step >= state.step)
        self.assertEqual(len(again.obstacles), 1)
        # The recipe's paper has gone on falling asleep since.
        for p, q in zip(positions, again.positions):
            self.assertAlmostEqual(p.x, q.x, delta=1e-4)
            self.assertAlmostEqual(p.z, q.z, delta=DISTANCE)


if __name__ == '__main__':
    rospy.init_node('obstacles_test')
    rostest.rosrun('shell_origami', 'obstacles_test', ObstaclesTest)
