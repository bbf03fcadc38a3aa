#!/usr/bin/python3
"""~cloud and the images of ~depth/... agree with ~state, ~sheet, /tf and the obstacles."""

import math
import time

import numpy as np
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import Point, PoseStamped, TransformStamped
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField
from shape_msgs.msg import Plane, SolidPrimitive

from origami_client import NodeTest, Origami, Recorder, line, repeat

SIDE = 0.15
FIELDS = ['x', 'y', 'z', 'normal_x', 'normal_y', 'normal_z', 'u', 'v', 'side']
# ~state, ~cloud and the images are rounded to float32: half of its step below 0.5 m, in each of three
# coordinates of two points.
ROUNDING = 6 ** 0.5 * 2 ** -26


def rows(points):
    return np.array([(p.x, p.y, p.z) for p in points])


def matrix(transform):
    """The rotation and the translation."""
    q, p = transform.transform.rotation, transform.transform.translation
    x, y, z, w = q.x, q.y, q.z, q.w
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]), \
        np.array([p.x, p.y, p.z])


class Paper(object):
    """A sheet and a state of it, to look up where a flat point is."""

    def __init__(self, origami):
        sheet, state = origami.sheet(), origami.state()
        self.stamp = state.header.stamp
        self.flat, self.positions = rows(sheet.flat_positions)[:, :2], rows(state.positions)
        self.triangles = np.array([t.vertex_indices for t in sheet.triangles])

    def weights(self, flat, triangle):
        a, b, c = self.flat[self.triangles[triangle]]
        second, third = np.linalg.solve(np.column_stack([b - a, c - a]), (flat - a).T)
        return np.column_stack([1 - second - third, second, third])

    def place(self, flat):
        """Where flat points (a row each) are in space, and the normals of the front there."""
        places, normals = np.full((2, len(flat), 3), np.nan)
        for t, corners in enumerate(self.triangles):
            low, high = self.flat[corners].min(0), self.flat[corners].max(0)
            near = np.nonzero(((flat > low - 1e-6) & (flat < high + 1e-6)).all(1))[0]
            weights = self.weights(flat[near], t)
            inside = weights.min(1) > -1e-5  # float32 rounds the flat points
            p = self.positions[corners]
            places[near[inside]] = weights[inside] @ p
            normal = np.cross(p[1] - p[0], p[2] - p[0])
            normals[near[inside]] = normal / np.linalg.norm(normal)
        return places, normals


class Eye(object):
    """The camera's frame, sent again and again like a robot's, and what it sees."""

    def __init__(self):
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer)
        self.moves = False
        repeat(self.send, 0.1)

    def send(self):
        """Above the middle of the sheet it looks down, or swings to and fro about that and turns."""
        now = rospy.Time.now()
        angle = 0.5 * math.sin(3 * now.to_sec()) if self.moves else 0
        transform = TransformStamped()
        transform.header.stamp, transform.header.frame_id, transform.child_frame_id = now, 'world', 'eye'
        place, turn = transform.transform.translation, transform.transform.rotation
        place.x, place.y, place.z = SIDE / 2, SIDE / 2 + 0.3 * math.sin(angle), 0.3 * math.cos(angle)
        turn.x, turn.w = math.cos(angle / 2), math.sin(angle / 2)  # half a turn about x, less the angle
        self.broadcaster.sendTransform(transform)

    def pose(self, stamp):
        return matrix(self.buffer.lookup_transform('world', 'eye', stamp, rospy.Duration(5)))


def cloud_of(message):
    return np.frombuffer(message.data, np.float32).reshape(-1, 9).astype(float)


def image_of(message):
    channels = {'32FC1': 1, '32FC3': 3}[message.encoding]
    assert message.step == 4 * channels * message.width and not message.is_bigendian
    return np.frombuffer(message.data, np.float32).reshape(message.height, message.width, channels).astype(float)


def rays(info):
    """Of each pixel, at depth 1."""
    focal, column, row = info.K[0], info.K[2], info.K[5]
    columns, rows_ = np.meshgrid(np.arange(info.width), np.arange(info.height))
    return np.dstack([(columns - column) / focal, (rows_ - row) / focal, np.ones(columns.shape)])


class SenseTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()
        cls.eye = Eye()

    def setUp(self):
        super(SenseTest, self).setUp()
        self.eye.moves = False

    def fold(self):
        """The right part comes over the left one and shows its back to a camera above."""
        self.origami.do('pin', points=[Point(0, 0, 0), Point(0, SIDE, 0), Point(0.03, SIDE / 2, 0)])
        self.origami.do('fold', line=line(0.1, 0, 0.06, SIDE), angle=2.5, duration=0.3)
        self.origami.do('step', steps=60)

    def cloud(self, stamp):
        heard = Recorder('/origami/cloud', PointCloud2)
        message = heard.wait(lambda m: m.header.stamp >= stamp)
        heard.subscriber.unregister()
        return message

    def images(self, stamp):
        """Those of one time: depths, labels, camera_info."""
        kinds = (('image', Image), ('label', Image), ('camera_info', CameraInfo))
        heard = [Recorder('/origami/depth/' + name, kind) for name, kind in kinds]
        # From when on all of them are heard.
        begun = max([stamp] + [recorder.wait().header.stamp for recorder in heard])
        label = heard[1].wait(lambda m: m.header.stamp >= begun)
        found = [recorder.wait(lambda m: m.header.stamp == label.header.stamp) for recorder in heard]
        for recorder in heard:
            recorder.subscriber.unregister()
        return found

    def test_a_cloud_of_flat_paper(self):
        message = self.cloud(self.origami.state().header.stamp)
        self.assertEqual(message.header.frame_id, 'world')
        self.assertEqual([(f.name, f.offset, f.datatype, f.count) for f in message.fields],
                         [(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate(FIELDS)])
        cloud = cloud_of(message)
        self.assertEqual(len(cloud), 20000)
        front, back = np.split(cloud, 2)
        # A lattice of 1.5 mm.
        lattice = (np.arange(100) + 0.5) * 0.0015
        np.testing.assert_allclose(front[:, 6], np.tile(lattice, 100), atol=1e-8)
        np.testing.assert_allclose(front[:, 7], np.repeat(lattice, 100), atol=1e-8)
        np.testing.assert_array_equal(front[:, 6:8], back[:, 6:8])
        for side, points in enumerate((front, back)):
            np.testing.assert_allclose(points[:, :2], points[:, 6:8], atol=ROUNDING)
            np.testing.assert_allclose(points[:, 2:6], np.tile([0, 0, 0, 1 - 2 * side], (10000, 1)), atol=1e-7)
            self.assertTrue((points[:, 8] == side).all())

    def test_points_are_carried_by_the_paper(self):
        before = cloud_of(self.cloud(self.origami.state().header.stamp))
        self.fold()
        paper = Paper(self.origami)
        after = cloud_of(self.cloud(paper.stamp))
        np.testing.assert_array_equal(after[:, 6:], before[:, 6:])
        places, normals = paper.place(after[:, 6:8])
        self.assertLess(np.abs(after[:, :3] - places).max(), ROUNDING)
        # Those of a triangle with edges of a centimeter, whose corners float32 rounds.
        outwards = np.where(after[:, 8:] == 0, normals, -normals)
        alike = np.einsum('ij,ij->i', after[:, 3:6], outwards)
        self.assertGreater(np.quantile(alike, 0.999), 1 - 1e-6)  # a crease's own points have two normals
        self.assertLess(after[:10000, 5].min(), -0.7)  # turned by 2.5 rad, or nearly so
        self.assertGreater(after[:, 2].max(), 0.02)

    def compare_with_paper(self, paper, image, label, info):
        """The point that each pixel sees, by its depth, is where its label is on the paper."""
        depth, (turn, center) = image_of(image)[:, :, 0], self.eye.pose(image.header.stamp)
        labels, seen = image_of(label), np.isfinite(depth)
        self.assertGreater(seen.sum(), 20000)
        self.assertTrue(np.isnan(depth[~seen]).all())
        np.testing.assert_array_equal(np.isfinite(labels).all(2), seen)
        seen.flat[np.arange(seen.size) % 5 != 0] = False  # the test alone is slow
        points = (depth[:, :, None] * rays(info))[seen] @ turn.T + center
        places, normals = paper.place(labels[seen][:, :2])
        # The pose in the node and here are the same numbers. A depth, its label and the paper itself
        # are rounded, that of the label moves the point along the paper.
        self.assertLess(np.linalg.norm(points - places, axis=1).max(), 2 * ROUNDING)
        towards = np.einsum('ij,ij->i', normals, center - points) > 0
        self.assertLess(np.mean(towards != (labels[seen][:, 2] == 0)), 1e-3)  # on creases there are two normals
        return labels[seen]

    def test_the_camera_sees_flat_paper(self):
        image, label, info = self.images(self.origami.state().header.stamp)
        self.assertEqual((image.encoding, label.encoding), ('32FC1', '32FC3'))
        for message in (image, label, info):
            self.assertEqual((message.width, message.height, message.header.frame_id), (640, 480, 'eye'))
        self.assertEqual(info.K, (525, 0, 319.5, 0, 525, 239.5, 0, 0, 1))
        depth = image_of(image)[:, :, 0]
        # 0.3 m above the middle of the sheet, 0.15 m are 262.5 pixels.
        paper = np.abs(rays(info)[:, :, :2]).max(2) < SIDE / 2 / 0.3
        np.testing.assert_array_equal(np.isfinite(depth), paper)
        self.assertEqual(paper.sum(), 262 ** 2)
        self.assertLess(np.abs(depth[paper] - 0.3).max(), 2 ** -26)
        labels = self.compare_with_paper(Paper(self.origami), image, label, info)
        self.assertTrue((labels[:, 2] == 0).all())

    def test_the_camera_sees_folded_paper(self):
        self.fold()
        paper = Paper(self.origami)
        labels = self.compare_with_paper(paper, *self.images(paper.stamp))
        self.assertGreater((labels[:, 2] == 1).sum(), 1000)
        self.assertGreater((labels[:, 2] == 0).sum(), 1000)

    def test_the_camera_sees_obstacles(self):
        """A table under the paper and a block on the table, partly under the paper."""
        gap = 5e-5  # contact/distance: obstacles are seen that far inside of their surfaces
        self.origami.do('add_obstacle', id='table', plane=Plane(coef=[0, 0, 1, 0.02]))
        block = SolidPrimitive(type=SolidPrimitive.BOX, dimensions=[0.04, 0.04, 0.01])
        pose = PoseStamped()
        pose.pose.position = Point(SIDE / 2, SIDE, -0.015)
        pose.pose.orientation.w = 1
        self.origami.do('add_obstacle', id='block', primitive=block, pose=pose)
        self.addCleanup(self.origami.do, 'remove_obstacle')
        self.origami.sheets.wait(lambda sheet: [o.id for o in sheet.obstacles] == ['block', 'table'])
        image, label, info = self.images(self.origami.state().header.stamp)
        depth, labels = image_of(image)[:, :, 0], image_of(label)
        x, y = SIDE / 2 + rays(info)[:, :, 0] * depth, SIDE / 2 - rays(info)[:, :, 1] * depth
        kinds = ((labels[:, :, 2] == 0, 0.3), (labels[:, :, 2] == 2, 0.31 + gap),
                 (labels[:, :, 2] == 3, 0.32 + gap))
        self.assertTrue((sum(seen.astype(int) for seen, _ in kinds) == 1).all())
        for seen, expected in kinds:
            self.assertGreater(seen.sum(), 1000)
            self.assertLess(np.abs(depth[seen] - expected).max(), 2 ** -25)
        on_block = np.maximum(np.abs(x - SIDE / 2), np.abs(y - SIDE)) < 0.02 - gap
        np.testing.assert_array_equal(kinds[1][0], on_block & (kinds[1][0] | kinds[2][0]))
        np.testing.assert_array_equal(np.isfinite(labels[:, :, :2]).all(2), kinds[0][0])

    def test_a_moving_camera_is_where_it_was_at_the_stamp(self):
        self.fold()
        self.eye.moves = True
        paper = Paper(self.origami)
        for _ in range(3):
            self.compare_with_paper(paper, *self.images(rospy.Time.now()))

    def test_images_come_at_their_rate(self):
        heard = Recorder('/origami/depth/camera_info', CameraInfo)
        for paused in (True, False):
            self.origami.do('pause' if paused else 'resume')
            stamps = [heard.wait(since=len(heard.all()) + 1).header.stamp]
            time.sleep(2)
            stamps = [m.header.stamp for m in heard.all() if m.header.stamp >= stamps[0]]
            rate = (len(stamps) - 1) / (stamps[-1] - stamps[0]).to_sec()
            # One more or one less in two seconds.
            self.assertAlmostEqual(rate, 10, delta=0.6)
            self.assertEqual(stamps, sorted(set(stamps)))

    def test_a_camera_that_is_nowhere_says_so(self):
        log = Recorder('/rosout', Log)
        images = Recorder('/blind/depth/image', Image)
        said = log.wait(lambda m: m.name == '/blind' and 'nowhere' in m.msg)
        self.assertIn('no depth image', said.msg)
        self.assertEqual(images.all(), [])


if __name__ == '__main__':
    rospy.init_node('sense_test')
    rostest.rosrun('shell_origami', 'sense_test', SenseTest)
