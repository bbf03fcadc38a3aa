#!/usr/bin/python3
"""What origami_batch writes, and the patterns of recipes/, keep the rules of the FOLD format
(github.com/edemaine/fold, specification 1.2). Knows nothing of our own reader.

ORIGAMI_BATCH names the program.
"""
import collections
import glob
import json
import math
import numbers
import os
import subprocess
import tempfile
import unittest

RECIPES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'recipes')

STRINGS = {'file_creator', 'file_author', 'file_title', 'file_description',
           'frame_author', 'frame_title', 'frame_description', 'frame_unit'}
CHOICES = {
    'file_classes': {'singleModel', 'multiModel', 'animation', 'diagrams'},
    'frame_classes': {'creasePattern', 'foldedForm', 'graph', 'linkage'},
    'frame_attributes': {'2D', '3D', 'abstract', 'manifold', 'nonManifold', 'orientable',
                         'nonOrientable', 'selfTouching', 'nonSelfTouching', 'selfIntersecting',
                         'nonSelfIntersecting', 'cuts', 'noCuts', 'joins', 'noJoins',
                         'convexFaces', 'nonConvexFaces'},
}
UNITS = {'unit', 'in', 'pt', 'm', 'cm', 'mm', 'um', 'nm'}
# Of the rest of the specification, what we write; other words without a colon are reserved.
OTHERS = {'file_spec', 'file_frames', 'frame_parent', 'frame_inherit', 'vertices_coords',
          'edges_vertices', 'edges_assignment', 'edges_foldAngle', 'faces_vertices'}


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def normal(points):
    """Newell's normal of a polygon; its length is twice the area."""
    total = [0, 0, 0]
    for a, b in zip(points, points[1:] + points[:1]):
        total = [x + y for x, y in zip(total, cross(a, b))]
    return total


def refuse_constant(word):
    raise ValueError('JSON has no %s' % word)


def frames_of(document):
    """Every frame with what it inherits; the key frame first."""
    key = {word: value for word, value in document.items() if not word.startswith('file_')}
    own = [key] + document.get('file_frames', [])

    def inherited(index):
        frame = own[index]
        if not frame.get('frame_inherit'):
            return frame
        return {**inherited(frame['frame_parent']), **frame}
    return [inherited(index) for index in range(len(own))]


class SpecCheck(unittest.TestCase):
    """The rules of the format."""

    def load(self, path):
        with open(path) as file:
            return json.load(file, parse_constant=refuse_constant)

    def check_words(self, words):
        for word, value in words.items():
            if ':' in word:
                continue
            self.assertIn(word, STRINGS | set(CHOICES) | OTHERS)
            if word in STRINGS:
                self.assertIsInstance(value, str, word)
            if word in CHOICES:
                self.assertEqual([v for v in value if v not in CHOICES[word] and ':' not in v], [])
        self.assertIn(words.get('frame_unit', 'unit'), UNITS)

    def check_file(self, document):
        self.assertIn(document['file_spec'], [1, 1.1, 1.2])
        self.check_words(document)
        self.assertFalse({'frame_parent', 'frame_inherit'} & set(document))
        for index, frame in enumerate(document.get('file_frames', []), start=1):
            self.check_words(frame)
            self.assertFalse([word for word in frame if word.startswith('file_')])
            self.assertIsInstance(frame.get('frame_inherit', False), bool)
            if frame.get('frame_inherit'):
                self.assertIn('frame_parent', frame)
            if 'frame_parent' in frame:
                self.assertIn(frame['frame_parent'], range(index), 'a parent stands before its child')
        frames = frames_of(document)
        for index, frame in enumerate(frames):
            with self.subTest(frame=index):
                self.check_frame(frame)
        return frames

    def check_frame(self, frame):
        self.check_coordinates(frame)
        self.check_edges(frame)
        if 'faces_vertices' in frame:
            self.check_faces(frame)

    def check_coordinates(self, frame):
        for point in frame['vertices_coords']:
            self.assertIn(len(point), (2, 3))
            for coordinate in point:
                self.assertIsInstance(coordinate, numbers.Real)
                self.assertTrue(math.isfinite(coordinate))
        attributes = frame.get('frame_attributes', [])
        flat = all(z == 0 for point in frame['vertices_coords'] for z in point[2:])
        self.assertEqual('2D' in attributes, flat)
        self.assertEqual('3D' in attributes, not flat)

    def check_edges(self, frame):
        vertices = range(len(frame['vertices_coords']))
        edges = frame['edges_vertices']
        for word in ('edges_assignment', 'edges_foldAngle'):
            self.assertEqual(len(frame.get(word, edges)), len(edges), word)
        for edge in edges:
            self.assertEqual(len(edge), 2)
            self.assertNotEqual(edge[0], edge[1])
            self.assertTrue(edge[0] in vertices and edge[1] in vertices, edge)
        self.assertEqual(len({frozenset(edge) for edge in edges}), len(edges), 'an edge stands once')
        for letter in frame['edges_assignment']:
            self.assertIn(letter, list('BMVFUCJ'))
        for letter, angle in zip(frame['edges_assignment'], frame.get('edges_foldAngle', [])):
            self.assertIsInstance(angle, numbers.Real)
            self.assertLessEqual(abs(angle), 180)
            sign = (angle > 0) - (angle < 0)
            self.assertEqual(sign, {'M': -1, 'V': 1}.get(letter, 0), '%s, %s' % (letter, angle))

    def check_faces(self, frame):
        vertices = range(len(frame['vertices_coords']))
        edges = {frozenset(edge) for edge in frame['edges_vertices']}
        sides = collections.Counter()
        for face in frame['faces_vertices']:
            self.assertGreaterEqual(len(face), 3)
            self.assertEqual([v for v in face if v not in vertices], [])
            sides.update(zip(face, face[1:] + face[:1]))
        # manifold and orientable: no edge is run through twice in one direction.
        self.assertEqual(max(sides.values()), 1)
        self.assertEqual([side for side in sides if frozenset(side) not in edges], [])
        for edge, letter in zip(frame['edges_vertices'], frame['edges_assignment']):
            faces = sides[tuple(edge)] + sides[tuple(edge[::-1])]
            self.assertEqual(faces, 1 if letter == 'B' else 2, edge)
        if '2D' in frame['frame_attributes']:
            for face in frame['faces_vertices']:
                corners = [(frame['vertices_coords'][v] + [0])[:3] for v in face]
                self.assertGreater(normal(corners)[2], 0, 'face %s is clockwise' % face)

    def check_angles(self, frame):
        """edges_foldAngle is what the folded form shows: a valley turns the normals to each other."""
        face_left_of = {}
        for face in frame['faces_vertices']:
            for side in zip(face, face[1:] + face[:1]):
                face_left_of[side] = normal([frame['vertices_coords'][v] for v in face])
        checked = 0
        for edge, letter, angle in zip(frame['edges_vertices'], frame['edges_assignment'],
                                       frame['edges_foldAngle']):
            if letter not in 'MV':
                continue
            left, right = face_left_of[tuple(edge)], face_left_of[tuple(edge[::-1])]
            along = subtract(frame['vertices_coords'][edge[1]], frame['vertices_coords'][edge[0]])
            sine = -dot(cross(left, right), along) / math.sqrt(dot(along, along))
            shown = math.degrees(math.atan2(sine, dot(left, right)))
            # An angle is that of the whole crease, which is not bent to the same at each edge.
            self.assertAlmostEqual(angle, shown, delta=6)
            checked += 1
        return checked


class FoldSpecTest(SpecCheck):
    def fold(self, recipe, *options):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        subprocess.run([os.environ['ORIGAMI_BATCH'], os.path.join(RECIPES, recipe + '.yaml'),
                        '--out', folder.name, *options], check=True)
        return [self.load(os.path.join(folder.name, name))
                for name in ('final.fold', 'frames.fold', 'diagrams.fold')]

    def check_run(self, *documents):
        for document in documents:
            everything = self.check_file(document)
            self.assertIn('creasePattern', everything[0]['frame_classes'])
            self.assertIn('2D', everything[0]['frame_attributes'])
            self.assertLessEqual(OTHERS - {'frame_parent', 'frame_inherit'}, set(document))
            for frame in everything[1:]:
                self.assertIn('foldedForm', frame['frame_classes'])
        self.assertEqual(len(documents[0]['file_frames']), 1)

    def test_lines_that_change_the_mesh(self):
        final, frames, diagrams = self.fold('elephant')
        self.check_run(final, frames, diagrams)
        self.assertGreater(self.check_angles(frames_of(final)[1]), 20)
        self.assertIn('animation', frames['file_classes'])
        self.assertGreater(len(frames['file_frames']), 30)
        self.assertGreater(len({len(f['vertices_coords']) for f in frames['file_frames']}), 1)

    def test_a_pattern_with_free_creases(self):
        final, frames, diagrams = self.fold('miura')
        self.check_run(final, frames, diagrams)
        self.assertEqual(self.check_angles(frames_of(final)[1]), 120)
        # A film's frames state the angles of their own instant.
        for frame in frames_of(frames)[2:]:
            self.assertEqual(self.check_angles(frame), 120)

    def test_a_pattern_that_nobody_folded(self):
        final, frames, diagrams = self.fold('miura', '--set', 'steps=[]')
        self.check_run(final, frames, diagrams)
        self.assertEqual(len(diagrams['file_frames']), 1)
        # The pattern keeps what it asks for; the form shows that nothing was folded.
        kinds = collections.Counter(final['edges_assignment'])
        self.assertEqual((kinds['M'] > 0, kinds['V'] > 0, kinds['M'] + kinds['V']), (True, True, 120))
        self.assertEqual(collections.Counter(frames_of(final)[1]['edges_assignment'])['U'], 120)

    def test_the_patterns_of_recipes(self):
        paths = glob.glob(os.path.join(RECIPES, 'patterns', '*.fold'))
        self.assertGreaterEqual(len(paths), 6)
        for path in paths:
            with self.subTest(pattern=os.path.basename(path)):
                self.check_file(self.load(path))


class BatchTest(unittest.TestCase):
    """What origami_batch answers when it cannot fold a recipe to its end."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.out = os.path.join(self.folder, 'out')

    def batch(self, recipe, *options, **files):
        for name, text in dict(files, recipe=recipe).items():
            suffix = '.yaml' if name == 'recipe' else '.fold'
            with open(os.path.join(self.folder, name + suffix), 'w') as handle:
                handle.write(text)
        return subprocess.run([os.environ['ORIGAMI_BATCH'], os.path.join(self.folder, 'recipe.yaml'),
                               '--out', self.out, *options], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True)

    def report(self):
        with open(os.path.join(self.out, 'report.json')) as handle:
            return json.load(handle)

    def written(self, name):
        with open(os.path.join(self.out, name + '.fold')) as handle:
            return json.load(handle)

    def check_everything_is_written(self):
        self.assertEqual(sorted(os.listdir(self.out)),
                         ['diagrams.fold', 'final.fold', 'final.obj', 'frames.fold', 'report.json'])

    def test_a_crease_that_misses_its_target_is_said(self):
        batch = self.batch('sheet: {size: [0.1, 0.1], max_edge: 0.02}\n'
                           'steps:\n'
                           '  - fold: [{line: [[0.05, 0], [0.05, 0.1]], angle_deg: 90, name: first},\n'
                           '           {line: [[0, 0.05], [0.1, 0.05]], angle_deg: 90, name: second}]\n'
                           '  - settle: {timeout: 5}\n')
        self.assertEqual(batch.returncode, 3, batch.stderr)
        self.assertIn('missed the target angle by more than 2 degrees', batch.stderr)
        missed = self.report()['missed']
        self.assertGreater(len(missed), 0)
        for crease in missed:
            self.assertGreater(abs(crease['target_deg'] - crease['angle_deg']), 5)
            self.assertIn('is open', crease['why'])

    def test_a_step_that_fails_leaves_the_paper_as_it_was_then(self):
        run = self.batch('sheet: {size: [0.1, 0.1], max_edge: 0.02}\n'
                         'solver: {tolerance: 1.0e-15, max_iterations: 1}\n'
                         'steps:\n'
                         '  - fold: [{line: [[0, 0.03], [0.1, 0.06]], angle_deg: 90}]\n')
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn('ended early, in step 1 of 1', run.stderr)
        self.check_everything_is_written()
        self.assertIn('did not converge', self.report()['failure'])

    def test_an_edit_that_is_rejected_leaves_the_paper_as_it_was_then(self):
        run = self.batch('sheet: {size: [0.1, 0.1], max_edge: 0.05}\n'
                         'steps:\n'
                         '  - fold: [{line: [[0, 0.05], [0.1, 0.05]], angle_deg: 20}]\n'
                         '    duration: 0.1\n'
                         '  - fold: [{crease: nowhere, angle_deg: 20}]\n')
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn('step 2 of 2', run.stderr)
        self.check_everything_is_written()
        # The sequence ends where the paper does: what was rejected is no step of it.
        self.assertEqual([frame['frame_title'] for frame in self.written('diagrams')['file_frames']],
                         ['start', 'fold, 20 degrees'])
        self.assertIn('nowhere', self.report()['failure'])
        self.assertGreater(self.report()['steps'], 0)

    def test_a_settle_step_that_times_out_is_reported(self):
        run = self.batch('sheet: {size: [0.1, 0.1], max_edge: 0.05}\n'
                         'steps:\n'
                         '  - fold: [{line: [[0, 0.05], [0.1, 0.05]], angle_deg: 10}]\n'
                         '    duration: 0\n'
                         '  - settle: {timeout: 0.02}\n')
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn('step 2: the paper had not settled after 0.02 s', run.stderr)
        self.assertEqual(self.report()['timeouts'], [2])
        self.assertIsNone(self.report()['failure'])

    def test_nested_lists_are_rejected(self):
        for text in ('[' * 200000, '{"vertices_coords": ' + '[' * 200000 + ']' * 200000 + '}',
                     '{"a":' * 100000):
            run = self.batch('sheet: {pattern: deep.fold, scale: 1}', deep=text)
            self.assertEqual(run.returncode, 1, run.stderr)
            self.assertIn('deep.fold: its lists and objects nest deeper than 100 levels', run.stderr)
            self.assertFalse(os.path.exists(self.out))


if __name__ == '__main__':
    unittest.main()
