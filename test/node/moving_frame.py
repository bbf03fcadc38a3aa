"""A TF frame that a test moves."""

import math
import time

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped

from origami_client import repeat


class MovingFrame(object):
    """world -> name, sent again and again, stamped with the present."""

    def __init__(self, name, period=0.1):
        self.name = name
        self.pose = (0, 0, 0, 0)
        self.silent = False
        self.broadcaster = tf2_ros.TransformBroadcaster()
        repeat(self._send_unless_silent, period)

    def _send_unless_silent(self):
        if not self.silent:
            self.send()

    def send(self):
        x, y, z, yaw = self.pose
        transform = TransformStamped()
        transform.header.stamp = rospy.Time.now()
        transform.header.frame_id = 'world'
        transform.child_frame_id = self.name
        transform.transform.translation.x = x
        transform.transform.translation.y = y
        transform.transform.translation.z = z
        transform.transform.rotation.z = math.sin(yaw / 2)
        transform.transform.rotation.w = math.cos(yaw / 2)
        self.broadcaster.sendTransform(transform)

    def go(self, end, duration):
        """Moves straight to a pose (x, y, z, yaw) within so many seconds of wall time."""
        start, begin = self.pose, time.time()
        s = 0
        while s < 1:
            s = min(1, (time.time() - begin) / duration)
            self.pose = tuple((1 - s) * a + s * b for a, b in zip(start, end))
            time.sleep(0.01)
