"""Panels of folded paper as a viewer sees them: their outlines, which covers which, and lines on them."""
import collections
import math

from diagram_paper import OPEN, cross2, sub

# Of the paper's size on the page: by what an outline may leave the straight line between its corners, and
# what is so small that it does not count.
STRAIGHT, TINY = 0.008, 1e-6
# Paper that shows this part of its area, all layers taken together, is folded flat: its layers are fanned.
FLAT = 0.97
# Layers below more than so many are fanned no further.
MOST_LAYERS = 5
# Part of the smaller of two panels by which they overlap where one lies on the other.
OVERLAP = 0.02


def clipped(polygon, triangle):
    """Returns the part of a convex polygon inside a counter-clockwise triangle (Sutherland-Hodgman)."""
    for a, b in zip(triangle, triangle[1:] + triangle[:1]):
        sides = [cross2(sub(b, a), sub(p, a)) for p in polygon]
        part = []
        for k, p in enumerate(polygon):
            side, before = sides[k], sides[k - 1]
            if (side > 0) != (before > 0):
                q, t = polygon[k - 1], before / (before - side)
                part.append((q[0] + t * (p[0] - q[0]), q[1] + t * (p[1] - q[1])))
            if side > 0:
                part.append(p)
        polygon = part
        if len(polygon) < 3:
            return []
    return polygon


def area_of(polygon):
    return sum(cross2(a, b) for a, b in zip(polygon, polygon[1:] + polygon[:1])) / 2


def simplified(points, tolerance):
    """Returns the indices of the points that a polyline keeps (Douglas-Peucker)."""
    first, last = points[0], points[-1]
    length = math.dist(first, last)
    worst, at = tolerance, None
    for k in range(1, len(points) - 1):
        way = sub(points[k], first)
        off = abs(cross2(sub(last, first), way)) / length if length > 0 else math.hypot(*way)
        if off > worst:
            worst, at = off, k
    if at is None:
        return [0, len(points) - 1]
    return simplified(points[:at + 1], tolerance)[:-1] + [at + k for k in simplified(points[at:], tolerance)]


class Outline:
    """A closed line around a panel: its corners (vertices of the paper), and of each side from a corner on
    whether it is border (B), a folded edge (E) or where the paper turns out of view (S)."""

    def __init__(self, corners, kinds):
        self.corners, self.kinds = corners, kinds


class Layers:
    """The panels of a paper in a view."""

    def __init__(self, paper, view):
        self.paper, self.view = paper, view
        seen = [view.flatten(point) for point in paper.points]
        self.points = [point[:2] for point in seen]
        self.heights = [point[2] for point in seen]
        box = [(min(axis), max(axis)) for axis in zip(*self.points)]
        self.extent = max(high - low for low, high in box)
        self.areas = [area_of([self.points[v] for v in face]) for face in paper.faces]
        self.is_flat = sum(map(abs, self.areas)) > FLAT * sum(
            area_of([paper.flat[v] for v in face]) for face in paper.faces)
        self.shows_front = [area > 0 for area in self.areas]
        self.panel = paper.panels(lambda a, b: self.shows_front[a] == self.shows_front[b])
        self.faces = collections.defaultdict(list)
        for face, panel in enumerate(self.panel):
            self.faces[panel].append(face)
        self.outlines = {panel: self.outlines_of(panel) for panel in self.faces}
        self.find_order()
        self.offsets = self.find_offsets()

    def front_shows(self, panel):
        return self.shows_front[self.faces[panel][0]]

    def triangle(self, face):
        """Returns the corners of a face on the page, counter-clockwise."""
        corners = [self.points[v] for v in self.paper.faces[face]]
        return corners if self.shows_front[face] else corners[::-1]

    # Outlines

    def border_of(self, panel):
        """Returns the sides of a panel: the next vertex, what the side is and what lies beyond."""
        sides = collections.defaultdict(list)
        for face in self.faces[panel]:
            corners = self.paper.faces[face]
            for a, b in zip(corners, corners[1:] + corners[:1]):
                other = self.paper.face_at.get((b, a))
                beyond = None if other is None else self.panel[other]
                if beyond == panel:
                    continue
                folded = abs(self.paper.creases.get((min(a, b), max(a, b)), 0)) > OPEN
                sides[a].append((b, "B" if other is None else "E" if folded else "S", beyond))
        return sides

    def outlines_of(self, panel):
        sides, outlines = self.border_of(panel), []
        while sides:
            start = next(iter(sides))
            loop, here = [], start
            while here in sides:
                to, kind, beyond = sides[here].pop()
                if not sides[here]:
                    del sides[here]
                loop.append((here, kind, beyond))
                here = to
            outlines.append(self.outline(loop))
        return outlines

    def outline(self, loop):
        """Returns the outline with the corners only. It turns, or another panel begins, at a corner."""
        hard = [k for k in range(len(loop)) if loop[k][1:] != loop[k - 1][1:]] or [0]
        loop = loop[hard[0]:] + loop[:hard[0]]
        hard = [k - hard[0] for k in hard] + [len(loop)]
        loop.append(loop[0])
        if len(hard) == 2:  # one kind all around: no line has its two ends at one place
            points = [self.points[v] for v, _, _ in loop]
            hard.insert(1, max(range(len(points)), key=lambda k: math.dist(points[0], points[k])))
        corners, kinds = [], []
        for first, last in zip(hard, hard[1:]):
            points = [self.points[v] for v, _, _ in loop[first:last + 1]]
            for k in simplified(points, STRAIGHT * self.extent)[:-1]:
                corners.append(loop[first + k][0])
                kinds.append(loop[first + k][1])
        return Outline(corners, kinds)

    # Order

    def near_pairs(self):
        """Returns the pairs of faces of two panels whose boxes on the page overlap."""
        boxes = []
        for face in range(len(self.paper.faces)):
            xs, ys = zip(*self.triangle(face))
            boxes.append((min(xs), min(ys), max(xs), max(ys)))
        cell = 1.5 * sum(box[2] - box[0] for box in boxes) / len(boxes) + TINY * self.extent
        grid, pairs = collections.defaultdict(list), set()
        for face, box in enumerate(boxes):
            for i in range(int(box[0] // cell), int(box[2] // cell) + 1):
                for j in range(int(box[1] // cell), int(box[3] // cell) + 1):
                    for other in grid[i, j]:
                        at = boxes[other]
                        if self.panel[other] != self.panel[face] and box[0] < at[2] and at[0] < box[2] and \
                                box[1] < at[3] and at[1] < box[3]:
                            pairs.add((other, face))
                    grid[i, j].append(face)
        return sorted(pairs)

    def height_at(self, face, point):
        """Returns the height of a face's plane over a point of the page."""
        a, b, c = self.paper.faces[face]
        u, v = sub(self.points[b], self.points[a]), sub(self.points[c], self.points[a])
        way, area = sub(point, self.points[a]), 2 * self.areas[face]
        x, y = cross2(way, v) / area, cross2(u, way) / area
        height = self.heights[a]
        return height + x * (self.heights[b] - height) + y * (self.heights[c] - height)

    def find_order(self):
        """Finds the panels from behind to the front (`order`) and those that lie on each (`above`)."""
        least = (TINY ** 0.5 * self.extent) ** 2
        common, votes = collections.Counter(), collections.Counter()
        for first, second in self.near_pairs():
            if min(abs(self.areas[first]), abs(self.areas[second])) < least:
                continue  # on edge
            polygon = clipped(self.triangle(first), self.triangle(second))
            area = area_of(polygon) if polygon else 0
            if area < least:
                continue
            middle = tuple(sum(axis) / len(axis) for axis in zip(*polygon))
            pair = (self.panel[first], self.panel[second])
            higher = area if self.height_at(first, middle) > self.height_at(second, middle) else -area
            if pair[0] > pair[1]:
                pair, higher = pair[::-1], -higher
            common[pair] += area
            votes[pair] += higher
        size = {panel: sum(abs(self.areas[face]) for face in faces) for panel, faces in self.faces.items()}
        self.above = {panel: set() for panel in self.faces}
        covers = []
        for pair, area in common.items():
            upper, lower = pair if votes[pair] > 0 else pair[::-1]
            covers.append((abs(votes[pair]), upper, lower))
            if area > OVERLAP * min(size[upper], size[lower]):
                self.above[lower].add(upper)
        self.order = self.sorted_panels(covers)

    def sorted_panels(self, covers):
        """Returns the panels so that each comes after those that it covers. Of panels that cover each other
        in a circle, the one that covers least comes first."""
        left, order = set(self.faces), []
        while left:
            hidden = {panel: 0 for panel in left}  # what each covers of those that are left
            for weight, upper, lower in covers:
                if upper in left and lower in left:
                    hidden[upper] += weight
            last = min(sorted(left), key=hidden.get)
            order.append(last)
            left.remove(last)
        return order

    # Fan

    def find_offsets(self):
        """Returns by how many layers each vertex is moved on the page: where panels are joined, both as far
        as the upper one, so that the panels on top lie as they are."""
        rank = {panel: 0 for panel in self.faces}
        for panel in reversed(self.order):
            on_top = [rank[upper] for upper in self.above[panel]]
            rank[panel] = min(MOST_LAYERS, 1 + max(on_top)) if on_top and self.is_flat else 0
        panels_at = collections.defaultdict(set)
        for face, corners in enumerate(self.paper.faces):
            for v in corners:
                panels_at[v].add(self.panel[face])
        return {v: min(rank[panel] for panel in panels) for v, panels in panels_at.items()}

    def fan_direction(self):
        """Returns the direction in which most border of lower layers comes into view."""
        best = (0, (0, 0))
        for turn in range(8):
            way = math.cos(math.pi / 4 * turn - math.pi / 4), math.sin(math.pi / 4 * turn - math.pi / 4)
            shown = 0
            for panel, outlines in self.outlines.items():
                side = 1 if self.front_shows(panel) else -1
                for outline in outlines:
                    corners = outline.corners
                    for k, kind in enumerate(outline.kinds):
                        a, b = corners[k], corners[(k + 1) % len(corners)]
                        along = sub(self.points[b], self.points[a])
                        if kind == "B":
                            out = side * cross2(way, along)  # the outline runs counter-clockwise
                            shown += max(0, out) * min(1, self.offsets[a] + self.offsets[b])
            best = max(best, (round(shown / self.extent, 6), way), key=lambda pair: pair[0])
        return best[1]

    def offset_at(self, panel, point):
        """Returns by how many layers a point of a panel is moved on the page."""
        near, weights, total = STRAIGHT * self.extent, 0, 0
        for outline in self.outlines[panel]:
            for a, b in zip(outline.corners, outline.corners[1:] + outline.corners[:1]):
                p, q = self.points[a], self.points[b]
                way = sub(q, p)
                length = math.hypot(*way)
                if length == 0:
                    continue
                part = min(1, max(0, ((point[0] - p[0]) * way[0] + (point[1] - p[1]) * way[1]) / length ** 2))
                away = math.dist(point, (p[0] + part * way[0], p[1] + part * way[1]))
                here = (1 - part) * self.offsets[a] + part * self.offsets[b]
                if away < near:
                    return here
                weights += length / away ** 2
                total += here * length / away ** 2
        return total / weights if weights else 0

    # Lines on panels

    def on_page(self, flat):
        """Returns where a point of the flat sheet is on the page."""
        return self.view.flatten(self.paper.at(flat))[:2]

    def is_visible(self, flat):
        """Returns whether no layer covers a point of the flat sheet."""
        face, weights = self.paper.locate(flat)
        corners = self.paper.faces[face]
        point = tuple(sum(w * self.points[v][k] for w, v in zip(weights, corners)) for k in (0, 1))
        height = sum(w * self.heights[v] for w, v in zip(weights, corners))
        for other, triangle in enumerate(self.paper.faces):
            if self.panel[other] == self.panel[face] or abs(self.areas[other]) < (TINY * self.extent) ** 2:
                continue
            corners = self.triangle(other)
            sides = zip(corners, corners[1:] + corners[:1])
            if all(cross2(sub(b, a), sub(point, a)) >= 0 for a, b in sides) and \
                    self.height_at(other, point) > height:
                return False
        return True
