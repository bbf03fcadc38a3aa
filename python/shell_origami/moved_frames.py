"""TF frames that a program moves: grippers, fingers, tools. A pose is ((x, y, z), (x, y, z, w)), a place
[m] and a quaternion; a path is a function from 0 to 1 to a pose."""

import contextlib
import math

import rospy
import tf2_ros
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

RATE = 50  # [Hz] of the transforms
UNTURNED = (0, 0, 0, 1)


def about_y(angle):
    """Returns the quaternion of a turn around the y axis [rad]."""
    return 0, math.sin(angle / 2), 0, math.cos(angle / 2)


def turned(first, then):
    """Returns the quaternion of one turn after another, both in the same fixed axes."""
    x, y, z, w = then
    a, b, c, d = first
    return (w * a + x * d + y * c - z * b, w * b - x * c + y * d + z * a,
            w * c + x * b - y * a + z * d, w * d - x * a - y * b - z * c)


def straight(start, end, orientation=UNTURNED):
    """Returns a path from place to place."""
    return lambda s: (tuple((1 - s) * a + s * b for a, b in zip(start, end)), orientation)


def smooth(s):
    """Returns a smooth step from 0 to 1, as that of a fold."""
    return s * s * (3 - 2 * s)


class MovedFrames(object):
    """Frames that are sent continuously, each where it was moved last.

    world: the frame in which poses are
    poses: of each frame, by its name"""

    def __init__(self, world, poses):
        self.world = world
        self.motion = {frame: (lambda s, pose=pose: pose, rospy.Time.now(), 1.0)
                       for frame, pose in poses.items()}
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.timer = rospy.Timer(rospy.Duration(1.0 / RATE), self._send)

    def pose(self, frame):
        path, begin, duration = self.motion[frame]
        return path(smooth(min(1, max(0, (rospy.Time.now() - begin).to_sec() / duration))))

    def move(self, paths, duration):
        """Moves frames along paths, by their names, from path(0) to path(1); returns at the end."""
        begin = rospy.Time.now()
        self.motion.update({frame: (path, begin, duration) for frame, path in paths.items()})
        rospy.sleep(duration)

    def _send(self, _):
        now = rospy.Time.now()
        transforms = []
        for frame in list(self.motion):
            place, orientation = self.pose(frame)
            transform = TransformStamped(child_frame_id=frame)
            transform.header.stamp = now
            transform.header.frame_id = self.world
            transform.transform.translation = Vector3(*place)
            transform.transform.rotation = Quaternion(*orientation)
            transforms.append(transform)
        with contextlib.suppress(rospy.ROSException):  # the program is about to end
            self.broadcaster.sendTransform(transforms)


class Drawn(object):
    """What is seen of frames, on `~markers`: boxes that their frames carry along."""

    def __init__(self):
        self.publisher = rospy.Publisher('~markers', MarkerArray, queue_size=1, latch=True)

    def show(self, boxes):
        """boxes: of each frame, by its name, a list of (center, size) [m]"""
        self.publisher.publish([self._box(frame, number, *box) for frame, all_of_it in boxes.items()
                                for number, box in enumerate(all_of_it)])

    def vanish(self):
        self.publisher.publish([Marker(action=Marker.DELETEALL)])

    @staticmethod
    def _box(frame, number, center, size):
        marker = Marker(type=Marker.CUBE, ns=frame, id=number, frame_locked=True,
                        color=ColorRGBA(0.25, 0.3, 0.4, 1))
        marker.header.frame_id = frame
        marker.pose.position.x, marker.pose.position.y, marker.pose.position.z = center
        marker.pose.orientation.w = 1
        marker.scale = Vector3(*size)
        return marker
