#!/usr/bin/python3
"""~fold_through folds paper as it lies there, ~layers says what lies where, ~turn_over looks at the other
side; what makes no sense is refused and changes nothing."""

import math

import rospy
import rostest
from geometry_msgs.msg import Point, PointStamped, Vector3

from moving_frame import MovingFrame
from origami_client import NodeTest, wait_for_transform
from recipe_goal import Goal, connect
from shell_origami.msg import Landmark

SIDE = 0.15
MIDDLE = SIDE / 2
SHUT = math.radians(178)
NAN = float('nan')
NAMES = '''names:
  tip: {corner: [0, 0]}
  far: [0.15, 0.15]
  center: {meet: [tip, far, [0.15, 0], [0, 0.15]]}
steps: []
'''


def flat(x, y):
    return Landmark(flat=Point(x, y, 0))


def name(text):
    return Landmark(name=text)


def space(x, y, z, frame='world'):
    landmark = Landmark(space=PointStamped(point=Point(x, y, z)))
    landmark.space.header.frame_id = frame
    return landmark


def through(x0, y0, x1, y1, x, y, **fields):
    return dict(axiom='through', points=[flat(x0, y0), flat(x1, y1), flat(x, y)], **fields)


# In the middle, so that the right half moves; and so that the upper half does.
RIGHT = through(MIDDLE, 0, MIDDLE, SIDE, SIDE, 0.03, duration=0.5)
UPPER = through(0, MIDDLE, MIDDLE, MIDDLE, 0.03, SIDE, duration=0.5)


class FoldThroughTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        super(FoldThroughTest, cls).setUpClass()
        cls.goals = connect()

    def fold(self, **fields):
        return self.origami.do('fold_through', **fields)

    def fold_and_rest(self, **fields):
        answer = self.fold(**fields)
        self.origami.do('step', steps=90)
        return answer

    def front(self):
        """Whether the front of the lower left corner is looked at: a fold towards who looks is a valley
        there."""
        segment, = self.fold(axiom='bring', points=[flat(0, 0), flat(0.03, 0.03)], dry_run=True).segments
        return segment.angle > 0

    def run_recipe(self, yaml):
        self.assertIn('the recipe is done', Goal(self.goals, yaml=yaml).wait()[1])
        self.origami.do('pause')

    def assertSamePaper(self, state, expected):
        for field in ('positions', 'pinned', 'creases', 'edits', 'revision'):
            self.assertEqual(getattr(state, field), getattr(expected, field), field)

    def assertSegment(self, segment, ends, angle):
        for end in ends:
            nearest = min(math.hypot(p.x - end[0], p.y - end[1]) for p in (segment.start, segment.end))
            self.assertLess(nearest, 2e-3)
        self.assertAlmostEqual(segment.angle, angle, delta=1e-9)

    def test_a_corner_is_brought_to_another(self):
        answer = self.fold(axiom='bring', points=[flat(0, 0), flat(SIDE, SIDE)])
        segment, = answer.segments
        self.assertSegment(segment, [(SIDE, 0), (0, SIDE)], SHUT)
        self.assertEqual(segment.panel, 0)
        state = self.origami.state()
        crease, = state.creases
        self.assertEqual(list(answer.crease_ids), [crease.id])
        self.assertEqual((answer.edit, answer.revision), (state.edits, state.revision))
        self.assertAlmostEqual(crease.target_angle, SHUT, delta=1e-6)

    def test_the_other_axioms(self):
        corners = [flat(0, 0), flat(SIDE, 0)], [flat(0, SIDE), flat(SIDE, SIDE)]
        edges = self.fold(axiom='edges', points=corners[0] + corners[1], dry_run=True)
        self.assertSegment(edges.segments[0], [(0, MIDDLE), (SIDE, MIDDLE)], SHUT)
        across = self.fold(axiom='across', points=corners[0] + [flat(0.05, 0), flat(0, 0)],
                           way='behind', angle=1.0, dry_run=True)
        self.assertSegment(across.segments[0], [(0.05, 0), (0.05, SIDE)], -1.0)

    def test_both_layers_fold_and_are_undone_as_one(self):
        self.fold_and_rest(**RIGHT)
        before = self.origami.state()
        folded = self.fold(**UPPER)
        left, right = sorted(folded.segments, key=lambda s: min(s.start.x, s.end.x))
        self.assertSegment(left, [(0, MIDDLE), (MIDDLE, MIDDLE)], SHUT)
        self.assertSegment(right, [(MIDDLE, MIDDLE), (SIDE, MIDDLE)], -SHUT)
        self.assertEqual({left.panel, right.panel}, {0, 1})
        self.assertEqual(len(folded.crease_ids), 2)
        edits = self.origami.edits_since(before.edits)
        self.assertEqual([e.kind for e in edits], ['fold', 'fold'])
        self.assertEqual(edits[-1].number, folded.edit)
        self.origami.do('step', steps=10)

        undo = self.origami.do('undo')
        self.assertIn('before edit %d' % (before.edits + 1), undo.message)
        after = self.origami.state()
        self.assertEqual(after.positions, before.positions)
        self.assertEqual(after.creases, before.creases)
        # It goes on from there.
        self.assertEqual(len(self.fold(**UPPER).segments), 2)

    def test_layers_are_listed_from_the_front(self):
        self.fold_and_rest(**RIGHT)
        self.fold_and_rest(**UPPER)
        answer = self.origami.do('layers', point=flat(0.02, 0.03))
        self.assertEqual(answer.message, '4 layers')
        self.assertEqual(sorted(answer.panels), [0, 1, 2, 3])
        self.assertEqual(answer.gaps[0], 0)
        self.assertTrue(all(0 < gap < 0.01 for gap in answer.gaps[1:]), answer.gaps)
        expected = [(0.02, 0.03), (SIDE - 0.02, 0.03), (SIDE - 0.02, SIDE - 0.03), (0.02, SIDE - 0.03)]
        places = [(p.x, p.y) for p in answer.flat_points]
        for place in expected:
            nearest = min(math.hypot(place[0] - x, place[1] - y) for x, y in places)
            self.assertLess(nearest, 5e-3, '%s of %s' % (place, places))
        self.assertLess(math.hypot(places[-1][0] - 0.02, places[-1][1] - 0.03), 1e-9)  # which stayed
        self.assertEqual(len(self.origami.do('layers', point=flat(0, 0)).panels), 4)
        behind = self.origami.do('layers', point=flat(0.02, 0.03), viewer=Vector3(0, 0, -1))
        self.assertEqual(behind.panels, answer.panels[::-1])

    def test_the_top_layer_or_a_flap_alone(self):
        self.fold_and_rest(**RIGHT)
        corner = dict(axiom='bring', points=[flat(SIDE, SIDE), flat(SIDE - 0.05, SIDE - 0.05)])
        top = self.fold(layers='top', count=1, dry_run=True, **corner)
        flap = self.fold(layers='flap', flap=flat(SIDE, SIDE), dry_run=True, **corner)
        for answer in (top, flap):
            self.assertEqual(len(answer.segments), 1)
            self.assertSegment(answer.segments[0], [(SIDE - 0.05, SIDE), (SIDE, SIDE - 0.05)], -SHUT)

    def test_landmarks_by_name_and_in_space(self):
        self.run_recipe(NAMES)
        by_name = self.fold(axiom='bring', points=[name('tip'), name('center')], dry_run=True)
        self.assertSegment(by_name.segments[0], [(MIDDLE, 0), (0, MIDDLE)], SHUT)
        # The nearest point of the paper.
        in_space = self.fold(axiom='bring', points=[space(-0.01, -0.01, 0.02), space(MIDDLE, MIDDLE, 0)],
                             dry_run=True)
        self.assertSegment(in_space.segments[0], [(MIDDLE, 0), (0, MIDDLE)], SHUT)
        MovingFrame('hand').pose = (0.1, 0, 0, 0)
        wait_for_transform(lambda t: t.child_frame_id == 'hand' and t.transform.translation.x == 0.1)
        in_frame = self.fold(axiom='bring', points=[flat(0, 0), space(-0.025, MIDDLE, 0, 'hand')],
                             dry_run=True)
        self.assertSegment(in_frame.segments[0], [(MIDDLE, 0), (0, MIDDLE)], SHUT)
        self.origami.do('reset')
        self.assertSegment(self.fold(axiom='bring', points=[name('tip'), name('center')],
                                     dry_run=True).segments[0], [(MIDDLE, 0), (0, MIDDLE)], SHUT)

    def test_the_view_goes_with_the_paper(self):
        self.assertTrue(self.front())
        self.origami.do('turn_over')
        self.assertFalse(self.front())
        self.origami.do('reset')
        self.assertTrue(self.front())

        # It stays with what stays, and comes back with undone edits.
        self.origami.do('turn_over')
        self.fold_and_rest(**dict(RIGHT, way='behind'))
        self.origami.do('turn_over')
        self.fold(**dict(UPPER, way='behind', angle=0.5))
        self.origami.do('undo')
        self.assertGreater(self.fold(dry_run=True, **UPPER).segments[0].angle, 0)
        self.origami.do('undo')
        self.assertFalse(self.front())

    def test_a_viewer_picks_the_side(self):
        for z, front in ((1, True), (-1, False)):
            answer = self.fold(viewer=Vector3(0.1, 0.2, z), dry_run=True, **RIGHT)
            self.assertEqual(answer.segments[0].angle > 0, front)
        self.assertTrue(self.front())  # a dry run leaves the view alone
        self.fold_and_rest(viewer=Vector3(0, 0, -1), **dict(RIGHT, angle=0.2))
        self.assertFalse(self.front())

    def test_a_recipe_leaves_its_view(self):
        self.run_recipe('sheet: {size: [0.15, 0.15], max_edge: 0.03}\nsteps: [turn_over: {}]\n')
        self.assertFalse(self.front())
        self.run_recipe('steps: [turn_over: {}]\n')
        self.assertTrue(self.front())

    def test_a_dry_run_changes_nothing(self):
        before = self.origami.state()
        answer = self.fold(dry_run=True, **RIGHT)
        self.assertIn('nothing is changed', answer.message)
        self.assertEqual(list(answer.crease_ids), [])
        self.assertEqual((answer.edit, answer.revision), (before.edits, before.revision))
        self.assertSamePaper(self.origami.state(), before)
        self.assertEqual(self.fold(**RIGHT).segments, answer.segments)

    def refused(self, words, service='fold_through', **fields):
        """What is wrong with the answer to a request that is to be refused."""
        for dry_run in (dict(dry_run=True), {}) if service == 'fold_through' else ({},):
            answer = self.origami.call(service, **dict(fields, **dry_run))
            if (answer.success or '\n' in answer.message or
                    not all(word in answer.message for word in words)):
                return '%s: %s' % (fields, answer.message or 'done')
        return ''

    def test_what_makes_no_sense_is_refused(self):
        self.run_recipe(NAMES)
        self.fold_and_rest(**RIGHT)
        before = self.origami.state()
        ends = [flat(0, 0), flat(0.05, 0.05)]
        cases = [
            (['(0.2, 0)', 'off the paper'], dict(axiom='bring', points=[flat(0, 0), flat(0.2, 0)])),
            (['axiom', '"fold"', 'bring or edges'], dict(axiom='fold', points=ends)),
            (['axiom', '""'], dict(points=ends)),
            (['2 entries', 'bring', 'holds 3'], dict(axiom='bring', points=ends + ends[:1])),
            (['4 entries', 'edges', 'holds 2'], dict(axiom='edges', points=ends)),
            (['4 entries', 'across', 'holds 0'], dict(axiom='across')),
            (['3 entries', 'through', 'holds 2'], dict(axiom='through', points=ends)),
            (['points[1].flat', 'nan'], dict(axiom='bring', points=[flat(0, 0), flat(NAN, 0)])),
            (['points[0].space', 'inf'], dict(axiom='bring', points=[space(0, math.inf, 0), flat(0, 0)])),
            (['too far'], dict(axiom='bring', points=[space(0, 1e300, 0), flat(0, 0)])),
            (['points[0].flat', 'z must be 0'],
             dict(axiom='bring', points=[Landmark(flat=Point(0, 0, 1)), flat(0, 0)])),
            (['points[1].space', 'names no frame'],
             dict(axiom='bring', points=[flat(0, 0), space(1, 1, 1, '')])),
            (['points[1]', 'nowhere'], dict(axiom='bring', points=[flat(0, 0), space(0, 0, 0, 'nowhere')])),
            (['points[0]', 'one of name, flat and space'],
             dict(axiom='bring', points=[Landmark(name='tip', flat=Point(1, 0, 0)), flat(0, 0)])),
            (['points[1]', '"nek"', 'center, far, tip'],
             dict(axiom='bring', points=[flat(0, 0), name('nek')])),
            (['layers', '"bottom"', 'all or top or flap'], dict(UPPER, layers='bottom')),
            (['count is 0'], dict(UPPER, layers='top')),
            (['count is 4294967295'], dict(UPPER, layers='top', count=2 ** 32 - 1)),
            (['top is 3', 'there are 2'], dict(UPPER, layers='top', count=3)),
            (['count is 1', 'layers "top"'], dict(UPPER, count=1)),
            (['flap belongs to'], dict(UPPER, flap=flat(0.1, 0.1))),
            (['way', '"up"', 'front or behind'], dict(UPPER, way='up')),
            (['viewer', 'nan'], dict(UPPER, viewer=Vector3(NAN, 0, 0))),
            (['viewer', 'edges'], dict(UPPER, viewer=Vector3(0, 1, 0))),
            (['angle is 3.2'], dict(UPPER, angle=3.2)),
            (['angle is -1'], dict(UPPER, angle=-1)),
            (['angle is nan'], dict(UPPER, angle=NAN)),
            (['duration is -1'], dict(UPPER, duration=-1)),
            (['duration is nan'], dict(UPPER, duration=NAN)),
            (['on the fold'], through(0, 0, 0.05, 0, 0.03, 0)),
            (['at one place'], through(0.01, 0.01, 0.01, 0.01, 0.03, 0)),
            (['at one place'], dict(axiom='bring', points=[flat(0, 0), flat(SIDE, 0)])),
            (['not on the side that moves'],
             dict(UPPER, layers='flap', flap=flat(0.03, 0.03))),
            # The right half lies on the left one.
            (['stays', 'over'], dict(axiom='bring', points=[flat(0, 0), flat(0.05, 0.05)], layers='flap',
                                     flap=flat(0, 0))),
            (['stays', 'behind'], dict(RIGHT, points=RIGHT['points'][:2] + [flat(0.01, 0)], layers='flap',
                                       flap=flat(SIDE, 0), way='behind')),
        ]
        of_layers = [(['(1, 1)', 'off the paper'], dict(point=flat(1, 1))),
                     (['"nek"'], dict(point=name('nek'))),
                     (['point.flat', 'nan'], dict(point=flat(NAN, 0))),
                     (['viewer'], dict(point=flat(0, 0), viewer=Vector3(0, 0, NAN)))]
        wrong = [self.refused(words, **fields) for words, fields in cases]
        wrong += [self.refused(words, service='layers', **fields) for words, fields in of_layers]
        self.assertEqual([message for message in wrong if message], [])
        self.assertSamePaper(self.origami.state(), before)
        self.assertEqual(self.origami.edits_since(before.edits), [])

    def test_a_crease_that_would_pass_180_degrees_is_refused(self):
        self.fold_and_rest(**dict(RIGHT, angle=0.3))
        before = self.origami.state()
        self.assertEqual(self.refused(['crease fold_0', 'would pass 180'], **RIGHT), '')
        self.assertSamePaper(self.origami.state(), before)

    def test_names_are_those_of_a_recipe(self):
        self.run_recipe('sheet: {size: [0.15, 0.15], max_edge: 0.03}\nsteps: []\n')
        words = ['points[0]', '"tip"', 'no recipe']
        self.assertEqual(self.refused(words, axiom='bring', points=[name('tip'), flat(0, 0)]), '')


if __name__ == '__main__':
    rospy.init_node('fold_through_test')
    rostest.rosrun('shell_origami', 'fold_through_test', FoldThroughTest)
