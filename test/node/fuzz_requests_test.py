#!/usr/bin/python3
"""Thousands of random requests in a row: after each the node lives, what was refused has changed
nothing, and the sheet is whole."""

import collections
import os
import shutil
import subprocess
import tempfile

import rospy
import rostest
import tf2_ros
from actionlib_msgs.msg import GoalID, GoalStatus
from dynamic_reconfigure.srv import Reconfigure
from geometry_msgs.msg import PointStamped, TransformStamped

from origami_client import NodeTest, Recorder, wait_until
from random_requests import RandomRequests
from shell_origami.msg import FoldRecipeActionFeedback, FoldRecipeActionGoal, FoldRecipeActionResult
from whole_sheet import Broken, area, check_sheet, check_state

AREAS = {'square': 0.15 * 0.15, 'strip': 0.1 * 0.05}  # [m^2]
STRIP = 'sheet: {size: [0.1, 0.05], max_edge: 0.03}\nsteps: []\n'
LONGEST_SENTENCE = 1100
FRAMES = ['hand', '9 lives', '_']
PHYSICS = ['gravity_x', 'gravity_y', 'gravity_z', 'air_damping', 'fold_duration']


def still_frames(names):
    broadcaster = tf2_ros.StaticTransformBroadcaster()
    transforms = []
    for name in names:
        transform = TransformStamped()
        transform.header.frame_id = 'world'
        transform.child_frame_id = name
        transform.transform.translation.z = 0.1
        transform.transform.rotation.w = 1
        transforms.append(transform)
    broadcaster.sendTransform(transforms)
    return broadcaster


class FuzzRequestsTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(FuzzRequestsTest, cls).setUpClass()
        cls.frames = still_frames(FRAMES)
        cls.live = rospy.ServiceProxy('/origami/live/set_parameters', Reconfigure)
        cls.results = Recorder('/origami/fold_recipe/result', FoldRecipeActionResult)
        cls.feedback = Recorder('/origami/fold_recipe/feedback', FoldRecipeActionFeedback)
        cls.clicks = rospy.Publisher('/clicked_point', PointStamped, queue_size=10)
        cls.goals = rospy.Publisher('/origami/fold_recipe/goal', FoldRecipeActionGoal, queue_size=10)
        cls.cancels = rospy.Publisher('/origami/fold_recipe/cancel', GoalID, queue_size=10)
        cls.folder = tempfile.mkdtemp()
        for frame in FRAMES:  # until the node has heard of them
            cls.origami.do('pin', vertices=[0], frame_id=frame)
        with open(os.path.join(cls.folder, 'strip.yaml'), 'w') as strip:
            strip.write(STRIP)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def look(self):
        """The sheet and the state as they are now, checked. Pauses."""
        states = self.origami.states
        states.forget()
        state = self.origami.state()
        if state.revision != self.sheet.revision:
            self.sheet = self.origami.sheet()
            self.origami.sheets.forget()
            check_sheet(self.sheet)
            closest = min(AREAS.values(), key=lambda a: abs(area(self.sheet) - a))
            self.assertLess(abs(area(self.sheet) / closest - 1), 1e-6)
        check_state(self.sheet, state)
        return state

    def assertSame(self, before, after):
        for name in ('edits', 'revision', 'positions', 'creases', 'pinned'):
            self.assertEqual(getattr(after, name), getattr(before, name), name)

    # One request of each kind.

    def ask_service(self, before):
        service, fields = self.random.service(self.sheet)
        self.asked = '%s %s' % (service, fields)
        answer = self.origami.call(service, **fields)
        after = self.look()
        self.assertLess(len(answer.message), LONGEST_SENTENCE)
        self.assertNotIn('\n', answer.message)
        self.seen[service + (' done' if answer.success else ' refused')] += 1
        if not answer.success and not answer.message.startswith('stopped after'):
            self.assertSame(before, after)
        return after

    def ask_goal(self, before):
        goal = FoldRecipeActionGoal(goal=self.random.goal())
        goal.goal_id.id = 'goal %d' % sum(self.seen.values())
        goal.goal_id.stamp = rospy.Time(self.random.random.choice([0, 1, 2 ** 32 - 1]), 0)
        self.asked = 'goal %s' % goal.goal
        self.results.forget()
        self.feedback.forget()
        self.goals.publish(goal)
        started = self.wait_for_answer(goal.goal_id.id)
        after = self.look()
        self.seen['goal ' + ('done' if started else 'refused')] += 1
        if not started:
            self.assertSame(before, after)
        return after

    def wait_for_answer(self, goal):
        """Whether the goal was accepted. One that ends at once may be heard to end before it is heard
        to begin."""
        def of_goal(messages):
            return [m.status for m in messages if m.status.goal_id.id == goal]
        wait_until(lambda: of_goal(self.feedback.all()) or of_goal(self.results.all()),
                   'the goal is answered', period=0.002)
        return not any(status.status in (GoalStatus.REJECTED, GoalStatus.RECALLED)
                       for status in of_goal(self.results.all()))

    def ask_cancel(self, before):
        stamp = rospy.Time(self.random.random.choice([0, 0, 1, 2 ** 32 - 1]), 0)
        self.asked = 'cancel %s' % stamp
        self.cancels.publish(GoalID(id=self.random.text(), stamp=stamp))
        self.seen['cancel'] += 1
        return self.look()

    def ask_click(self, before):
        click = self.random.stamped()
        self.asked = 'click %s' % click
        self.clicks.publish(click)
        self.seen['click'] += 1
        after = self.look()
        self.assertSame(before, after)
        return after

    def ask_live(self, before):
        config = self.random.live()
        self.asked = 'live %s' % config
        shown = self.live(config).config
        after = self.look()
        physics = [value.value for value in shown.doubles if value.name in PHYSICS]
        self.seen['live ' + ('done' if physics != self.physics else 'refused')] += 1
        if physics == self.physics:
            self.assertSame(before, after)
        self.physics = physics
        return after

    def test_random_requests(self):
        calls, seed = rospy.get_param('~calls'), rospy.get_param('~seed')
        rospy.loginfo('%d calls of seed %d', calls, seed)
        papers = [os.path.join(self.folder, name) for name in ('strip.yaml', 'a.fold', 'b.fold')]
        self.random = RandomRequests(seed, self.folder, papers)
        self.seen = collections.Counter()
        self.physics = None
        self.sheet = self.origami.sheet()
        state = self.look()
        kinds = [self.ask_service, self.ask_goal, self.ask_cancel, self.ask_click, self.ask_live]
        for number in range(calls):
            ask = self.random.random.choices(kinds, weights=[85, 3, 3, 3, 6])[0]
            try:
                state = ask(state)
            except Exception as error:
                raise Broken('call %d of seed %d, %.2000s: %s' % (number, seed, self.asked, error))
        rospy.loginfo('%s', ', '.join('%s %d' % entry for entry in sorted(self.seen.items())))
        for service in ('fold', 'fold_through', 'layers', 'turn_over', 'pin', 'unpin', 'add_vertex', 'load',
                        'save', 'step', 'settle'):
            self.assertGreater(self.seen[service + ' done'], 0, service)

    def test_requests_that_are_no_yaml(self):
        before = self.origami.state()
        for service, text in [('fold', '{line: [{x: 0'), ('fold', '[[[['), ('fold', '{angel: 1}'),
                              ('pin', '{vertices: [-1]}'), ('step', '{steps: many}'),
                              ('add_vertex', '{edge: [0], fraction: 0.5}')]:
            called = subprocess.run(['rosservice', 'call', '/origami/' + service, text],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.assertNotEqual(called.returncode, 0, text)
        self.assertSame(before, self.origami.state())


if __name__ == '__main__':
    rospy.init_node('fuzz_requests_test')
    rostest.rosrun('shell_origami', 'fuzz_requests_test', FuzzRequestsTest)
