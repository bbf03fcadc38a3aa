#!/usr/bin/python3
"""While the node takes many steps, settles or reads a large file it answers every other request at
once, and ~pause ends it."""

import os
import shutil
import tempfile
import threading
import time

import rospy
import rostest
from geometry_msgs.msg import Point, Point32, Polygon

from origami_client import NodeTest, line, wait_until

SIDE = 0.15
# On an idle machine. The slowest of five may have waited for the machine.
PROMPT, SLOWEST = 0.05, 0.5  # [s]
RECIPE = 'sheet: {size: [0.15, 0.15], max_edge: %g}\nsteps: []\n'
# Large paper settles, and huge paper is read, for much longer than the requests of a test take.
SMALL, LARGE, HUGE = 0.02, 0.004, 0.0003
ALL = Polygon([Point32(-1, -1, 0), Point32(1, -1, 0), Point32(1, 1, 0), Point32(-1, 1, 0)])


class Waiting(threading.Thread):
    """A request whose answer is waited for in a thread of its own."""

    def __init__(self, origami, service, **fields):
        super(Waiting, self).__init__(daemon=True)
        self.request = lambda: origami.call(service, **fields)
        self.response = None
        self.start()

    def run(self):
        self.response = self.request()

    def answer(self, timeout=20):
        self.join(timeout)
        if self.response is None:
            raise AssertionError('no answer within %g s' % timeout)
        return self.response


def under_way(origami, service, **fields):
    """Makes a request, and waits until the node is at work on it: it refuses a second one then.
    Whichever of the two comes first is the one at work."""
    requests = [Waiting(origami, service, **fields) for _ in range(2)]
    refused = wait_until(lambda: [request for request in requests if request.response is not None],
                         'one of two requests is refused: ' + service)
    if len(refused) > 1 or refused[0].response.success:
        raise AssertionError('the node refuses no second request: %s' % refused[0].response)
    requests.remove(refused[0])
    return requests[0]


class LongRequestsTest(NodeTest):
    def setUp(self):
        super(LongRequestsTest, self).setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.origami.do('load', path=self.paper(SMALL))

    def paper(self, max_edge):
        return self.written('paper_%g.yaml' % max_edge, RECIPE % max_edge)

    def written(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, 'w') as file:
            file.write(text)
        return path

    def check_answers(self, requests, waiting):
        """Each request, five times, is answered at once while another waits for its answer."""
        times = {}
        for service, fields in 5 * requests:
            start = time.time()
            self.origami.do(service, **fields)
            times.setdefault(service, []).append(time.time() - start)
            self.assertTrue(waiting.is_alive(), waiting.response)
        for service, taken in sorted(times.items()):
            print('%s: %s ms' % (service, [round(1e3 * t, 1) for t in taken]))
            self.assertLess(sorted(taken)[2], PROMPT, service)
            self.assertLess(max(taken), SLOWEST, service)

    def check_pause_ends(self, waiting, words):
        start = time.time()
        self.origami.do('pause')
        answer = waiting.answer()
        self.assertLess(time.time() - start, SLOWEST)
        self.assertFalse(answer.success)
        self.assertNotRegex(answer.message, r':\s*$', 'a reason stands behind the colon')
        for word in words + ['~pause']:
            self.assertIn(word, answer.message)

    def test_answers_while_many_steps_are_taken_and_pause_ends_them(self):
        name = self.fold_slowly()
        before = self.origami.state().step
        waiting = Waiting(self.origami, 'step', steps=100000)
        self.origami.states.wait(lambda state: state.step > before)
        self.check_answers([('pin', dict(vertices=[0])), ('unpin', dict()),
                            ('fold', dict(crease=name, angle=1.0, duration=5000)),
                            ('save', dict(path=os.path.join(self.folder, 'paper.obj')))], waiting)
        for service in ('step', 'settle'):
            fields = dict(steps=1) if service == 'step' else {}
            refused = self.origami.call(service, **fields)
            self.assertFalse(refused.success)
            self.assertIn('100000 steps', refused.message)
        self.check_pause_ends(waiting, ['stopped after'])
        step = self.origami.state().step
        self.assertGreater(step, before + 10)
        self.origami.do('step', steps=3)
        self.assertEqual(self.origami.state().step, step + 3)

    def fold_slowly(self):
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.9, duration=5000)
        return self.origami.sheet().creases[0].name

    def test_many_points_are_found_at_once(self):
        points = [Point(SIDE * (i % 317) / 317, SIDE * (i % 313) / 313, 0) for i in range(100000)]
        start = time.time()
        pinned = self.origami.do('pin', points=points).vertices
        self.assertLess(time.time() - start, 3)
        self.assertEqual(len(pinned), len(self.origami.state().positions))

    def test_resume_ends_many_steps(self):
        self.fold_slowly()
        before = self.origami.state().step
        waiting = Waiting(self.origami, 'step', steps=100000)
        self.origami.states.wait(lambda state: state.step > before)
        self.origami.do('resume')
        self.assertIn('~resume', waiting.answer().message)

    def begin_to_settle(self):
        self.origami.do('load', path=self.paper(LARGE))
        self.origami.do('pin', vertices=[0])
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=2.9, duration=0.001)
        self.origami.do('step', steps=1)
        # All of the paper is heard: to read its large messages would keep this test from its requests.
        edits = self.origami.state().edits
        self.origami.sheet()
        self.origami.edits.wait(lambda edit: edit.number == edits)
        return under_way(self.origami, 'settle')

    def test_answers_while_paper_settles_and_pause_ends_it(self):
        waiting = self.begin_to_settle()
        before = self.origami.states.all()[-1]
        self.check_answers([('save', dict(path=os.path.join(self.folder, 'paper.obj')))], waiting)
        self.check_pause_ends(waiting, [])
        after = self.origami.state()
        self.assertEqual((after.step, after.positions), (before.step, before.positions))

    def test_settle_starts_over_from_what_was_pinned_meanwhile(self):
        """Paper that is held everywhere is at rest as it is: to settle it takes no time."""
        waiting = self.begin_to_settle()
        before = self.origami.states.all()[-1]
        self.check_answers([('pin', dict(vertices=[0]))], waiting)
        edit = self.origami.do('pin', region=ALL).edit
        answer = waiting.answer()
        self.assertTrue(answer.success, answer.message)
        state = self.origami.state()
        self.assertEqual(state.edits, edit + 1, 'it has settled after the pins')
        self.assertTrue(state.settled)
        self.assertEqual(state.positions, before.positions)

    def begin_to_load(self):
        return under_way(self.origami, 'load', path=self.paper(HUGE))

    def test_answers_while_a_large_file_is_read_and_pause_ends_it(self):
        before = self.origami.state()
        waiting = self.begin_to_load()
        self.check_answers([('pin', dict(vertices=[0])), ('unpin', dict()),
                            ('step', dict(steps=1))], waiting)
        refused = self.origami.call('load', path=self.paper(SMALL))
        self.assertFalse(refused.success)
        self.assertIn(os.path.basename(self.paper(HUGE)), refused.message)
        self.check_pause_ends(waiting, [])
        self.assertEqual(self.origami.state().revision, before.revision)


if __name__ == '__main__':
    rospy.init_node('long_requests_test')
    rostest.rosrun('shell_origami', 'long_requests_test', LongRequestsTest)
