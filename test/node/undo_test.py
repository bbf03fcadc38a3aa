#!/usr/bin/python3
"""~undo makes the paper again as it was before its last edits, and it goes on as it would have."""

import os
import random
import shutil
import tempfile

from actionlib_msgs.msg import GoalStatus
import dynamic_reconfigure.client
from geometry_msgs.msg import Point
import rospy
import rostest

from shell_origami.msg import Landmark

from moving_frame import MovingFrame
from origami_client import NodeTest, distance, line, wait_until
from recipe_goal import Goal, connect

SIDE = 0.15
STRIP = '''sheet: {size: [0.1, 0.05], max_edge: 0.02}
steps:
  - pin: {region: [[0, 0], [0.02, 0], [0.02, 0.05], [0, 0.05]]}
  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: 90, name: a},
           {line: [[0.08, 0], [0.08, 0.05]], angle_deg: -60, name: b}]
    duration: 0.4
  - settle: {timeout: 0.5}
  - fold: [{crease: a, angle_deg: 20}]
    duration: 0.3
'''
# Nothing can turn the tip inside out: it is held.
HELD = '''sheet: {size: [0.1, 0.1], max_edge: 0.02}
contact: {enabled: false}
steps:
  - fold: [{line: [[0, 0], [0.1, 0.1]], angle_deg: -178}]
  - pin: {points: [[0.1, 0.1], [0.08, 0.1], [0.1, 0.08], [0.02, 0], [0, 0.02]]}
  - reverse: {flap: [0.1, 0.1], through: [[0.06, 0.06], [0.1, 0.08]]}
    duration: 1
'''


class UndoTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(UndoTest, cls).setUpClass()
        cls.goals = connect()
        cls.folder = tempfile.mkdtemp()
        for name, sheet in (('square', 'size: [0.15, 0.15]'), ('strip', 'size: [0.1, 0.05]')):
            with open(cls.path(name), 'w') as recipe:
                recipe.write('sheet: {%s, max_edge: 0.02}\nsteps: []\n' % sheet)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name + '.yaml')

    def setUp(self):
        super(UndoTest, self).setUp()
        self.origami.do('load', path=self.path('square'))

    def fold(self, x, angle, **fields):
        return self.origami.do('fold', line=line(x, 0, x, SIDE), angle=angle, duration=0.5, **fields)

    def assertSamePaper(self, state, expected):
        """But for names and numbers that grow on."""
        self.assertEqual(state.positions, expected.positions)
        self.assertEqual(state.pinned, expected.pinned)
        for field in ('id', 'angle', 'rest_angle', 'target_angle'):
            self.assertEqual([getattr(c, field) for c in state.creases],
                             [getattr(c, field) for c in expected.creases], field)

    def at_rest(self):
        """The paper once it has come to rest, which it does at the same place however long it was
        stopped on the way."""
        self.origami.do('resume')

        def still():
            last = self.origami.states.all()[-2:]
            return last[0].step < last[-1].step and last[0].positions == last[-1].positions
        wait_until(still, 'the paper rests', timeout=60)
        return self.origami.state()

    def refused(self, *words, **fields):
        answer = self.origami.call('undo', **fields)
        self.assertFalse(answer.success)
        for word in words:
            self.assertIn(word, answer.message)

    def test_an_edit_is_named_by_its_number(self):
        before = self.origami.state()
        first = self.fold(0.05, 1.0).edit
        self.origami.do('pin', vertices=[0])
        corner = Landmark()
        corner.flat.x = corner.flat.y = SIDE
        through = self.origami.do('fold_through', axiom='bring', points=[Landmark(), corner])
        expected = self.origami.state()
        self.origami.do('pin', vertices=[1])
        # Any of the creases that were made together stands for all of them.
        last = self.origami.do('pin', vertices=[2]).edit
        self.origami.do('undo', since=last - 1)
        self.assertSamePaper(self.origami.state(), expected)
        self.origami.do('undo', since=through.edit)
        self.assertEqual(len(self.origami.state().pinned), 1)
        self.origami.do('undo', since=first)
        self.assertSamePaper(self.origami.state(), before)
        self.assertEqual(self.origami.last_edit('undo').undone, first)
        self.refused('since is 1000000,', since=1000000)
        self.refused('only one of them', since=first, edits=1)

    def test_a_fold_under_way_goes_on_as_if_the_next_one_had_not_been(self):
        self.fold(0.05, 2.0)
        self.origami.do('step', steps=10)
        before = self.origami.state()
        self.origami.do('step', steps=30)
        expected = self.origami.state()

        self.origami.do('reset')
        self.fold(0.05, 2.0)
        self.origami.do('step', steps=10)
        self.fold(0.1, -1.0)
        self.origami.do('pin', vertices=[0])
        self.origami.do('step', steps=15)
        undo = self.origami.do('undo', edits=2)
        state = self.origami.state()
        self.assertSamePaper(state, before)
        self.assertEqual(state.edits, undo.edit)
        self.assertEqual(state.revision, undo.revision)
        self.assertEqual(self.origami.sheet().revision, undo.revision)
        self.origami.do('step', steps=30)
        self.assertSamePaper(self.origami.state(), expected)

    def test_one_edit_after_the_other(self):
        papers = [self.origami.state()]
        for x in (0.03, 0.06, 0.09):
            self.fold(x, 0.5)
            self.origami.do('step', steps=5)
            papers.append(self.origami.state())
        for number in (2, 1, 0):
            self.origami.do('undo')
            self.assertSamePaper(self.origami.state(), papers[number])

    def random_edit(self, r, few_folds):
        """Makes an edit that the paper takes, and lets some time pass after it."""
        kinds = ['fold', 'fold', 'pin', 'unpin', 'add_vertex']
        if few_folds:  # what takes long on paper with many of them
            kinds += ['fold_through', 'settle']
        def place():
            return Point(r.uniform(0, SIDE), r.uniform(0, SIDE), 0)

        while True:
            kind = r.choice(kinds)
            fields = {}
            if kind == 'fold':
                fields = dict(line=[place(), place()], angle=r.uniform(-1, 1), duration=0.2)
            elif kind == 'fold_through':
                fields = dict(axiom='bring', points=[Landmark(flat=place()) for _ in range(2)],
                              angle=r.uniform(0.1, 1), duration=0.2)
            elif kind == 'pin':
                fields = dict(points=[place()])
            elif kind == 'add_vertex':
                corners = r.choice(self.origami.sheet().triangles).vertex_indices
                fields = dict(edge=list(corners[:2]), fraction=0.5)
            if self.origami.call(kind, **fields).success:
                break
        self.origami.do('step', steps=r.randrange(1, 4))
        return kind

    def test_fifty_random_edits_one_by_one(self):
        r = random.Random(7)
        with open(self.path('coarse'), 'w') as recipe:  # 50 of its papers find room
            recipe.write('sheet: {size: [0.15, 0.15], max_edge: 0.15}\nsteps: []\n')
        self.origami.do('load', path=self.path('coarse'))
        papers, kinds = [], []
        for number in range(50):
            papers.append((self.origami.sheet(), self.origami.state()))
            kinds.append(self.random_edit(r, few_folds=number < 15))
        self.assertEqual(len(set(kinds)), 6, kinds)
        for number in reversed(range(50)):
            self.origami.do('undo')
            sheet, state = papers[number]
            self.assertSamePaper(self.origami.state(), state)
            now = self.origami.sheet()
            self.assertEqual(now.flat_positions, sheet.flat_positions, kinds[number])
            self.assertEqual(now.triangles, sheet.triangles, kinds[number])

    def test_settle_load_and_reset_are_undone(self):
        self.fold(0.05, 1.0)
        self.origami.do('step', steps=7)
        before = self.origami.state()
        self.origami.do('settle')
        self.origami.do('undo')
        self.assertSamePaper(self.origami.state(), before)
        self.origami.do('reset')
        self.origami.do('undo')
        self.assertSamePaper(self.origami.state(), before)

        self.origami.do('load', path=self.path('strip'))
        self.origami.do('undo')
        self.assertSamePaper(self.origami.state(), before)
        self.origami.do('reset')  # to the square, not to the strip
        widest = max(p.x for p in self.origami.sheet().flat_positions)
        self.assertAlmostEqual(widest, SIDE, delta=1e-6)

    def test_what_is_too_long_ago_is_refused(self):
        with open(self.path('fine'), 'w') as recipe:
            recipe.write('sheet: {size: [0.15, 0.15], max_edge: 0.003}\nsteps: []\n')
        self.origami.do('load', path=self.path('fine'))
        self.fold(0.05, 1.0)
        before = self.origami.state()
        self.refused('edits is 100000', 'only the last', edits=100000)
        after = self.origami.state()
        self.assertEqual(after.edits, before.edits)
        self.assertSamePaper(after, before)
        # Memory is bounded: in 60 MB not all of these papers find room, but many do.
        for _ in range(100):
            self.origami.do('pin', vertices=[0])
        self.refused('only the last', edits=101)
        self.origami.do('undo', edits=20)
        for _ in range(200):
            answer = self.origami.call('undo')
            if not answer.success:
                break
        self.assertEqual(answer.message, 'there is no edit that can be undone')

    def test_live_parameters_and_frames_are_left_alone(self):
        hand = MovingFrame('hand')
        live = dynamic_reconfigure.client.Client('/origami/live', timeout=10)
        self.addCleanup(live.update_configuration, {'gravity_z': 0.0})
        self.origami.do('pin', vertices=[0], frame_id='hand')
        self.fold(0.05, 1.0)
        live.update_configuration({'gravity_z': -2.0})
        hand.go((0, 0, 0.02, 0), 0.2)
        self.origami.do('step', steps=20)
        self.assertGreater(self.origami.state().edits, 5)  # those of the frame
        self.origami.do('undo')
        state = self.origami.state()
        self.assertEqual(state.creases, [])
        self.assertEqual(list(state.pinned), [0])
        self.assertEqual(live.get_configuration()['gravity_z'], -2.0)
        self.origami.do('step', steps=1)
        self.assertLess(min(p.z for p in self.origami.state().positions), 0)  # it falls

    def test_a_recipe_under_way_goes_back_and_folds_the_same(self):
        whole = Goal(self.goals, yaml=STRIP)
        self.assertIn('the recipe is done', whole.wait()[1])
        expected = self.at_rest()

        self.origami.do('reset')
        goal = Goal(self.goals, yaml=STRIP)
        self.assertTrue(goal.starts())
        goal.wait_for_progress(0.5)
        self.origami.do('pause')
        self.origami.do('undo')  # both folds of the step, which were made together
        self.assertEqual(len(self.origami.state().creases), 0)
        self.origami.do('resume')
        self.assertIn('the recipe is done', goal.wait()[1])
        state = self.at_rest()
        self.assertEqual(len(state.creases), len(expected.creases))
        for p, q in zip(state.positions, expected.positions):
            self.assertLess(distance(p, q), 1e-6)

    def test_a_manoeuvre_that_fails_is_taken_back(self):
        goal = Goal(self.goals, yaml=HELD)
        status, text = goal.wait(60)
        self.assertEqual(status, GoalStatus.ABORTED)
        for words in ('step 3, reverse, failed', 'as it was before'):
            self.assertIn(words, text)
        state = self.origami.state()
        self.assertEqual(len(state.creases), 1)  # none of the tip's
        self.assertEqual(len(state.pinned), 5)
        pinned = self.origami.edits.wait(lambda edit: edit.kind == 'pin' and len(edit.vertices) == 5)
        undone = [e for e in self.origami.edits.all() if e.number > pinned.number and e.kind == 'undo']
        self.assertEqual(len(undone), 2)  # it was tried again
        self.origami.do('undo')
        self.assertEqual(list(self.origami.state().pinned), [])

    def test_a_recipe_whose_paper_is_undone_is_abandoned(self):
        self.fold(0.05, 1.0)
        before = self.origami.state()
        goal = Goal(self.goals, yaml=STRIP)
        self.assertTrue(goal.starts())
        goal.wait_for_progress(0.3)
        self.origami.do('pause')
        self.origami.do('undo', edits=3)  # a pin, the folds of a step, and the strip
        self.assertIn('undone', goal.wait()[1])
        self.assertSamePaper(self.origami.state(), before)


if __name__ == '__main__':
    rospy.init_node('undo_test')
    rostest.rosrun('shell_origami', 'undo_test', UndoTest)
