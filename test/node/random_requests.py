"""Requests that make sense, and requests of which every field is anything."""

import os
import random

from dynamic_reconfigure.msg import BoolParameter, Config, DoubleParameter, IntParameter, StrParameter
from geometry_msgs.msg import Point, Point32, PointStamped, Polygon, Vector3
import rospy

from shell_origami.msg import FoldRecipeGoal, Landmark

NUMBERS = [float('nan'), float('inf'), -float('inf'), 0.0, -0.0, 5e-324, -1e-300, 1e308, -1e308,
           -1.0, 3.141592653589793, 1e-9, 0.05, 1e5, -1e5]
TEXTS = ['', ' ', '/', '.', '..', '~', 'world', 'paper', 'panel_0', '9 lives', '_', 'all', 'fold_0',
         '%s%n%d', '\n', 'a\0b', '\u00e4\u6298\U0001f9a2', '../' * 50, '/dev/zero', '/dev/null',
         '/dev/stdin', '/proc/self/mem', '/tmp', 'x' * 100000, '"; rm', '{x: [', '\x1b[31m']
IDS = [0, 1, 5, 1000, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1]
HUGE = 100000
MOST_VERTICES = 300  # a paper with more creases than that takes its time
SERVICES = ['fold', 'fold_through', 'layers', 'turn_over', 'pin', 'unpin', 'add_vertex', 'load', 'save',
            'step', 'undo', 'settle', 'reset']
WEIGHTS = [25, 8, 3, 3, 8, 8, 6, 1, 3, 40, 3, 4, 1]
AXIOMS = {'bring': 2, 'edges': 4, 'across': 4, 'through': 3}
RECIPE = ('names: {tip: [0, 0]}\nsteps:\n  - pin: {points: [[0, 0]]}\n'
          '  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: 60, name: middle}]\n'
          '    duration: 0.3\n  - settle: {timeout: 1}\n  - unpin: all\n')


class RandomRequests(object):
    """Of one seed. Paths that could be written lie in `folder`; `papers` can be loaded."""

    def __init__(self, seed, folder, papers):
        self.random = random.Random(seed)
        self.folder = folder
        self.papers = papers

    # What makes no sense, mostly.

    def number(self):
        r = self.random
        return r.choice([r.choice(NUMBERS), r.uniform(-1, 1), r.uniform(-0.01, 0.16)])

    def short_number(self):
        """One that fits into a float32."""
        return max(-3e38, min(3e38, self.number()))

    def text(self):
        r = self.random
        letters = ''.join(chr(r.choice([r.randrange(32, 127), r.randrange(1, 0xd000)]))
                          for _ in range(r.randrange(20)))
        return r.choice([r.choice(TEXTS), letters])

    def path(self):
        """Nothing but `folder` is written to."""
        r = self.random
        path = self.text()
        if not path.startswith('/dev/') and not path.startswith('/proc/'):
            path = os.path.join(self.folder, path.lstrip('/.').replace('..', ''))
        return path + r.choice(['', '', '.fold', '.obj', '.stl', '.ply', '.yaml'])

    def count(self):
        r = self.random
        return HUGE if r.random() < 0.02 else r.choice([0, 0, 1, 1, 2, 2, 3, 7])

    def ids(self):
        r = self.random
        return [r.choice([r.choice(IDS), r.randrange(60)]) for _ in range(self.count())]

    def point(self):
        return Point(self.number(), self.number(), self.random.choice([0, 0, self.number()]))

    def points(self):
        return [self.point() for _ in range(self.count())]

    def polygon(self):
        return Polygon([Point32(self.short_number(), self.short_number(), 0)
                        for _ in range(self.count())])

    def stamped(self):
        stamped = PointStamped(point=self.point())
        stamped.header.frame_id = self.text()
        stamped.header.stamp = rospy.Time(self.random.choice([0, 1, 2 ** 32 - 1]), 0)
        return stamped

    def landmark(self):
        """Mostly one that makes sense but for its numbers."""
        r = self.random
        return r.choice([lambda: Landmark(flat=self.point()), lambda: Landmark(space=self.stamped()),
                         lambda: Landmark(name=r.choice(['tip', self.text()])),
                         lambda: Landmark(name=self.text(), flat=self.point(), space=self.stamped())])()

    def wild_fields(self, service):
        """Each field is left open as often as not."""
        r = self.random
        fields = {
            'fold': lambda: dict(crease=self.text(), vertices=self.ids(), line=self.points(),
                                 angle=self.number(), duration=self.number(),
                                 stiffness=self.number()),
            'fold_through': lambda: dict(
                axiom=r.choice(sorted(AXIOMS) + [self.text()]),
                points=[self.landmark() for _ in range(r.choice([2, 3, 4, self.count()]))],
                layers=r.choice(['all', 'top', 'flap', self.text()]), count=r.choice(IDS),
                flap=self.landmark(), way=r.choice(['front', 'behind', self.text()]),
                viewer=Vector3(self.number(), self.number(), self.number()), angle=self.number(),
                duration=self.number(), dry_run=r.random() < 0.5),
            'layers': lambda: dict(point=self.landmark(),
                                   viewer=Vector3(self.number(), self.number(), self.number())),
            'pin': lambda: dict(vertices=self.ids(), points=self.points(), region=self.polygon(),
                                center=self.stamped(), radius=self.number(),
                                frame_id=self.text()),
            'unpin': lambda: dict(vertices=self.ids()),
            'add_vertex': lambda: dict(edge=[r.choice(IDS), r.choice(IDS)], fraction=self.number()),
            'load': lambda: dict(path=self.path()),
            'save': lambda: dict(path=self.path()),
            'step': lambda: dict(steps=r.choice([0, 100001, 2 ** 32 - 1])),
            'undo': lambda: dict(edits=r.choice([1000, 2 ** 32 - 1])),
        }.get(service, dict)()
        return {name: value for name, value in fields.items() if r.random() < 0.5}

    # What makes sense, mostly.

    def on_paper(self, sheet):
        """A vertex's place, or a point in a triangle."""
        r = self.random
        corners = [sheet.flat_positions[v] for v in r.choice(sheet.triangles).vertex_indices]
        if r.random() < 0.3:
            return Point(corners[0].x, corners[0].y, 0)
        a, b = sorted((r.random(), r.random()))
        weights = a, b - a, 1 - b
        return Point(*(sum(w * getattr(c, axis) for w, c in zip(weights, corners))
                       for axis in 'xyz'))

    def place_on_paper(self, sheet):
        r = self.random
        if r.random() < 0.1:
            return Landmark(name='tip')
        if r.random() < 0.2:
            stamped = PointStamped(point=Point(r.uniform(0, 0.15), r.uniform(0, 0.15), r.uniform(0, 0.1)))
            stamped.header.frame_id = 'world'
            return Landmark(space=stamped)
        return Landmark(flat=self.on_paper(sheet))

    def fold_through(self, sheet):
        r = self.random
        axiom = r.choice(sorted(AXIOMS))
        fields = dict(axiom=axiom, points=[self.place_on_paper(sheet) for _ in range(AXIOMS[axiom])],
                      way=r.choice(['', 'front', 'behind']), angle=r.choice([0, r.uniform(0.1, 2.9)]),
                      duration=r.choice([0, r.uniform(0, 1)]), dry_run=r.random() < 0.3)
        if r.random() < 0.1:
            fields['viewer'] = Vector3(0, 0, r.choice([-1, 1]))
        layers = r.choice([{}, {}, dict(layers='top', count=r.randrange(1, 3)),
                           dict(layers='flap', flap=self.place_on_paper(sheet))])
        return dict(fields, **layers)

    def sensible_fields(self, service, sheet):
        r = self.random
        vertices = range(len(sheet.flat_positions))
        if service == 'fold':
            where = r.choice([
                lambda: dict(line=[self.on_paper(sheet), self.on_paper(sheet)]),
                lambda: dict(vertices=r.sample(vertices, 2)),
                lambda: dict(crease=r.choice(sheet.creases).name if sheet.creases else 'all')])()
            return dict(where, angle=r.uniform(-2.9, 2.9), duration=r.choice([0, r.uniform(0, 1)]))
        if service == 'fold_through':
            return self.fold_through(sheet)
        if service == 'pin':
            return r.choice([
                lambda: dict(vertices=r.sample(vertices, r.randrange(1, 4))),
                lambda: dict(points=[self.on_paper(sheet)]),
                lambda: dict(vertices=[r.choice(vertices)], frame_id=r.choice(
                    ['world', 'hand', '9 lives', '_']))])()
        if service == 'add_vertex':
            edge = list(r.choice(sheet.triangles).vertex_indices)
            return dict(edge=r.sample(edge, 2), fraction=r.uniform(0.1, 0.9))
        return {
            'layers': lambda: dict(point=self.place_on_paper(sheet)),
            'load': lambda: dict(path=r.choice(self.papers)),
            'save': lambda: dict(path=r.choice(self.papers[1:])),
            'step': lambda: dict(steps=r.randrange(1, 12)),
            'undo': lambda: dict(edits=r.randrange(4)),
        }.get(service, dict)()

    def service(self, sheet):
        """A service's name and fields."""
        r = self.random
        if len(sheet.flat_positions) > MOST_VERTICES:
            return 'reset', {}
        if r.random() < 0.4:
            service = r.choice(SERVICES[:-2])
            return service, self.wild_fields(service)
        service = r.choices(SERVICES, weights=WEIGHTS)[0]
        return service, self.sensible_fields(service, sheet)

    # What comes by topics.

    def goal(self):
        r = self.random
        yaml = list(RECIPE)
        for _ in range(r.choice([0, 0, 1, 3, 30])):
            yaml[r.randrange(len(yaml))] = r.choice('0123456789.-[]{}:,& *\n\tae\u00e4')
        return r.choice([FoldRecipeGoal(yaml=''.join(yaml)), FoldRecipeGoal(recipe=self.papers[0]),
                         FoldRecipeGoal(recipe=self.path(), yaml=self.text()),
                         FoldRecipeGoal(recipe=self.text()), FoldRecipeGoal(yaml=self.text())])

    def live(self):
        """Values that are in bounds are those that paper on a table bears."""
        r = self.random
        values = {'gravity_x': r.uniform(-9, 9), 'gravity_y': 0, 'gravity_z': r.uniform(-9, 9),
                  'air_damping': r.uniform(1, 50), 'fold_duration': r.uniform(0.1, 1),
                  'publish_rate': r.uniform(10, 100), 'real_time_factor': 1,
                  self.text(): self.number()}
        config = Config()
        for name in r.sample(sorted(values), r.randrange(len(values) + 1)):
            wild = r.choice([float('nan'), float('inf'), -float('inf'), 1e308, -1e308, -1e5])
            config.doubles.append(DoubleParameter(name, r.choice([values[name], wild])))
        config.bools = [BoolParameter(r.choice(['vertex_ids', self.text()]), r.random() < 0.5)]
        config.strs = [StrParameter(self.text(), self.text())]
        config.ints = [IntParameter(self.text(), r.choice([0, -2 ** 31]))]
        return config
