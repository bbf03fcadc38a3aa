#!/usr/bin/python3
"""diagrams.fold: what origami_batch writes of the steps of a recipe, and folds again.

ORIGAMI_BATCH names the program.
"""
import json
import math
import os
import subprocess
import tempfile
import unittest

from fold_spec_test import SpecCheck


class SequenceTest(SpecCheck):
    # Two folds of different kinds; the second crosses the first one's crease, and what it does not fold
    # of the paper stays.
    RECIPE = ('sheet: {size: [0.1, 0.1], max_edge: 0.02}\n'
              'steps:\n'
              '  - pin: {points: [[0, 0]]}\n'
              '  - fold: [{line: [[0.05, 0], [0.05, 0.1]], angle_deg: 60, name: middle}]\n'
              '  - settle: {timeout: 5}\n'
              '  - turn_over: {}\n'
              '  - fold_through: {through: [[0.02, 0], [0, 0.03]], move: [0, 0], angle_deg: 120}\n'
              '  - settle: {timeout: 5}\n')

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def batch(self, file, out):
        run = subprocess.run([os.environ['ORIGAMI_BATCH'], os.path.join(self.folder, file), '--out',
                              os.path.join(self.folder, out)], stderr=subprocess.PIPE, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return self.load(os.path.join(self.folder, out, 'diagrams.fold')), run.stderr

    def recipe(self):
        with open(os.path.join(self.folder, 'recipe.yaml'), 'w') as file:
            file.write(self.RECIPE)
        return self.batch('recipe.yaml', 'out')[0]

    def sequence(self, document):
        """Folds a changed sequence."""
        with open(os.path.join(self.folder, 'sequence.fold'), 'w') as file:
            json.dump(document, file)
        return self.batch('sequence.fold', 'again')

    def angles(self, frame):
        """Returns of each crease its ends on the flat sheet and its mean angle, in the order of its ends."""
        flat, lines = frame['vertices_shell_origami:flat_coords'], {}
        for (a, b), letter, angle in zip(frame['edges_vertices'], frame['edges_assignment'],
                                         frame['edges_foldAngle']):
            if letter in 'MVU':  # an angle is that of the whole crease
                lines.setdefault(angle, []).extend([flat[a], flat[b]])
        return sorted((min(points), max(points), angle) for angle, points in lines.items())

    def test_a_frame_for_each_step_that_folds(self):
        document = self.recipe()
        self.check_file(document)
        self.assertEqual(document['file_classes'], ['diagrams'])
        start, first, second = document['file_frames']
        self.assertEqual([frame['frame_title'] for frame in (start, first, second)],
                         ['start', 'fold, 60 degrees', 'fold_through, 120 degrees'])
        self.assertEqual([frame['shell_origami:step'] for frame in (start, first, second)], [0, 2, 5])
        self.assertEqual([frame['shell_origami:front'] for frame in (start, first, second)],
                         [True, False, False])
        for frame, creases in ((start, 0), (first, 1), (second, 2)):
            self.assertEqual(len(self.angles(frame)), creases)
            self.assertEqual(len(frame['vertices_shell_origami:flat_coords']), len(frame['vertices_coords']))
        # The paper has settled in each frame, and what its step folded is told from what was there.
        self.assertAlmostEqual(self.angles(first)[0][2], 60, delta=0.5)
        for frame, angle in ((first, 60), (second, -120)):
            new = [angle for angle, new in zip(frame['edges_foldAngle'],
                                               frame['edges_shell_origami:new_creases']) if new]
            self.assertGreater(len(new), 0)
            for shown in new:
                self.assertAlmostEqual(shown, angle, delta=0.5)

    def test_read_again_it_folds_to_the_same_angles(self):
        document = self.recipe()
        again, said = self.sequence(document)
        self.assertEqual(said, '')
        self.assertEqual(len(again['file_frames']), 3)
        for frame, repeated in zip(document['file_frames'][1:], again['file_frames'][1:]):
            found = [crease for crease in self.angles(repeated) if abs(crease[2]) > 1]
            self.assertEqual(len(found), len(self.angles(frame)))
            for (a, b, angle), (c, d, same) in zip(self.angles(frame), found):
                self.assertAlmostEqual(angle, same, delta=0.5)
                self.assertLess(math.dist(a + b, c + d), 1e-6)

    def test_a_frame_that_cannot_be_used_is_passed_over(self):
        document = self.recipe()
        del document['file_frames'][1]['edges_foldAngle']
        again, said = self.sequence(document)
        self.assertIn('file_frames[1] was passed over: it has no edges_foldAngle of its own', said)
        self.assertEqual(len(again['file_frames']), 2)
        self.assertAlmostEqual(max(angle for _, _, angle in self.angles(again['file_frames'][1])), 60,
                               delta=0.5)

    def test_a_pattern_without_a_unit_needs_a_width(self):
        document = self.recipe()
        del document['frame_unit']
        path = os.path.join(self.folder, 'no_unit.fold')
        with open(path, 'w') as file:
            json.dump(document, file)
        run = subprocess.run([os.environ['ORIGAMI_BATCH'], path, '--out', self.folder],
                             stderr=subprocess.PIPE, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn('no_unit.fold: states no physical unit', run.stderr)
        self.assertIn('or a width', run.stderr)


if __name__ == '__main__':
    unittest.main()
