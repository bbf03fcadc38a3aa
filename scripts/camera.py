"""The position of rviz's orbit camera."""
import math


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


class Orbit:
    """Looks from yaw and pitch at a focal point that is `distance` away, z upwards."""

    def __init__(self, yaw, pitch, field_of_view):
        cy, sy, cp, sp = math.cos(yaw), math.sin(yaw), math.cos(pitch), math.sin(pitch)
        self.right = (-sy, cy, 0)
        self.up = (-sp * cy, -sp * sy, cp)
        self.back = (cp * cy, cp * sy, sp)
        self.yaw, self.pitch = yaw, pitch
        self.slope = math.tan(field_of_view / 2)
        self.focal, self.distance = (0, 0, 0), 1

    def hold(self, points, aspect, part):
        """Moves the camera as close as possible with every point in view: centered, within this part
        of the picture, whose width over height is `aspect`."""
        across, upwards = part * self.slope * aspect, part * self.slope
        # A point (x, y, z) along right, up, back is in view from (fx, fy, d) where
        # |x - fx| <= (d - z) across: so that fx / across is at most d - z - x / across, and so on.
        left = right = low = high = near = -math.inf
        far = math.inf
        for point in points:
            x, y, z = dot(point, self.right), dot(point, self.up), dot(point, self.back)
            right, left = max(right, z + x / across), max(left, z - x / across)
            high, low = max(high, z + y / upwards), max(low, z - y / upwards)
            near, far = max(near, z), min(far, z)
        middle = (near + far) / 2
        self.focal = self.at(across * (right - left) / 2, upwards * (high - low) / 2, middle)
        self.distance = max(right + left, high + low) / 2 - middle

    def at(self, x, y, z):
        """Returns the point with these coordinates along right, up and back."""
        return tuple(x * r + y * u + z * b for r, u, b in zip(self.right, self.up, self.back))
