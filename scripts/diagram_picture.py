"""One picture of a diagram: folded paper, the lines to be creased and an arrow, as SVG elements."""
import collections
import math
from xml.sax.saxutils import escape

from diagram_layers import simplified
from diagram_paper import OPEN, add, cross2, dot, scaled, sub, unit

FRONT, BACK, INK = "#fbd9a6", "#ffffff", "#333333"  # rviz's front is orange as well
# Yoshizawa and Randlett's lines.
DASHES = {"valley": "1.8 0.9", "mountain": "2.6 0.7 0.4 0.7 0.4 0.7", "hidden": "0.3 0.7"}
COLORS = {"valley": "#1b4f9c", "mountain": "#b3202c"}
# On the page [mm].
FAN = 0.65                   # of one layer
CREASE_GAP = 1.2             # between a crease that is there and the edge of its panel
LINE, THIN = 0.35, 0.18
HEAD = 2.6                   # of an arrow
LEAST_ARROW = 6
# Names of points within this part of the paper stand above to the right, others outside.
INSIDE = 0.8
# A crease that is folded further is where the paper ends for the viewer; one that is less than it was, by
# more than this, is opened again [deg].
SHUT, OPENED = 120, 5
# Part of the sheet's size by which a line is looked for to its sides.
ASIDE = 0.01


def number(value):
    return ("%.2f" % value).rstrip("0").rstrip(".")


def path_of(points, closed=False):
    return "M" + " L".join("%s %s" % (number(x), number(y)) for x, y in points) + (" Z" if closed else "")


def element(kind, path, fill="none", stroke=INK, width=LINE, dashes=None):
    dashed = ' stroke-dasharray="%s"' % dashes if dashes else ""
    return ('<path class="%s" d="%s" fill="%s" stroke="%s" stroke-width="%s"%s stroke-linejoin="round" '
            'stroke-linecap="round"/>' % (kind, path, fill, stroke, width, dashed))


def text_element(x, y, text, size=3, anchor="middle", color=INK, weight="normal"):
    return ('<text x="%s" y="%s" font-family="DejaVu Sans, sans-serif" font-size="%s" text-anchor="%s" '
            'fill="%s" font-weight="%s">%s</text>' % (number(x), number(y), size, anchor, color, weight,
                                                     escape(text)))


class Placement:
    """Where the points of a view are on the page [mm]; y runs down there."""

    def __init__(self, points, width, height, scale):
        xs, ys = zip(*points)
        self.scale = scale
        self.center = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        self.middle = width / 2, height / 2

    def __call__(self, point):
        return (self.middle[0] + self.scale * (point[0] - self.center[0]),
                self.middle[1] - self.scale * (point[1] - self.center[1]))


class Picture:
    """A paper on the page."""

    def __init__(self, layers, placement):
        self.layers, self.place = layers, placement
        way = layers.fan_direction()
        self.fan = (FAN * way[0], -FAN * way[1])
        self.elements = []

    def vertex(self, v):
        return add(self.place(self.layers.points[v]), self.fan, self.layers.offsets[v])

    def at(self, flat):
        """Returns where a point of the flat sheet is on the page."""
        panel = self.layers.panel[self.layers.paper.locate(flat)[0]]
        return self.on_panel(panel, self.layers.on_page(flat))

    def on_panel(self, panel, point):
        return add(self.place(point), self.fan, self.layers.offset_at(panel, point))

    def draw_paper(self):
        """Draws the panels from behind to the front, each with the creases that are there."""
        creases = self.open_creases()
        for panel in self.layers.order:
            outlines = [[self.vertex(v) for v in outline.corners] for outline in self.layers.outlines[panel]]
            side = "front" if self.layers.front_shows(panel) else "back"
            fill = FRONT if side == "front" else BACK
            self.elements.append(element(side, " ".join(path_of(points, True) for points in outlines), fill))
            self.elements += [element("crease", path_of(points), width=THIN) for points in creases[panel]]

    def draw_lines(self, lines):
        """Draws the lines to be creased, over the edges of layers that end there."""
        for kind, panel, points in lines:
            points = [self.on_panel(panel, point) for point in points]
            if kind != "hidden":
                fill = FRONT if self.layers.front_shows(panel) else BACK
                # Not over the edges in which the line ends.
                ground = [add(points[0], scaled(unit(sub(points[1], points[0])), 2 * LINE)), *points[1:-1],
                          add(points[-1], scaled(unit(sub(points[-2], points[-1])), 2 * LINE))]
                self.elements.append(element("ground", path_of(ground), stroke=fill, width=2 * LINE))
            self.elements.append(element(kind, path_of(points), stroke=COLORS.get(kind, INK),
                                         dashes=DASHES[kind]))

    def open_creases(self):
        """Returns the creases that are there and hardly folded, by panels. They end before the edge."""
        paper, segments = self.layers.paper, collections.defaultdict(list)
        for (a, b), angle in paper.creases.items():
            if abs(angle) <= OPEN:
                face = paper.face_at.get((a, b), paper.face_at.get((b, a)))
                segments[self.layers.panel[face]].append((a, b))
        lines = collections.defaultdict(list)
        for panel, edges in segments.items():
            for chain in chains(edges):
                points = [self.layers.points[v] for v in chain]
                kept = simplified(points, 0.01 * self.layers.extent)
                for first, last in zip(kept, kept[1:]):
                    p, q = self.on_panel(panel, points[first]), self.on_panel(panel, points[last])
                    if math.dist(p, q) > 3 * CREASE_GAP:
                        gap = scaled(unit(sub(q, p)), CREASE_GAP)
                        lines[panel].append([add(p, gap), sub(q, gap)])
        return lines

    # Signs

    def draw_arrow(self, start, end, behind):
        """Draws a curved arrow between two points of the page, with a hollow head where it goes behind."""
        way = sub(end, start)
        length = math.hypot(*way)
        if length < LEAST_ARROW:
            return
        bulge = scaled((way[1] / length, -way[0] / length), 0.28 * length)
        middle = scaled(add(start, end), 0.5)
        # Away from the middle of the paper, or upwards.
        outwards = dot(bulge, sub(middle, self.place.middle)) or -bulge[1]
        control = add(middle, bulge, 1 if outwards >= 0 else -1)
        tip = sub(end, scaled(unit(sub(end, control)), 0.8))
        along = unit(sub(tip, control))
        neck = sub(tip, scaled(along, HEAD))
        side = scaled((-along[1], along[0]), 0.38 * HEAD)
        kind = "arrow behind" if behind else "arrow"
        self.elements.append(element(kind, "M%s %s Q%s %s %s %s" % tuple(map(number, start + control + neck)),
                                     width=0.45))
        self.elements.append(element("head behind" if behind else "head",
                                     path_of([tip, add(neck, side), sub(neck, side)], True),
                                     fill=BACK if behind else INK))

    def draw_marks(self, marks):
        """Draws the landmarks, pairs of a name and a point of the page, with their names outside."""
        taken = []
        for name, point in marks:
            self.elements.append(
                '<circle class="mark" cx="%s" cy="%s" r="0.8" fill="%s" stroke="%s" stroke-width="%s"/>' %
                (number(point[0]), number(point[1]), BACK, INK, LINE))
            out = sub(point, self.place.middle)
            inside = max(map(abs, scaled(out, 2 / self.layers.extent / self.place.scale))) < INSIDE
            out = (0.7, -0.7) if inside else unit(out)
            anchor = "middle" if abs(out[0]) < 0.4 else "start" if out[0] > 0 else "end"
            x, y = point[0] + 2 * out[0], point[1] + 3.2 * out[1] + 0.9
            while any(abs(y - other[1]) < 2.8 and abs(x - other[0]) < 14 for other in taken):
                y += 2.9 if out[1] > 0 else -2.9
            taken.append((x, y))
            self.elements.append(text_element(x, y, name, 2.6, anchor))

    def draw_turn_over(self, x, y):
        """Draws the sign for turning over: an arrow with a loop."""
        path = "M%s %s c4 3.5 8.5 2 7.5 -1.2 c-0.8 -2.4 -4.2 -1.6 -3.4 0.8 c0.8 2.4 4.6 2.6 7 0.6" % (
            number(x), number(y))
        tip = x + 12.8, y - 1.3
        self.elements.append(element("turn-over", path, width=0.45))
        head = [tip, (tip[0] - 0.6, tip[1] + 2.5), (tip[0] - 2.6, tip[1])]
        self.elements.append(element("head", path_of(head, True), fill=INK))


def chains(edges):
    """Returns polylines of vertices that run through edges, each of which is in one."""
    at = collections.defaultdict(set)
    for a, b in edges:
        at[a].add(b)
        at[b].add(a)
    lines = []
    for ends_only in (True, False):  # closed lines have no end
        for start in sorted(at):
            while at[start] and (len(at[start]) != 2 or not ends_only):
                line = [start]
                while at[line[-1]]:
                    here = line[-1]
                    to = at[here].pop()
                    at[to].discard(here)
                    line.append(to)
                    if len(at[to]) != 1:  # an end, or others meet there
                        break
                lines.append(line)
    return lines


def lines_to_crease(layers, after):
    """Returns the lines that the step to the paper `after` creases in the visible layer, as kind, panel
    and points: valley or mountain, as the viewer sees them. Where none is visible, those that are hidden."""
    before, edges = layers.paper, collections.defaultdict(list)
    for a, b in sorted(after.new):
        middle = scaled(add(after.flat[a], after.flat[b]), 0.5)
        folded, asked = before.angle_at(middle), after.creases[a, b]
        if abs(folded) > SHUT or abs(asked) + OPENED < abs(folded):
            continue  # an edge of the folded paper, or a crease that is opened again
        # A layer may end along the line.
        way = sub(after.flat[b], after.flat[a])
        aside = scaled(unit((-way[1], way[0])), ASIDE * before.size)
        visible = any(layers.is_visible(add(middle, aside, side)) for side in (0, -1, 1))
        panel = layers.panel[before.locate(middle)[0]]
        toward = (asked > folded) == layers.front_shows(panel)
        kind = "valley" if toward else "mountain"
        edges[kind if visible else "hidden", panel].append((a, b))
    lines = []
    for (kind, panel), segments in edges.items():
        for chain in chains(segments):
            points = [layers.on_page(after.flat[v]) for v in chain]
            lines.append((kind, panel, [points[k] for k in simplified(points, 0.01 * layers.extent)]))
    visible = [line for line in lines if line[0] != "hidden"]
    return visible or lines


class Move:
    """How the step from one paper to the next moves points, on the page of the view before it."""

    def __init__(self, before, view, after, later_view):
        self.before, self.view, self.after, self.later_view = before, view, after, later_view
        self.origin = view.flatten(before.at(later_view.viewpoint))
        fronts = [dot(paper.normal(paper.locate(later_view.viewpoint)[0]), eye.viewer) > 0
                  for paper, eye in ((before, view), (after, later_view))]
        self.mirrored = fronts[0] != fronts[1]  # the paper is turned over after the step

    def start(self, flat):
        return self.view.flatten(self.before.at(flat))

    def end(self, flat):
        x, y, height = self.later_view.flatten(self.after.at(flat))
        return add(self.origin, (-x, y, -height) if self.mirrored else (x, y, height))

    def farthest(self, layers):
        """Returns the corner of a panel that moves farthest on the page."""
        outlines = [outline for panel in layers.outlines.values() for outline in panel]
        corners = {v for outline in outlines for v in outline.corners}
        flats = [self.before.flat[v] for v in sorted(corners)]
        return max(flats, key=lambda flat: round(math.dist(self.start(flat)[:2], self.end(flat)[:2]), 6))
