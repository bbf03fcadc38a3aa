#!/usr/bin/python3
"""From a bag alone a run is simulated again, to the bit; a bag that tells of another is found out."""

import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile

import dynamic_reconfigure.client
import rosbag
import roslib.packages
import rospy
import rostest

from moving_frame import MovingFrame
from origami_client import NodeTest, line

TOPICS = ['/origami/sheet', '/origami/state', '/origami/edits']
SIDE = 0.15


def resimulate(bag):
    return subprocess.run(['rosrun', 'shell_origami', 'resimulate', bag], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)


class ResimulateTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(ResimulateTest, cls).setUpClass()
        cls.hand = MovingFrame('hand')

    def setUp(self):
        super(ResimulateTest, self).setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.bag = os.path.join(self.folder, 'run.bag')

    def start_recording(self):
        # Not by the command rosbag: on Debian 11 it does not pass the signal to stop on.
        program = roslib.packages.find_node('rosbag', 'record')[0]
        self.recorder = subprocess.Popen([program, '-O', self.bag] + TOPICS)
        self.origami.wait_for_listener('/record', TOPICS)

    def stop_recording(self):
        self.origami.state()  # the last that is recorded
        self.recorder.send_signal(signal.SIGINT)
        self.assertEqual(self.recorder.wait(10), 0)

    def copy(self, change):
        """The bag with each message as `change` gives it; None is left out."""
        path = os.path.join(self.folder, 'copy.bag')
        with rosbag.Bag(self.bag) as bag, rosbag.Bag(path, 'w') as copy:
            for topic, message, time in bag:
                message = change(topic, message)
                if message is not None:
                    copy.write(topic, message, time)
        return path

    def record_everything(self):
        # The recording begins in the middle of a fold.
        self.origami.do('resume')
        self.origami.do('fold', line=line(0.05, 0, 0.05, SIDE), angle=1.0, duration=1.5)
        self.start_recording()
        self.origami.do('pin', vertices=[0])
        self.origami.do('pin', vertices=[2], frame_id='hand')
        self.hand.go((0, 0, 0.03, 0.2), 0.5)
        live = dynamic_reconfigure.client.Client('/origami/live', timeout=10)
        live.update_configuration({'gravity_z': -3.0})
        self.origami.do('fold', line=line(0.10, 0, 0.09, SIDE), angle=-0.7, duration=0.4)
        self.origami.pass_steps(20)
        self.origami.do('pause')
        self.origami.do('step', steps=20)
        self.origami.do('settle')
        self.origami.do('add_vertex', edge=self.a_border_edge(), fraction=0.3)
        self.origami.do('step', steps=5)
        self.origami.do('undo', edits=2)
        self.origami.do('step', steps=5)
        self.origami.do('unpin')
        live.update_configuration({'gravity_z': 0.0})
        self.origami.do('reset')
        self.origami.do('fold', vertices=[1, 3], angle=0.5, duration=0.2)
        self.origami.do('resume')
        self.origami.pass_steps(30)
        self.stop_recording()

    def a_border_edge(self):
        flat = self.origami.sheet().flat_positions
        along = sorted((p.x, i) for i, p in enumerate(flat) if p.y == 0)
        return [along[0][1], along[1][1]]

    def test_everything_is_done_again_to_the_bit(self):
        self.record_everything()
        with rosbag.Bag(self.bag) as bag:
            kinds = {m.kind for _, m, _ in bag.read_messages(['/origami/edits'])}
            states = sum(1 for _ in bag.read_messages(['/origami/state']))
        self.assertEqual(kinds, {'paper', 'pin', 'carry', 'configure', 'fold', 'settle',
                                 'add_vertex', 'undo', 'unpin', 'reset'})
        answer = resimulate(self.bag)
        self.assertEqual(answer.returncode, 0, answer.stdout)
        self.assertIn('the same to the bit', answer.stdout)
        done = re.search(r'(\d+) states over', answer.stdout)
        # But for those that came before the whole paper.
        self.assertGreater(int(done.group(1)), states - 10, answer.stdout)
        self.assertGreater(states, 40)  # 25 of ~step, the others at the publishing rate

        def push(topic, message):
            if topic == '/origami/state' and message.step == last:
                message.positions[5].z += 1e-5
            return message
        last = max(m.step for _, m, _ in rosbag.Bag(self.bag).read_messages(['/origami/state']))
        answer = resimulate(self.copy(push))
        self.assertEqual(answer.returncode, 1, answer.stdout)
        self.assertRegex(answer.stdout, r'differ, from .* by (1e-05|9\.9\d+e-06|1\.0\d+e-05) m')

        answer = resimulate(self.copy(lambda topic, m: None if topic == '/origami/edits' and
                                      m.kind == 'settle' else m))
        self.assertEqual(answer.returncode, 2, answer.stdout)
        self.assertIn('missing', answer.stdout)

        def stretch(topic, message):
            if topic == '/origami/edits' and message.kind == 'pin':
                message.vertices = [100000]
            return message
        answer = resimulate(self.copy(stretch))
        self.assertEqual(answer.returncode, 2, answer.stdout)
        self.assertIn('vertex 100000', answer.stdout)

        def cut(topic, message):
            if topic == '/origami/edits':
                message.paper = message.paper[:len(message.paper) // 2]
            return message
        answer = resimulate(self.copy(cut))
        self.assertEqual(answer.returncode, 2, answer.stdout)
        self.assertIn('holds no paper', answer.stdout)

    def load_square(self, max_edge):
        recipe = os.path.join(self.folder, 'square.yaml')
        with open(recipe, 'w') as file:
            file.write('sheet: {size: [0.15, 0.15], max_edge: %g}\nsteps: []\n' % max_edge)
        self.origami.do('load', path=recipe)

    def bag_at_rest(self, name, paper, state, count):
        """So many states of paper that rests."""
        path = os.path.join(self.folder, name)
        with rosbag.Bag(path, 'w') as bag:
            bag.write('/origami/edits', paper, rospy.Time(0, 1))
            for i in range(count):
                state.step = paper.step + i
                bag.write('/origami/state', state, rospy.Time(1 + i // 30, i % 30 * 33000000))
        return path

    def test_a_long_bag_takes_no_more_memory_than_a_short_one(self):
        self.load_square(0.0025)
        self.addCleanup(self.load_square, 0.02)
        paper = self.origami.last_edit('load')
        state = self.origami.state()
        self.assertGreater(len(state.positions), 4000)
        counts, peaks = (20, 2500), []
        for count in counts:
            answer = resimulate(self.bag_at_rest('rest%d.bag' % count, paper, state, count))
            self.assertEqual(answer.returncode, 0, answer.stdout)
            self.assertIn('%d states over' % count, answer.stdout)
            # The largest of all so far [kB].
            peaks.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e3)
        size = os.path.getsize(os.path.join(self.folder, 'rest2500.bag')) / 1e6
        rospy.loginfo('peaks of %d and %d states: %s MB; the bag: %d MB', *counts, peaks, size)
        self.assertGreater(size, 100)
        self.assertLess(peaks[1] - peaks[0], 0.2 * size)

    def test_a_state_that_is_not_finite_differs(self):
        self.origami.do('resume')
        self.start_recording()
        self.origami.pass_steps(30)
        self.stop_recording()

        def spoil(topic, message):
            if topic == '/origami/state':
                message.positions[5].z = float('nan')
            return message
        answer = resimulate(self.copy(spoil))
        self.assertEqual(answer.returncode, 1, answer.stdout)
        self.assertIn('by inf m', answer.stdout)

    def test_what_is_no_recording_is_refused_with_a_sentence(self):
        other = os.path.join(self.folder, 'other.bag')
        with rosbag.Bag(other, 'w'):
            pass
        text = os.path.join(self.folder, 'text.bag')
        with open(text, 'w') as file:
            file.write('no bag')
        for path, words in ((other, 'holds no whole paper'), (text, text),
                            ('/nowhere/run.bag', '/nowhere/run.bag'), (self.folder, self.folder)):
            answer = resimulate(path)
            self.assertEqual(answer.returncode, 2, answer.stdout)
            self.assertIn(words, answer.stdout)


if __name__ == '__main__':
    rospy.init_node('resimulate_test')
    rostest.rosrun('shell_origami', 'resimulate_test', ResimulateTest)
