"""The frames of a folding sequence (diagrams.fold), and from where each is looked at."""
import collections
import itertools
import json
import math

# A crease that is folded less than this is a line on a panel that goes on [deg].
OPEN = 15
FLAT_COORDINATES = "vertices_shell_origami:flat_coords"
SEEN_COORDINATES = "vertices_shell_origami:seen_coords"


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def add(a, b, part=1):
    return tuple(x + part * y for x, y in zip(a, b))


def scaled(a, factor):
    return tuple(factor * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def cross2(a, b):
    return a[0] * b[1] - a[1] * b[0]


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def distance_to_segment(p, a, b):
    way = sub(b, a)
    part = min(1, max(0, dot(sub(p, a), way) / dot(way, way)))
    return math.dist(p, add(a, way, part))


class Paper:
    """The paper of one frame."""

    def __init__(self, frame):
        self.space = [tuple(point) + (0,) * (3 - len(point)) for point in frame["vertices_coords"]]
        # As the viewer sees it, along z; or where nobody does, as it is.
        self.is_seen = SEEN_COORDINATES in frame
        self.points = [tuple(point) for point in frame[SEEN_COORDINATES]] if self.is_seen else self.space
        self.flat = [tuple(point) for point in frame[FLAT_COORDINATES]]
        self.faces = [tuple(face) for face in frame["faces_vertices"]]
        self.title = frame["frame_title"]
        self.step = frame["shell_origami:step"]  # of the recipe, from 1 on; 0: the start
        self.viewpoint = tuple(frame["shell_origami:viewpoint"])
        self.front = frame["shell_origami:front"]
        # Of each edge with a crease on it, by its vertices in ascending order [deg].
        self.creases, self.new = {}, set()
        for edge, kind, angle, new in zip(frame["edges_vertices"], frame["edges_assignment"],
                                          frame["edges_foldAngle"],
                                          frame["edges_shell_origami:new_creases"]):
            if kind in "MVU":
                self.creases[tuple(sorted(edge))] = angle
                if new:
                    self.new.add(tuple(sorted(edge)))
        self.size = max(max(axis) - min(axis) for axis in zip(*self.flat))
        self.face_at = {}  # left of each directed edge
        for number, (a, b, c) in enumerate(self.faces):
            self.face_at.update({(a, b): number, (b, c): number, (c, a): number})
        # Of each cell of a grid over the flat sheet the faces whose boxes reach into it.
        self.cell = self.size / max(1, math.sqrt(len(self.faces) / 2))
        self.faces_near = collections.defaultdict(list)
        for number, corners in enumerate(self.faces):
            (i, j), (k, l) = (self.cell_of([end(axis) for axis in zip(*(self.flat[v] for v in corners))])
                              for end in (min, max))
            for place in itertools.product(range(i, k + 1), range(j, l + 1)):
                self.faces_near[place].append(number)

    def cell_of(self, flat):
        return tuple(int(x // self.cell) for x in flat)

    def locate(self, flat):
        """Returns the face at a flat point, or the nearest, and the point's weights in its corners."""
        best = None
        for number in itertools.chain(self.faces_near[self.cell_of(flat)], range(len(self.faces))):
            a, b, c = (self.flat[v] for v in self.faces[number])
            area = cross2(sub(b, a), sub(c, a))
            weights = (cross2(sub(b, flat), sub(c, flat)) / area, cross2(sub(c, flat), sub(a, flat)) / area)
            weights += (1 - sum(weights),)
            if min(weights) > -1e-9:
                return number, weights
            if best is None or min(weights) > min(best[1]):
                best = number, weights
        return best

    def at(self, flat):
        """Returns where a point of the flat sheet is in space."""
        face, weights = self.locate(flat)
        return tuple(sum(w * self.points[v][k] for w, v in zip(weights, self.faces[face])) for k in range(3))

    def normal(self, face):
        """Returns the normal of a face's front, twice its area long."""
        a, b, c = (self.points[v] for v in self.faces[face])
        return cross(sub(b, a), sub(c, a))

    def to_space(self, face, direction):
        """Returns where a direction of the flat sheet points at a face."""
        a, b, c = self.faces[face]
        u, v = sub(self.flat[b], self.flat[a]), sub(self.flat[c], self.flat[a])
        area = cross2(u, v)
        x, y = cross2(direction, v) / area, cross2(u, direction) / area
        return add(scaled(sub(self.points[b], self.points[a]), x), sub(self.points[c], self.points[a]), y)

    def to_flat(self, face, direction):
        """Returns the direction of the flat sheet that points most in a direction of space there."""
        x, y = self.to_space(face, (1, 0)), self.to_space(face, (0, 1))
        return dot(x, direction), dot(y, direction)

    def angle_at(self, flat):
        """Returns the fold angle of the crease at a point of the flat sheet [deg]; 0: there is none."""
        corners = self.faces[self.locate(flat)[0]]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if distance_to_segment(flat, self.flat[a], self.flat[b]) < 1e-4 * self.size:
                return self.creases.get((min(a, b), max(a, b)), 0)
        return 0

    def panels(self, same=lambda a, b: True):
        """Returns of each face the number of its panel: faces that no folded crease parts, and of which
        each two neighbors are the same."""
        panel = [None] * len(self.faces)
        count = 0
        for start in range(len(self.faces)):
            if panel[start] is not None:
                continue
            panel[start], todo = count, [start]
            while todo:
                face = todo.pop()
                corners = self.faces[face]
                for a, b in zip(corners, corners[1:] + corners[:1]):
                    other = self.face_at.get((b, a))
                    if other is None or panel[other] is not None or not same(face, other) or \
                            abs(self.creases.get((min(a, b), max(a, b)), 0)) > OPEN:
                        continue
                    panel[other] = count
                    todo.append(other)
            count += 1
        return panel


class View:
    """A direction from which paper is looked at, and what is right and up then."""

    def __init__(self, viewer, up, origin=(0, 0, 0), viewpoint=None):
        self.viewer = unit(viewer)
        up = add(up, self.viewer, -dot(up, self.viewer))
        self.up = unit(up)
        self.right = cross(self.up, self.viewer)
        self.origin = origin
        self.viewpoint = viewpoint  # of the flat sheet, whose layer lies still on the page

    def flatten(self, point):
        """Returns x and y as the viewer sees them, and the height towards the viewer."""
        way = sub(point, self.origin)
        return dot(way, self.right), dot(way, self.up), dot(way, self.viewer)


def orbit_view(yaw, pitch):
    """Returns the view of rviz's orbit camera [rad]."""
    viewer = math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)
    return View(viewer, (0, 0, 1) if abs(math.cos(pitch)) > 0.01 else (1, 0, 0))


def largest_rest(before, viewpoint, after):
    """Returns the face of the later paper at which the viewer goes on to look: in the largest panel that
    its fold leaves of the panel that is looked at, and of equal ones in that nearest to the middle."""
    old, new = before.panels(), after.panels()
    looked_at = old[before.locate(viewpoint)[0]]
    middle = [sum(axis) / len(axis) for axis in zip(*after.flat)]
    areas, nearest = {}, {}
    for number, corners in enumerate(after.faces):
        a, b, c = (after.flat[v] for v in corners)
        center = scaled(add(add(a, b), c), 1 / 3)
        if old[before.locate(center)[0]] != looked_at:
            continue
        panel = new[number]
        areas[panel] = areas.get(panel, 0) + cross2(sub(b, a), sub(c, a))
        nearest[panel] = min(nearest.get(panel, (math.inf,)), (math.dist(center, middle), center))
    best = max(areas.values())
    return min(nearest[panel] for panel in areas if areas[panel] > 0.99 * best)[1]


def panel_normal(paper, viewpoint):
    panels = paper.panels()
    here = panels[paper.locate(viewpoint)[0]]
    total = (0, 0, 0)
    for face, panel in enumerate(panels):
        if panel == here:
            total = add(total, paper.normal(face))
    return total


def views_of(papers):
    """Returns the view of each paper. What the viewer sees lies still on the page as paper is folded, and
    is turned over from left to right."""
    # Plain folds name no layer that stays: the viewer keeps to the largest.
    plain = all(paper.title.split(",")[0] in ("start", "fold") for paper in papers)
    views, before = [], None
    for paper in papers:
        viewpoint = paper.viewpoint
        if plain and before:
            viewpoint = largest_rest(before, last_viewpoint, paper)
        if before is None:
            up = (0, 1)
        elif viewpoint != last_viewpoint:
            up = before.to_flat(before.locate(viewpoint)[0], views[-1].up)
        face = paper.locate(viewpoint)[0]
        viewer = (0, 0, 1)
        if plain or not paper.is_seen:
            viewer = scaled(panel_normal(paper, viewpoint), 1 if paper.front else -1)
        views.append(View(viewer, paper.to_space(face, up), paper.at(viewpoint), viewpoint))
        before, last_viewpoint = paper, viewpoint
    return views


def read_sequence(path):
    """Returns the papers of a diagrams.fold and the name of its recipe. Raises ValueError if it is none."""
    with open(path, encoding="utf-8") as file:
        document = json.load(file)
    frames = document.get("file_frames", [])
    if not frames or not all(FLAT_COORDINATES in frame for frame in frames):
        raise ValueError("%s is no folding sequence that origami_batch wrote" % path)
    return [Paper(frame) for frame in frames], document.get("file_title", "model")
