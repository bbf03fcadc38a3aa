#!/usr/bin/python3
"""A goal of ~fold_recipe folds the paper, tells how far it is, and ends in exactly one way."""

import math
import os
import shutil
import signal
import subprocess
import tempfile

import rospy
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray

from origami_client import NodeTest, Recorder, line
from recipe_goal import Goal, connect
from shell_origami.msg import FoldRecipeActionFeedback, FoldRecipeActionResult

TERMINAL = {GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.REJECTED,
            GoalStatus.RECALLED, GoalStatus.LOST}
SHEET = 'sheet: {size: [0.1, 0.05], max_edge: 0.02}\n'
FOLD = '  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: %g, name: middle}]\n    duration: %g\n'
PIN = '  - pin: {region: [[0, 0], [0.02, 0], [0.02, 0.05], [0, 0.05]]}\n'
QUICK = SHEET + 'steps:\n' + PIN + FOLD % (90, 0.4) + '  - settle: {timeout: 1}\n'
LONG = SHEET + 'steps:\n' + PIN + FOLD % (170, 60)

FOLDER = tempfile.mkdtemp()


def written(name, text):
    path = os.path.join(FOLDER, name)
    with open(path, 'wb') as recipe:
        recipe.write(text if isinstance(text, bytes) else text.encode())
    return path


# Fields of a goal, and words that its rejection must hold.
REJECTIONS = [
    (dict(), ['recipe, yaml', 'none']),
    (dict(recipe='dog', yaml=QUICK), ['recipe and yaml']),
    (dict(recipe='cat'), ['cat', 'no such file']),
    (dict(recipe='/nowhere/cat.yaml'), ['/nowhere/cat.yaml', 'no such file']),
    (dict(recipe=FOLDER), [FOLDER, 'no such file']),
    (dict(recipe='/dev/zero'), ['/dev/zero', 'no such file']),
    (dict(recipe='x' * 100000), ['xxx', '...']),
    (dict(recipe='a\0b'), ['recipe is "a']),
    (dict(recipe=written('rubbish.yaml', bytes(range(256)) * 100)), ['rubbish.yaml']),
    (dict(recipe=written('empty.yaml', '')), ['empty.yaml', 'map']),
    (dict(recipe=written('paper.fold', '{"vertices_coords": []}')), ['paper.fold', 'vertices_coords']),
    (dict(yaml='\x01\x02\x7f\0'), ['yaml']),
    (dict(yaml='just words'), ['yaml', 'map']),
    (dict(yaml='steps: ['), ['yaml', 'line']),
    (dict(yaml='steps: 3'), ['steps', 'list']),
    (dict(yaml='steps:\n  - wave: hello'), ['line 2', 'wave']),
    (dict(yaml='steps:\n' + FOLD % (float('nan'), 1)), ['angle_deg', 'nan']),
    (dict(yaml='steps:\n' + FOLD % (90, float('inf'))), ['duration', 'inf']),
    (dict(yaml='steps:\n' + FOLD % (180, 1)), ['180']),
    (dict(yaml='sheet: {size: [.nan, 1]}'), ['nan']),
    (dict(yaml='sheet: {size: [1000, 1000], max_edge: 0.001}'), ['max_edge', '0.001']),
    (dict(yaml='sheet: {pattern: /nowhere/crane.fold}'), ['/nowhere/crane.fold']),
    (dict(yaml=SHEET + 'material: {thickness: -1}'), ['-1']),
    (dict(yaml='material: {thickness: 2.0e-4}'), ['material', 'no sheet']),
    (dict(yaml='solver: {gamma: 0.7}'), ['solver', 'no sheet']),
    (dict(yaml='gravity: [0, 0, -9.81]'), ['gravity', 'no sheet']),
    (dict(yaml='#' * 20000000), ['20000000', 'bytes']),
    (dict(yaml='gravity: [%s, 0, 0]' % ('x' * 900000)), ['xxx', '...']),
    (dict(yaml='[' * 100000), ['yaml']),
    (dict(yaml='steps: [&s {fold: [&f {crease: all, angle_deg: 1}%s]}%s]' % (', *f' * 5000, ', *s' * 5000)),
     ['1000000 values']),
]


class RecipeActionTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(RecipeActionTest, cls).setUpClass()
        cls.results = Recorder('/origami/fold_recipe/result', FoldRecipeActionResult)
        cls.feedback = Recorder('/origami/fold_recipe/feedback', FoldRecipeActionFeedback)
        cls.statuses = Recorder('/origami/fold_recipe/status', GoalStatusArray)
        cls.client = connect()
        cls.statuses.wait()

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(FOLDER)

    def assertEnds(self, goal, status, *words):
        """It ends so, once, and stays so."""
        ended, text = goal.wait()
        self.assertEqual(ended, status, text)
        for word in words:
            self.assertIn(word, text)
        def terminal(array):
            return [s.status for s in array.status_list
                    if s.goal_id.id == goal.id() and s.status in TERMINAL]
        # Results and statuses come on other connections than those of the goal's client.
        self.results.wait(lambda result: result.status.goal_id.id == goal.id())
        self.statuses.wait(terminal)
        for _ in range(2):  # a second end would be reported by now
            self.statuses.wait(since=len(self.statuses.all()))
        results = [r for r in self.results.all() if r.status.goal_id.id == goal.id()]
        self.assertEqual([r.status.status for r in results], [status])
        reported = {s for array in self.statuses.all() for s in terminal(array)}
        self.assertEqual(reported, {status})

    def middle(self):
        return self.origami.state().creases[0]

    def is_paused(self):
        return 'to be paused' not in self.origami.call('step', steps=1).message

    def test_a_recipe_is_folded(self):
        before = self.origami.state()
        goal = Goal(self.client, yaml=QUICK)
        self.assertEnds(goal, GoalStatus.SUCCEEDED)
        self.assertFalse(self.is_paused(), 'a goal lets time run')
        self.feedback.wait(lambda m: m.status.goal_id.id == goal.id() and m.feedback.progress == 1)
        feedback = [m.feedback for m in self.feedback.all() if m.status.goal_id.id == goal.id()]
        progress = [f.progress for f in feedback]
        self.assertEqual(progress, sorted(progress))
        self.assertEqual((progress[0], progress[-1]), (0, 1))
        self.assertTrue(any(0 < part < 1 for part in progress), progress)
        self.assertEqual({f.steps for f in feedback}, {3})
        self.assertEqual((feedback[-1].step, feedback[-1].doing), (3, 'done'))
        times = [f.sim_time.to_sec() for f in feedback]
        self.assertEqual(times, sorted(times))
        self.assertGreater(times[-1] - times[0], 0.4)
        result = goal.handle.get_result()
        self.assertEqual(len(result.creases), 1)
        self.assertAlmostEqual(result.creases[0].angle, math.pi / 2, delta=0.1)
        self.assertTrue(0 < result.max_strain < 1e-2, result.max_strain)
        self.assertGreater(self.origami.sheet().revision, before.revision)
        edits = [edit.kind for edit in self.origami.edits_since(before.edits)]
        self.assertEqual(edits, ['load', 'pin', 'fold'])

    def test_a_recipe_without_a_sheet_folds_the_paper_that_lies_there(self):
        self.assertEnds(Goal(self.client, yaml=QUICK), GoalStatus.SUCCEEDED)
        positions = len(self.origami.state().positions)
        self.assertEnds(Goal(self.client, yaml='steps:\n' + FOLD % (-30, 0.3)), GoalStatus.SUCCEEDED)
        state = self.origami.state()
        self.assertEqual((len(state.positions), len(state.creases)), (positions, 1))
        self.assertAlmostEqual(state.creases[0].rest_angle, -math.pi / 6, delta=1e-6)
        self.assertGreater(len(state.pinned), 3, 'still held')

    def test_cancel_stops_the_fold_where_it_is(self):
        # Long enough that it is under way still when the request to cancel arrives.
        goal = Goal(self.client, yaml=SHEET + 'steps:\n' + PIN + FOLD % (170, 10))
        self.origami.states.wait(lambda state: state.creases and state.creases[0].rest_angle > 0.3,
                                 since=len(self.origami.states.all()), timeout=20)
        goal.handle.cancel()
        self.assertEnds(goal, GoalStatus.PREEMPTED, 'canceled')
        self.assertFalse(self.is_paused())
        self.assertEqual(len(goal.handle.get_result().creases), 1)
        crease = self.middle()
        self.assertTrue(0.3 < crease.rest_angle < 2.9, crease)
        self.assertEqual(crease.target_angle, crease.rest_angle)
        self.origami.last_edit('stop')
        self.origami.do('step', steps=120)
        self.assertEqual(self.middle().rest_angle, crease.rest_angle)
        self.assertAlmostEqual(self.middle().angle, crease.rest_angle, delta=0.1)
        self.assertEnds(Goal(self.client, yaml=QUICK), GoalStatus.SUCCEEDED)

    def test_paper_that_settles_at_once_is_where_the_next_step_begins(self):
        settled = '  - settle: {quasi_static: true, timeout: 0}\n'
        before = self.origami.state().edits
        goal = Goal(self.client, yaml=SHEET + 'steps:\n' + PIN + FOLD % (90, 0.1) + settled +
                    '  - unpin: all\n')
        status, text = goal.wait()
        self.assertEqual(status, GoalStatus.SUCCEEDED, text)
        edits = [edit.kind for edit in self.origami.edits_since(before)]
        self.assertEqual(edits, ['load', 'pin', 'fold', 'settle', 'unpin'])
        angle = goal.handle.get_result().creases[0].angle
        self.assertAlmostEqual(angle, math.pi / 2, delta=1e-3)

    def test_a_second_goal_is_rejected(self):
        first = Goal(self.client, recipe=written('long.yaml', LONG))
        first.wait_for_progress(0.001)
        second = Goal(self.client, yaml=QUICK)
        self.assertEnds(second, GoalStatus.REJECTED, 'long', 'under way')
        self.assertFalse(first.ended.is_set(), 'the first goes on')
        second.handle.cancel()  # too late
        self.assertFalse(first.ended.wait(0.3), 'and goes on still')
        first.handle.cancel()
        self.assertEnds(first, GoalStatus.PREEMPTED)

    def test_another_paper_aborts_the_goal(self):
        requests = [('reset', {}, 'reset'), ('load', {'path': written('quick.yaml', QUICK)}, 'another')]
        for service, fields, word in requests:
            goal = Goal(self.client, yaml=LONG)
            goal.wait_for_progress(0.001)
            self.origami.do(service, **fields)
            self.assertEnds(goal, GoalStatus.ABORTED, word, 'step 2 of 2')
            self.assertEqual(len(self.origami.state().creases), 0)

    def test_what_the_paper_refuses_aborts_the_goal_and_pauses(self):
        nose = SHEET + 'steps:\n  - fold: [{crease: nose, angle_deg: 10}]\n'
        self.assertEnds(Goal(self.client, yaml=nose), GoalStatus.ABORTED, 'nose', 'step 1 of 1')
        self.assertTrue(self.is_paused())

    def test_a_step_that_does_not_converge_aborts_the_goal_and_pauses(self):
        wild = (SHEET + 'gravity: [0, 0, -10000]\nmaterial: {density: 1.0e-9}\n'
                'solver: {max_iterations: 1, tolerance: 1.0e-300, time_step: 0.5}\nsteps:\n' +
                PIN + FOLD % (179, 0) + '  - settle: {timeout: 5}\n')
        self.assertEnds(Goal(self.client, yaml=wild), GoalStatus.ABORTED, 'step 3 of 3')
        self.assertTrue(self.is_paused())

    def test_goals_that_make_no_sense_are_rejected_and_change_nothing(self):
        before = self.origami.state()
        for fields, words in REJECTIONS:
            goal = Goal(self.client, **fields)
            status, text = goal.wait()
            self.assertEqual(status, GoalStatus.REJECTED, '%.200s: %s' % (fields, text))
            for word in words:
                self.assertIn(word, text, '%.200s' % fields)
            self.assertLess(len(text), 1100)
        after = self.origami.state()
        self.assertEqual(after.positions, before.positions)
        self.assertEqual(after.revision, before.revision)
        self.assertEqual(after.edits, before.edits)
        self.assertTrue(self.is_paused())

    def test_cancel_requests_of_any_time_and_id(self):
        """A server of actionlib's own dies of the first."""
        cancel = self.client.pub_cancel
        ages = rospy.Time(4294967295, 999999999)
        cancel.publish(GoalID(id='unknown', stamp=ages))
        for i in range(200):
            cancel.publish(GoalID(id='unknown %d' % i))
        # A goal is on another connection than the requests, and may overtake the first of them.
        goal = Goal(self.client, yaml=LONG)
        while not goal.starts():
            goal = Goal(self.client, yaml=LONG)
        cancel.publish(GoalID(stamp=ages))
        self.assertEnds(goal, GoalStatus.PREEMPTED)
        self.assertEnds(Goal(self.client, yaml=QUICK), GoalStatus.SUCCEEDED)

    def test_folds_of_services_take_part(self):
        goal = Goal(self.client, yaml=LONG)
        goal.wait_for_progress(0.001)
        self.origami.do('fold', line=line(0.08, 0, 0.08, 0.05), angle=0.5, duration=0.1)
        goal.handle.cancel()
        self.assertEnds(goal, GoalStatus.PREEMPTED)
        self.assertEqual(len(self.origami.state().creases), 2)

    def fold_recipe(self, *arguments, **options):
        return subprocess.Popen(('rosrun', 'shell_origami', 'fold_recipe') + arguments, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)

    def test_the_client_shows_progress_and_result(self):
        written('quick.yaml', QUICK)
        client = self.fold_recipe('quick.yaml', cwd=FOLDER)
        out, errors = client.communicate(timeout=30)
        self.assertEqual((client.returncode, errors), (0, ''))
        lines = out.splitlines()
        self.assertTrue(any('step 2/3  fold' in text for text in lines), out)
        self.assertIn('100 %  step 3/3  done', out)
        self.assertIn('largest strain', lines[-2])
        name, angle, unit = lines[-1].split()
        self.assertEqual((name, unit), ('middle', 'deg'))
        self.assertAlmostEqual(float(angle), 90, delta=6)

    def test_the_client_fails_with_the_reason(self):
        for arguments, reason in [(('cat',), 'cat'), (('./cat.yaml',), os.getcwd() + '/cat.yaml'),
                                  (('dog', '--node', '/nobody'), '/nobody')]:
            client = self.fold_recipe(*arguments)
            out, errors = client.communicate(timeout=30)
            self.assertEqual((client.returncode, out), (1, ''))
            self.assertIn(reason, errors)
            self.assertEqual(len(errors.splitlines()), 1, errors)

    def test_the_client_cancels_on_ctrl_c(self):
        since = len(self.results.all())
        client = self.fold_recipe(written('long.yaml', LONG))
        self.assertIn('step 1/2', client.stdout.readline())
        client.send_signal(signal.SIGINT)
        _, errors = client.communicate(timeout=30)
        self.assertEqual(client.returncode, 130)
        self.assertIn('canceled', errors)
        self.assertNotIn('Traceback', errors)
        self.results.wait(lambda r: r.status.status == GoalStatus.PREEMPTED, since=since)


if __name__ == '__main__':
    rospy.init_node('recipe_action_test')
    rostest.rosrun('shell_origami', 'recipe_action_test', RecipeActionTest)
