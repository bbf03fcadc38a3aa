#!/usr/bin/python3
"""A run that rosbag recorded is drawn exactly as it was live."""

import os
import shutil
import signal
import subprocess
import tempfile

import rosbag
import roslib.packages
import rospy
import rostest
from visualization_msgs.msg import MarkerArray

from origami_client import NodeTest, Origami, Recorder, line

TOPICS = ['/origami/sheet', '/origami/state', '/origami/edits', '/tf', '/tf_static']


def stop(process):
    process.send_signal(signal.SIGINT)
    process.wait(10)


class ReplayTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()
        cls.folder = tempfile.mkdtemp()
        cls.bag = os.path.join(cls.folder, 'run.bag')

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def record(self):
        """Two folds, the first before the recording starts, and the markers drawn meanwhile."""
        live = Recorder('/origami/markers', MarkerArray)
        self.origami.do('resume')
        self.origami.do('fold', line=line(0.05, 0, 0.05, 0.15), angle=1.0, duration=0.5)
        # Not by the command rosbag: on Debian 11 it does not pass the signal to stop on.
        program = roslib.packages.find_node('rosbag', 'record')[0]
        recording = subprocess.Popen([program, '-O', self.bag] + TOPICS)
        self.origami.wait_for_listener('/record', [t for t in TOPICS if t.startswith('/origami')])
        self.origami.states.wait(lambda state: state.creases and state.settled)
        self.origami.do('fold', line=line(0.10, 0, 0.10, 0.15), angle=-1.0, duration=0.5)
        self.origami.do('pin', vertices=[0])
        self.origami.pass_steps(90)
        self.origami.state()
        stop(recording)
        return {m.markers[0].header.stamp: m for m in live.all()}

    def replay(self):
        """What is drawn of the recording, to its pin."""
        program = roslib.packages.find_node('shell_origami', 'origami_markers')[0]
        drawn = Recorder('/replayed/markers', MarkerArray)
        rospy.set_param('/painter', {'origami': 'replayed',
                                   'colouring': rospy.get_param('/origami/colouring')})
        painter = subprocess.Popen([program, '__name:=painter'])
        player = subprocess.Popen(
            ['rosbag', 'play', '--quiet', '--rate', '2', '--delay', '1', self.bag] +
            [topic + ':=/replayed' + topic.replace('/origami', '') for topic in TOPICS])
        self.assertEqual(player.wait(20), 0)
        drawn.wait(lambda m: any(n.ns == 'pins' and n.action == n.ADD for n in m.markers))
        stop(painter)
        return drawn.all()

    def test_replay_looks_like_the_live_run(self):
        live = self.record()
        with rosbag.Bag(self.bag) as bag:
            edits = [m.kind for _, m, _ in bag.read_messages(['/origami/edits'])]
            sheets = [m for _, m, _ in bag.read_messages(['/origami/sheet'])]
            states = [m for _, m, _ in bag.read_messages(['/origami/state'])]
        self.assertEqual(edits, ['paper', 'fold', 'pin'])
        self.assertEqual(len(sheets), 2)
        self.assertGreater(len(states), 30)

        # Paper at rest is drawn a few times only, and not always at the same times.
        replayed = {m.markers[0].header.stamp: m for m in self.replay()}
        both = set(live) & set(replayed)
        self.assertGreater(len(both), 15)
        for stamp in both:
            self.assertEqual(replayed[stamp], live[stamp])  # in every field


if __name__ == '__main__':
    rospy.init_node('replay_test')
    rostest.rosrun('shell_origami', 'replay_test', ReplayTest)
