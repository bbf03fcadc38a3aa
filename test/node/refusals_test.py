#!/usr/bin/python3
"""A refused request says why in one sentence, which names the value, and changes nothing."""

import math
import os
import tempfile

import rospy
import rostest
from geometry_msgs.msg import Point, Point32, PointStamped, Polygon

from origami_client import NodeTest, line

NAN = float('nan')
INF = float('inf')
DIAGONAL = line(0, 0, 0.15, 0.15)
CORNERS = [Point32(0, 0, 0), Point32(0.05, 0, 0), Point32(0.05, 0.05, 0)]


def ball(frame, x=0.0, y=0.0, z=0.0):
    center = PointStamped()
    center.header.frame_id = frame
    center.point = Point(x, y, z)
    return center


def temporary(name, text):
    path = os.path.join(tempfile.mkdtemp(), name)
    with open(path, 'w') as written:
        written.write(text)
    return path


def pipe(name):
    """One that nobody writes into."""
    path = os.path.join(tempfile.mkdtemp(), name)
    os.mkfifo(path)
    return path


# Service, request, and words that the answer must hold.
REFUSALS = [
    ('fold', dict(angle=1), ['crease', 'vertices', 'line', 'none']),
    ('fold', dict(crease='spine', line=DIAGONAL, angle=1), ['crease and line']),
    ('fold', dict(vertices=[0, 1], line=DIAGONAL, angle=1), ['vertices and line']),
    ('fold', dict(crease='nose', angle=1), ['nose']),
    ('fold', dict(vertices=[3], angle=1), ['vertices', '1']),
    ('fold', dict(vertices=[0, 1, 2], angle=1), ['vertices', '3']),
    ('fold', dict(vertices=[0, 4000000000], angle=1), ['4000000000']),
    ('fold', dict(vertices=[7, 7], angle=1), ['7']),
    ('fold', dict(line=DIAGONAL[:1], angle=1), ['line', '1']),
    ('fold', dict(line=DIAGONAL + DIAGONAL, angle=1), ['line', '4']),
    ('fold', dict(line=line(NAN, 0, 0.15, 0.15), angle=1), ['line[0]', 'nan']),
    ('fold', dict(line=[Point(0, 0, 0), Point(0.15, 0.15, INF)], angle=1), ['line[1]', 'inf']),
    ('fold', dict(line=[Point(0, 0, 0), Point(0.15, 0.15, 0.03)], angle=1), ['line[1]', '0.03', 'flat']),
    ('fold', dict(line=line(0, 0, 0.2, 0.15), angle=1), ['0.2']),
    ('fold', dict(line=line(0.05, 0.05, 0.05, 0.05), angle=1), ['0.05']),
    ('fold', dict(line=DIAGONAL, angle=math.pi), ['angle', '3.14']),
    ('fold', dict(line=DIAGONAL, angle=-4), ['angle', '-4']),
    ('fold', dict(line=DIAGONAL, angle=NAN), ['angle', 'nan']),
    ('fold', dict(line=DIAGONAL, angle=1, duration=-1), ['duration', '-1']),
    ('fold', dict(line=DIAGONAL, angle=1, duration=NAN), ['duration', 'nan']),
    ('fold', dict(line=DIAGONAL, angle=1, duration=INF), ['duration', 'inf']),
    ('fold', dict(line=DIAGONAL, angle=1, stiffness=-0.1), ['stiffness', '-0.1']),
    ('fold', dict(line=DIAGONAL, angle=1, stiffness=INF), ['stiffness', 'inf']),
    ('fold', dict(line=DIAGONAL, angle=1, stiffness=1e-320), ['stiffness', 'e-321', '1e-9']),
    ('pin', dict(), ['vertices', 'points', 'region', 'center', 'none']),
    ('pin', dict(vertices=[0], points=[Point(0, 0, 0)]), ['vertices and points']),
    ('pin', dict(points=[Point(0, 0, 0)], center=ball(''), radius=0.1),
     ['points and center']),
    ('pin', dict(vertices=[0, 123456]), ['123456']),
    ('pin', dict(points=[Point(0, INF, 0)]), ['points[0]', 'inf']),
    ('pin', dict(region=Polygon(CORNERS[:2])), ['region', '2']),
    ('pin', dict(region=Polygon(CORNERS[:2] + [Point32(NAN, 0, 0)])), ['region[2]', 'nan']),
    ('pin', dict(center=ball('world', 0.1), radius=0), ['radius', '0']),
    ('pin', dict(center=ball(''), radius=-0.1), ['radius', '-0.1']),
    ('pin', dict(center=ball(''), radius=NAN), ['radius', 'nan']),
    ('pin', dict(center=ball('', NAN), radius=0.1), ['center', 'nan']),
    ('pin', dict(center=ball('nowhere'), radius=0.1), ['nowhere']),
    ('pin', dict(center=ball('', 5), radius=0.1), ['no vertex']),
    ('pin', dict(vertices=[0], frame_id='gripper'), ['gripper']),
    ('unpin', dict(vertices=[3]), ['3']),
    ('unpin', dict(vertices=[999999]), ['999999']),
    ('add_vertex', dict(edge=[0, 999999], fraction=0.5), ['999999']),
    ('add_vertex', dict(edge=[0, 0], fraction=0.5), ['0']),
    ('add_vertex', dict(edge=[0, 1], fraction=0), ['fraction', '0']),
    ('add_vertex', dict(edge=[0, 1], fraction=1), ['fraction', '1']),
    ('add_vertex', dict(edge=[0, 1], fraction=NAN), ['fraction', 'nan']),
    ('load', dict(path=''), ['path']),
    ('load', dict(path='/nowhere/paper.fold'), ['/nowhere/paper.fold']),
    ('load', dict(path='/nowhere/recipe.yaml'), ['/nowhere/recipe.yaml']),
    ('load', dict(path='/tmp'), ['/tmp']),
    ('load', dict(path='nowhere/paper.fold'), ['nowhere/paper.fold', os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))]),
    ('load', dict(path='/tmp/paper.fold', scale=-1), ['scale', '-1']),
    ('load', dict(path='/tmp/paper.fold', scale=NAN), ['scale', 'nan']),
    ('load', dict(path=temporary('scaled.yaml', 'sheet: {size: [0.1, 0.1]}'), scale=0.1),
     ['scale', '0.1', 'scaled.yaml']),
    ('load', dict(path='/dev/zero'), ['/dev/zero', 'not a regular file']),
    ('load', dict(path=pipe('paper.fold')), ['paper.fold', 'not a regular file']),
    ('load', dict(path=pipe('recipe.yaml')), ['recipe.yaml', 'not a regular file']),
    ('load', dict(path='x' * 100000 + '\n.yaml'), ['xx...xx', 'x .yaml: cannot be read: there is no such file']),
    ('load', dict(path=temporary('cut.fold', '{"vertices_coords": [[0, 0')), ['cut.fold']),
    ('load', dict(path=temporary('typo.yaml', 'sheet: {siez: [1, 1]}\nsteps: []\n')),
     ['typo.yaml', 'siez']),
    ('save', dict(path=''), ['path']),
    ('save', dict(path='/tmp/paper.doc'), ['.doc']),
    ('save', dict(path='/nowhere/paper.obj'), ['/nowhere/paper.obj']),
    ('step', dict(steps=0), ['0']),
    ('step', dict(steps=4000000000), ['4000000000', '100000']),
]


class RefusalsTest(NodeTest):
    def test_each(self):
        before = self.origami.state()
        edits = len(self.origami.edits.all())
        wrong = []
        for service, request, words in REFUSALS:
            response = self.origami.call(service, **request)
            if (response.success or '\n' in response.message or
                    not all(word in response.message for word in words)):
                wrong.append('%s %s: %s' % (service, request, response.message))
        self.assertEqual(wrong, [])
        after = self.origami.state()
        self.assertEqual(after.revision, before.revision)
        self.assertEqual(after.positions, before.positions)
        self.assertEqual(after.creases, before.creases)
        self.assertEqual(after.pinned, before.pinned)
        self.assertEqual(len(self.origami.edits.all()), edits)

    def test_step_needs_a_pause(self):
        self.origami.do('resume')
        response = self.origami.call('step', steps=1)
        self.assertFalse(response.success)
        self.assertIn('paused', response.message)


if __name__ == '__main__':
    rospy.init_node('refusals_test')
    rostest.rosrun('shell_origami', 'refusals_test', RefusalsTest)
