#!/usr/bin/python3
"""What scripts/film makes of a recorded run, but for rviz: which states it shows and for how long,
where the camera stands, and what it says of bags that it cannot film."""
import importlib.machinery
import importlib.util
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from geometry_msgs.msg import Point32

SCRIPTS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'scripts')
FILM = os.path.join(SCRIPTS, 'film')
sys.path.insert(0, SCRIPTS)

from camera import Orbit, dot
from recording import SHEET, STATE, Recording
from shell_origami.msg import Sheet, SheetState


def load_film():
    loader = importlib.machinery.SourceFileLoader('film', FILM)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader('film', loader))
    loader.exec_module(module)
    return module


class FilmTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.bag = os.path.join(folder.name, 'run.bag')
        self.film = os.path.join(folder.name, 'film.gif')

    def write(self, stamps, revision=1, topics=(SHEET, STATE)):
        """A run of one vertex that is, at each of these times, as high as its number."""
        with rosbag.Bag(self.bag, 'w') as bag:
            at = rospy.Time(1)
            if SHEET in topics:
                bag.write(SHEET, Sheet(revision=1, flat_positions=[Point32()]), at)
            for number, stamp in enumerate(stamps):
                state = SheetState(revision=revision, positions=[Point32(0, 0, number)])
                state.header.stamp = rospy.Time.from_sec(stamp)
                if STATE in topics:
                    bag.write(STATE, state, at)

    def frames(self, stamps, fps, speed=1):
        self.write(stamps)
        return [tuple(entry) for entry in Recording(self.bag).frames(fps, speed)]

    def test_every_frame_shows_the_paper_of_its_time(self):
        stamps = [5 + i / 30 for i in range(31)]
        self.assertEqual(self.frames(stamps, 30), [(i, 1) for i in range(31)])
        self.assertEqual(self.frames(stamps, 15), [(2 * i, 1) for i in range(16)])
        self.assertEqual(self.frames(stamps, 15, speed=2),
                         [(4 * i, 1) for i in range(8)] + [(30, 1)])

    def test_paper_that_rests_is_one_long_frame(self):
        self.assertEqual(self.frames([0, 0.1, 2.1, 2.2], 10), [(0, 1), (1, 20), (2, 1), (3, 1)])

    def test_time_goes_on_where_stamps_go_back(self):
        self.assertEqual(self.frames([7, 7.1, 3, 3.1], 10), [(0, 1), (2, 1), (3, 1)])

    def test_frames_do_not_drift_off(self):
        delays = load_film().delays([1] * 30, 15)
        self.assertEqual(sum(delays), 200)
        self.assertLessEqual(set(delays), {6, 7})
        self.assertEqual(load_film().delays([3, 1], 10), [30, 10])

    def test_the_camera_holds_everything_and_no_more(self):
        random.seed(1)
        for _ in range(50):
            orbit = Orbit(random.uniform(0, 6), random.uniform(-1.5, 1.5), 0.8)
            middle = [random.uniform(-5, 5) for _ in range(3)]
            points = [[m + random.gauss(0, 0.1) for m in middle] for _ in range(40)]
            orbit.hold(points, 4 / 3, 0.9)
            seen = []
            for point in points:
                offset = [p - f for p, f in zip(point, orbit.focal)]
                depth = orbit.distance - dot(offset, orbit.back)
                self.assertGreater(depth, 0)
                seen.append((dot(offset, orbit.right) / depth / orbit.slope / (4 / 3),
                             dot(offset, orbit.up) / depth / orbit.slope))
            sides = [max(x for x, _ in seen), -min(x for x, _ in seen),
                     max(y for _, y in seen), -min(y for _, y in seen)]
            self.assertAlmostEqual(max(sides), 0.9, delta=1e-9)
            tight = sides[:2] if max(sides[:2]) > max(sides[2:]) else sides[2:]
            self.assertAlmostEqual(tight[0], tight[1], delta=1e-9)

    def refused(self, words, *options):
        process = subprocess.run([FILM, self.film] + list(options), stderr=subprocess.PIPE,
                                 universal_newlines=True,
                                 env=dict(os.environ, ROS_MASTER_URI='http://127.0.0.1:1'))
        self.assertEqual(process.returncode, 1)
        self.assertEqual(process.stderr.count('\n'), 1, process.stderr)
        for word in words:
            self.assertIn(word, process.stderr)
        self.assertFalse(os.path.exists(self.film))

    def test_what_cannot_be_filmed_is_said_in_one_sentence(self):
        self.refused(['there is no bag', self.bag], '--bag', self.bag)
        self.refused(['cannot read', FILM], '--bag', FILM)
        self.write([], topics=[SHEET])
        self.refused(['/origami/state'], '--bag', self.bag)
        self.write([0], topics=[STATE])
        self.refused(['/origami/sheet'], '--bag', self.bag)
        self.write([0], revision=2)
        self.refused(['no state', self.bag], '--bag', self.bag)
        self.write([0])
        with open(self.bag, 'rb+') as file:
            file.truncate(os.path.getsize(self.bag) // 2)
        self.refused([self.bag], '--bag', self.bag)
        self.refused(['no ROS master', '127.0.0.1:1'], '--live', '1')

    def test_a_paper_that_is_nowhere_is_refused(self):
        with rosbag.Bag(self.bag, 'w') as bag:
            bag.write(SHEET, Sheet(revision=1, flat_positions=[Point32()]))
            bag.write(STATE, SheetState(revision=1, positions=[Point32(math.nan, 0, 0)]))
        self.refused(['nowhere'], '--bag', self.bag)


if __name__ == '__main__':
    unittest.main()
