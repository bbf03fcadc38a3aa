#!/usr/bin/python3
"""Every service of the node does what it says."""

import json
import math
import os
import shutil
import tempfile
import time

import rospy
import rostest
from geometry_msgs.msg import Point, Point32, PointStamped, Polygon

from origami_client import NodeTest, line, wait_for_panels

SIDE = 0.15
STEP = 1.0 / 60


class ServicesTest(NodeTest):
    def setUp(self):
        super(ServicesTest, self).setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def positions(self):
        return [(p.x, p.y, p.z) for p in self.origami.state().positions]

    def vertices_at(self, x, y):
        return [i for i, p in enumerate(self.origami.sheet().flat_positions)
                if abs(p.x - x) < 1e-6 and abs(p.y - y) < 1e-6]

    def test_fold_by_line(self):
        revision = self.origami.sheet().revision
        fold = self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.9, duration=0.5)
        self.assertEqual(len(fold.crease_ids), 1)
        self.assertGreater(fold.revision, revision)
        sheet = self.origami.sheet()
        self.assertEqual(sheet.revision, fold.revision)
        self.assertIn(fold.vertices, (sheet.creases[0].vertices, sheet.creases[0].vertices[::-1]))
        for v in fold.vertices:
            p = sheet.flat_positions[v]
            self.assertAlmostEqual(p.x, p.y, delta=1e-7)
        self.origami.do('step', steps=90)
        crease = self.origami.state().creases[0]
        self.assertEqual(crease.id, fold.crease_ids[0])
        self.assertAlmostEqual(crease.target_angle, 2.9, delta=1e-6)
        self.assertAlmostEqual(crease.rest_angle, 2.9, delta=1e-6)
        self.assertAlmostEqual(crease.angle, 2.9, delta=0.05)

    def test_an_angle_of_almost_pi_rests_at_179_degrees(self):
        answer = self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=-3.14159)
        self.assertIn('to %.6f rad, the most' % -math.radians(179), answer.message)

    def test_a_mountain_has_a_negative_angle(self):
        self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=-1.0, duration=0.5)
        self.origami.do('step', steps=90)
        self.assertAlmostEqual(self.origami.state().creases[0].angle, -1.0, delta=0.05)

    def test_settle_goes_to_equilibrium_at_once(self):
        # A flap of 60 degrees, asked for in no time, is there without time passing.
        self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=1.0, duration=0.001)
        before = self.origami.do('step', steps=1).time
        self.assertGreater(abs(self.origami.state().creases[0].angle - 1.0), 0.1)
        self.origami.do('settle')
        after = self.origami.state()
        self.assertTrue(after.settled)
        self.origami.last_edit('settle')
        self.assertAlmostEqual(after.creases[0].angle, 1.0, delta=1e-4)
        self.assertAlmostEqual(self.origami.do('step', steps=1).time, before + STEP, delta=1e-9)

    def test_fold_by_vertices(self):
        a, b = self.vertices_at(0, SIDE)[0], self.vertices_at(SIDE, 0)[0]
        fold = self.origami.do('fold', vertices=[a, b], angle=0.5, duration=0.2, stiffness=0.02)
        self.assertEqual([fold.vertices[0], fold.vertices[-1]], [a, b])
        edit = self.origami.last_edit('fold')
        self.assertEqual((edit.angle, edit.duration, edit.stiffness), (0.5, 0.2, 0.02))
        self.assertEqual((edit.vertices, edit.revision), (fold.vertices, fold.revision))

    def test_fold_by_crease_name(self):
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=0.6, duration=0.2)
        self.origami.do('fold', line=line(0.10, 0, 0.10, SIDE), angle=0.6, duration=0.2)
        name = self.origami.sheet().creases[0].name
        revision = self.origami.sheet().revision
        fold = self.origami.do('fold', crease=name, angle=-0.4)
        self.assertEqual(fold.revision, revision)
        state = self.origami.state()
        self.assertAlmostEqual(state.creases[0].target_angle, -0.4, delta=1e-6)
        self.assertAlmostEqual(state.creases[1].target_angle, 0.6, delta=1e-6)

    def test_a_new_crease_has_the_name_that_is_asked_for(self):
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=0.6, name='wing')
        self.assertEqual([crease.name for crease in self.origami.sheet().creases], ['wing'])
        for fields in (dict(crease='wing', name='tail'), dict(line=line(0.1, 0, 0.1, SIDE), name='all')):
            answer = self.origami.call('fold', angle=0.6, **fields)
            self.assertFalse(answer.success)
            self.assertIn(fields['name'], answer.message)

    def test_add_vertex_lets_a_fold_start_there(self):
        sheet = self.origami.sheet()
        border = [i for i, p in enumerate(sheet.flat_positions) if abs(p.y) < 1e-9]
        a, b = sorted(border, key=lambda i: sheet.flat_positions[i].x)[:2]
        added = self.origami.do('add_vertex', edge=[a, b], fraction=0.25)
        self.assertGreater(added.revision, sheet.revision)
        p, pa, pb = (self.origami.sheet().flat_positions[i] for i in (added.vertex, a, b))
        self.assertAlmostEqual(p.x, 0.75 * pa.x + 0.25 * pb.x, delta=1e-7)
        fold = self.origami.do('fold', vertices=[added.vertex, self.vertices_at(SIDE, SIDE)[0]],
                               angle=0.3)
        self.assertEqual(fold.vertices[0], added.vertex)

    def test_pinned_vertices_stay_to_the_bit(self):
        region = Polygon([Point32(0, 0, 0), Point32(0.05, 0, 0), Point32(0.05, SIDE, 0),
                          Point32(0, SIDE, 0)])
        pinned = self.origami.do('pin', region=region).vertices
        self.assertGreater(len(pinned), 20)
        self.assertEqual(list(self.origami.state().pinned), sorted(pinned))
        self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=1.0, duration=0.3)
        before = self.positions()
        self.origami.do('step', steps=20)
        after = self.positions()
        for v in pinned:
            self.assertEqual(before[v], after[v])
        corner = self.vertices_at(SIDE, 0)[0]
        self.assertGreater(after[corner][2] - before[corner][2], 1e-3)

    def test_pin_by_vertices_points_and_ball(self):
        corner = self.vertices_at(0, 0)[0]
        self.assertEqual(self.origami.do('pin', vertices=[corner]).vertices, (corner,))
        far = self.vertices_at(SIDE, SIDE)[0]
        self.assertEqual(self.origami.do('pin', points=[Point(0.149, 0.149, 0)]).vertices, (far,))
        center = PointStamped()
        center.header.frame_id = 'world'
        center.point = Point(SIDE, 0, 0)
        ball = self.origami.do('pin', center=center, radius=0.02).vertices
        for v in ball:
            p = self.origami.state().positions[v]
            self.assertLess((p.x - SIDE) ** 2 + p.y ** 2 + p.z ** 2, 0.02 ** 2)
        self.assertIn(self.vertices_at(SIDE, 0)[0], ball)

    def test_a_ball_may_be_given_in_another_frame(self):
        self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=1.0, duration=0.1)
        self.origami.do('step', steps=60)
        self.origami.state()
        wait_for_panels()
        center = PointStamped()
        center.header.frame_id = 'panel_0'
        ball = self.origami.do('pin', center=center, radius=0.02).vertices
        flat = [self.origami.sheet().flat_positions[v] for v in ball]
        x = sum(p.x for p in flat) / len(flat)
        self.assertAlmostEqual(min(x, SIDE - x), SIDE / 4, delta=0.01)

    def test_unpin(self):
        self.origami.do('pin', vertices=[0, 1, 2])
        self.assertEqual(self.origami.do('unpin', vertices=[1]).vertices, (1,))
        self.assertEqual(list(self.origami.state().pinned), [0, 2])
        self.assertEqual(self.origami.do('unpin').vertices, (0, 2))
        self.assertEqual(list(self.origami.state().pinned), [])

    def test_an_answer_tells_the_number_of_its_edit(self):
        a, b = self.vertices_at(0, 0)[0], self.vertices_at(SIDE, SIDE)[0]
        numbers = [
            self.origami.do('fold', vertices=[a, b], angle=1).edit,
            self.origami.do('pin', vertices=[a]).edit,
            self.origami.do('unpin', vertices=[a]).edit,
            self.origami.do('add_vertex', edge=self.origami.sheet().triangles[0].vertex_indices[:2],
                            fraction=0.5).edit]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + 4)))
        kinds = [self.origami.edits.wait(lambda edit: edit.number == number).kind
                 for number in numbers]
        self.assertEqual(kinds, ['fold', 'pin', 'unpin', 'add_vertex'])
        self.assertEqual(self.origami.state().edits, numbers[-1])

    def test_folds_of_one_moment_run_together(self):
        # Each covers the same part of its way in tan(angle/2), as the creases of one vertex do.
        for number, angle in enumerate((2.0, -0.5)):
            x = 0.05 * (number + 1)
            self.origami.do('fold', line=line(x, 0, x, SIDE), angle=angle, duration=0.5)
        self.origami.do('step', steps=12)
        parts = [math.tan(c.rest_angle / 2) / math.tan(c.target_angle / 2)
                 for c in self.origami.state().creases]
        self.assertGreater(parts[0], 0.1)
        self.assertLess(parts[0], 0.5)
        self.assertAlmostEqual(parts[0], parts[1], delta=1e-5)

    def test_a_paused_node_says_that_nothing_will_move(self):
        for answer in (self.origami.do('reset'),
                       self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1)):
            self.assertIn('the node is paused: call ~resume', answer.message)
        self.assertTrue(self.origami.state().paused)
        self.origami.do('resume')
        answer = self.origami.do('fold', line=line(0.1, 0, 0.1, SIDE), angle=1)
        self.assertNotIn('paused', answer.message)
        self.assertFalse(self.origami.states.wait(lambda state: state.edits >= answer.edit).paused)

    def test_step_takes_exactly_so_many_steps(self):
        start = self.origami.do('step', steps=1).time
        self.assertAlmostEqual(self.origami.do('step', steps=7).time, start + 7 * STEP, delta=1e-9)

    def test_resume_runs_and_pause_stops(self):
        start, began = self.origami.do('step', steps=1).time, time.time()
        self.origami.state()  # is heard, so that the steps passed are counted from it
        self.origami.do('resume')
        self.origami.pass_steps(30)
        self.origami.do('pause')
        end = self.origami.do('step', steps=1).time
        self.assertGreater(end - start, 30 * STEP)
        self.assertLess(end - start, time.time() - began + 2 * STEP, 'faster than real time')
        self.origami.stand_still()
        self.assertAlmostEqual(self.origami.do('step', steps=1).time, end + STEP, delta=1e-9)

    def test_reset_gives_the_paper_as_it_was(self):
        flat = self.positions()
        revision = self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1).revision
        self.origami.do('pin', vertices=[0])
        self.origami.do('step', steps=20)
        self.origami.do('reset')
        state = self.origami.state()
        self.assertEqual(self.positions(), flat)
        self.assertEqual((len(state.creases), len(state.pinned)), (0, 0))
        self.assertGreater(state.revision, revision)
        self.assertEqual(self.origami.last_edit('reset').revision, state.revision)

    def test_save_knows_four_kinds_of_file(self):
        vertices = len(self.origami.sheet().flat_positions)
        triangles = len(self.origami.sheet().triangles)
        starts = {'.fold': b'{', '.obj': b'# shell_origami', '.stl': b'shell_origami', '.ply': b'ply\n'}
        for extension, start in starts.items():
            path = self.path('paper' + extension)
            self.origami.do('save', path=path)
            with open(path, 'rb') as saved:
                content = saved.read()
            self.assertEqual(content[:len(start)], start, path)
            if extension == '.fold':
                self.assertEqual(len(json.loads(content)['faces_vertices']), triangles)
            elif extension == '.obj':
                self.assertEqual((content.count(b'\nv '), content.count(b'\nf ')), (vertices, triangles))
            elif extension == '.stl':
                self.assertEqual(len(content), 84 + 50 * triangles)  # binary: a head, facets
            else:
                self.assertEqual(content.count(b'\n3 '), triangles)


if __name__ == '__main__':
    rospy.init_node('services_test')
    rostest.rosrun('shell_origami', 'services_test', ServicesTest)
