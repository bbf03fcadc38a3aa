#!/usr/bin/python3
"""~save writes a session as a recipe, which folds the same paper again."""

import json
import os
import shutil
import subprocess
import tempfile

import dynamic_reconfigure.client
import roslib.packages
import rospy
import rostest
import yaml
from geometry_msgs.msg import Point, Point32, PointStamped, Polygon, Vector3

from moving_frame import MovingFrame
from origami_client import NodeTest, line, wait_for_transform
from recipe_goal import Goal, connect
from shell_origami.msg import Landmark

SIDE = 0.15
BATCH = roslib.packages.find_node('shell_origami', 'origami_batch')[0]
STRIP = '''sheet: {size: [0.1, 0.05], max_edge: 0.02}
material: {crease_stiffness: 0.01}
names: {low: [0, 0.02], high: [0.1, 0.02]}
steps:
  - pin: {region: [[0, 0], [0.02, 0], [0.02, 0.05], [0, 0.05]]}
  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: 30, name: a},
           {line: [[0.08, 0], [0.08, 0.05]], angle_deg: -20, name: b}]
    duration: 0.4
  - settle: {timeout: 0.5}
  - turn_over: {}
  - settle: {quasi_static: true}
'''


def flat(x, y):
    return Landmark(flat=Point(x, y, 0))


class SaveRecipeTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(SaveRecipeTest, cls).setUpClass()
        cls.goals = connect()
        cls.live = dynamic_reconfigure.client.Client('/origami/live', timeout=10)

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        super(SaveRecipeTest, self).setUp()
        self.origami.do('load', path=self.write('sheet: {size: [0.15, 0.15], max_edge: 0.03}\nsteps: []\n'))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, text):
        with open(self.path('paper.yaml'), 'w') as file:
            file.write(text)
        return self.path('paper.yaml')

    def saved(self):
        """The text of the recipe."""
        self.origami.do('save', path=self.path('session.yaml'))
        with open(self.path('session.yaml')) as file:
            return file.read()

    def steps(self):
        return yaml.safe_load(self.saved())['steps']

    def positions(self, path):
        with open(path) as file:
            return [[float(word) for word in line.split()[1:]] for line in file if line.startswith('v ')]

    def assertFoldsTheSame(self, tolerance=1e-9):
        """The recipe folds the present paper; returns its text. Angles are told in single precision."""
        text = self.saved()
        out = self.path('out')
        run = subprocess.run([BATCH, self.path('session.yaml'), '--out', out], stderr=subprocess.PIPE,
                             universal_newlines=True)
        self.assertIn(run.returncode, (0, 3), '%s\n%s' % (run.stderr, text))
        with open(os.path.join(out, 'report.json')) as file:
            report = json.load(file)
        state = self.origami.state()
        self.assertEqual(len(report['creases']), len(state.creases), text)
        for crease, expected in zip(report['creases'], state.creases):
            self.assertAlmostEqual(crease['angle_deg_mean'] * 3.141592653589793 / 180, expected.angle,
                                   delta=1e-6, msg=text)
        self.origami.do('save', path=self.path('node.obj'))
        found = self.positions(os.path.join(out, 'final.obj'))
        expected = self.positions(self.path('node.obj'))
        self.assertEqual(len(found), len(expected))
        farthest = max(abs(a - b) for p, q in zip(found, expected) for a, b in zip(p, q))
        self.assertLess(farthest, tolerance, text)
        return text

    def wait_steps(self, count):
        self.origami.do('step', steps=count)

    def test_a_session_of_many_requests(self):
        self.wait_steps(7)
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1.1, duration=0.3)
        self.origami.do('fold', line=line(0.1, 0, 0.1, SIDE), angle=-0.7, duration=0.3)
        self.wait_steps(11)  # and none of these folds has ended
        self.origami.do('pin', points=[Point(0, 0, 0), Point(0, SIDE, 0)])
        self.origami.do('fold', crease='fold_0', angle=0.4, duration=0.2, stiffness=0.03)
        self.wait_steps(40)
        vertex = self.origami.do('add_vertex', edge=self.edge(), fraction=0.3).vertex
        self.wait_steps(3)
        self.origami.do('fold', vertices=[vertex, self.vertex_at(SIDE, SIDE)], angle=0.2)
        self.live.update_configuration({'gravity_z': -0.5})
        self.addCleanup(self.live.update_configuration, {'gravity_z': 0.0})
        self.wait_steps(9)
        self.origami.do('pin', region=Polygon([Point32(0, 0, 0), Point32(0.02, 0, 0), Point32(0, 0.02, 0)]))
        self.origami.do('settle')
        self.origami.do('fold', crease='fold_1', angle=-1.2345678901234567, duration=0.25)
        self.wait_steps(31)
        self.origami.do('unpin', vertices=[self.vertex_at(0, SIDE)])
        self.wait_steps(5)
        text = self.assertFoldsTheSame()
        for part in ('pin: {points: [[0, 0], [0, 0.15]]}', 'lasts: 0.18333', 'stiffness: 0.03',
                     'fraction: 0.3', 'configure: {gravity: [0, 0, -0.5]}', 'settle: {quasi_static: true}',
                     'region: [[0, 0]'):
            self.assertIn(part, text)
        fold = yaml.safe_load(text)['steps'][1 if 'wait' in text.split('fold')[0] else 0]['fold']
        self.assertEqual(len(fold), 2, text)  # they began together

    def edge(self):
        border = [i for i, p in enumerate(self.origami.sheet().flat_positions) if abs(p.y) < 1e-9]
        return sorted(border, key=lambda i: self.origami.sheet().flat_positions[i].x)[:2]

    def vertex_at(self, x, y):
        return next(i for i, p in enumerate(self.origami.sheet().flat_positions)
                    if abs(p.x - x) < 1e-6 and abs(p.y - y) < 1e-6)

    def test_folds_through_layers(self):
        self.origami.do('fold_through', axiom='bring', points=[flat(0, 0), flat(SIDE, SIDE)], angle=0.5,
                        duration=0.3)
        self.wait_steps(40)
        self.origami.do('turn_over')
        self.origami.do('fold_through', axiom='across', way='behind', angle=0.3, duration=0.2,
                        points=[flat(0, SIDE), flat(SIDE, SIDE), flat(0.1, SIDE), flat(SIDE, SIDE)])
        self.wait_steps(20)
        self.origami.do('undo')
        self.origami.do('fold_through', axiom='through', angle=0.3, duration=0.2, viewer=Vector3(0, 0, 1),
                        layers='flap', flap=flat(SIDE, SIDE), points=[flat(0.12, SIDE), flat(SIDE, 0.12),
                                                                     flat(SIDE, SIDE)])
        self.wait_steps(33)
        text = self.assertFoldsTheSame()
        self.assertIn('fold_through: {bring: [0, 0], to: [0.15, 0.15], angle_deg: 28.64788975654116}', text)
        self.assertIn('flap: [0.15, 0.15]', text)
        self.assertEqual(text.count('turn_over'), 2)
        self.assertNotIn('across', text)

    def test_at_rest_no_time_is_kept(self):
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=0.5, duration=0.2)
        self.wait_steps(3000)
        self.assertTrue(self.origami.state().settled)
        self.origami.do('fold', line=line(0.1, 0, 0.1, SIDE), angle=0.5, duration=0.2)
        self.wait_steps(30)
        self.assertLess(self.steps()[0]['lasts'], 40)
        self.assertFoldsTheSame()

    def test_time_that_passes_by_itself(self):
        self.origami.do('resume')
        for x, angle in ((0.05, 1.0), (0.1, -0.5), (0.075, 0.7)):
            self.origami.do('fold', line=line(x, 0, x, SIDE), angle=angle, duration=0.3)
            self.origami.pass_steps(13)
        self.origami.pass_steps(30)
        self.origami.do('pause')
        self.assertFoldsTheSame()

    def test_a_recipe_contributes_its_steps(self):
        self.assertIn('the recipe is done', Goal(self.goals, yaml=STRIP).wait()[1])
        self.origami.do('pause')
        self.origami.do('fold_through', axiom='through', angle=0.4, duration=0.2,
                        points=[Landmark(name='low'), Landmark(name='high'), flat(0.05, 0.05)])
        self.wait_steps(25)
        text = self.assertFoldsTheSame()
        saved, recipe = yaml.safe_load(text), yaml.safe_load(STRIP)
        for key in ('sheet', 'material', 'names'):
            self.assertEqual(saved[key], recipe[key])
        self.assertEqual(saved['steps'][:3], recipe['steps'][:3])
        self.assertIn('through: [low, high]', text)

    def test_a_recipe_that_is_canceled(self):
        goal = Goal(self.goals, yaml=STRIP.replace('duration: 0.4', 'duration: 5'))
        goal.wait_for_progress(0.1)
        self.goals.cancel_all_goals()
        goal.wait()
        self.origami.do('pause')
        self.assertIn('stop: {}', self.assertFoldsTheSame())

    def test_a_fold_under_way_is_ended(self):
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=0.5, duration=0.2)
        step, = self.steps()
        self.assertNotIn('lasts', step)

    def test_what_was_undone_reset_or_replaced_is_dropped(self):
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1.0, duration=0.2)
        self.wait_steps(10)
        self.live.update_configuration({'gravity_z': -0.1})
        self.addCleanup(self.live.update_configuration, {'gravity_z': 0.0})
        self.origami.do('fold', line=line(0.1, 0, 0.1, SIDE), angle=1.0, duration=0.2)
        self.wait_steps(10)
        self.origami.do('undo', edits=2)
        self.wait_steps(10)
        self.assertEqual([list(step)[0] for step in self.steps()], ['configure', 'wait'])
        self.assertFoldsTheSame()
        self.origami.do('reset')
        self.assertEqual(self.steps(), [])
        self.assertEqual(yaml.safe_load(self.saved())['gravity'], [0, 0, -0.1])
        self.origami.do('pin', vertices=[0])
        self.assertEqual(len(self.steps()), 1)
        self.origami.do('load', path=self.write(STRIP))
        self.assertEqual(self.steps(), [])
        self.origami.do('undo')  # but for the live parameters, those of the strip
        self.assertEqual(self.steps(), [{'pin': {'vertices': [0]}}, {'configure': {'gravity': [0, 0, 0]}}])

    def test_what_a_frame_carried_is_told(self):
        MovingFrame('hand').pose = (0.1, 0, 0, 0)
        wait_for_transform(lambda t: t.child_frame_id == 'hand')
        self.origami.do('pin', vertices=[0], frame_id='hand')
        self.wait_steps(3)
        self.origami.do('unpin')
        answer = self.origami.do('save', path=self.path('session.yaml'))
        self.assertIn('carried by hand', answer.message)
        text = self.saved()
        self.assertIn('# frame hand carried this', text)
        self.assertEqual([list(step)[0] for step in yaml.safe_load(text)['steps'] if 'wait' not in step],
                         ['pin', 'unpin'])

    def test_vertices_of_a_ball(self):
        ball = PointStamped(point=Point(0, 0, 0))
        ball.header.frame_id = 'world'
        pinned = self.origami.do('pin', center=ball, radius=0.04).vertices
        step, = self.steps()
        self.assertEqual(step, {'pin': {'vertices': list(pinned)}})

    def test_a_file_that_cannot_be_written(self):
        answer = self.origami.call('save', path='/nowhere/session.yaml')
        self.assertFalse(answer.success)
        self.assertIn('/nowhere/session.yaml', answer.message)


if __name__ == '__main__':
    rospy.init_node('save_recipe_test')
    rostest.rosrun('shell_origami', 'save_recipe_test', SaveRecipeTest)
