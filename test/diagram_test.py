#!/usr/bin/python3
"""scripts/diagram.py: the pictures of a folding sequence have the lines, arrows and words of their steps.

ORIGAMI_BATCH names the program that folds them.
"""
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SVG = '{http://www.w3.org/2000/svg}'
VALLEY, MOUNTAIN = '1.8 0.9', '2.6 0.7 0.4 0.7 0.4 0.7'
WHITE = '#ffffff'
SHEET = 'sheet: {size: [0.1, 0.1], max_edge: 0.025}\n'
HALF = '{line: [[0.05, 0], [0.05, 0.1]], angle_deg: %g, name: middle}'
SETTLE = '  - settle: {timeout: 3}\n'


def points(path):
    """Returns the points of a path of straight lines."""
    return [tuple(map(float, pair)) for pair in re.findall(r'(-?[\d.]+) (-?[\d.]+)', path.get('d'))]


class Picture:
    """A picture of the diagram: its shapes by their class, in the order in which they are drawn."""

    def __init__(self, group):
        self.name = group.get('id')
        self.shapes = [shape for shape in group if shape.get('class')]
        self.texts = [text.text for text in group.iter(SVG + 'text')]
        self.caption = ' '.join(text for text in self.texts)

    def of(self, kind):
        return [shape for shape in self.shapes if shape.get('class') == kind]

    def panels(self):
        return [shape for shape in self.shapes if shape.get('class') in ('front', 'back')]


class DiagramTest(unittest.TestCase):
    def draw(self, recipe, *options, text=None):
        """Returns the pictures of a recipe, and how many pages its PDF has."""
        with tempfile.TemporaryDirectory() as folder:
            if text:
                recipe = os.path.join(folder, recipe)
                with open(recipe, 'w') as file:
                    file.write(text)
            batch = subprocess.run([os.environ['ORIGAMI_BATCH'], recipe, '--out', folder, *options],
                                   stderr=subprocess.PIPE, text=True)
            self.assertIn(batch.returncode, (0, 3), batch.stderr)
            subprocess.run([sys.executable, os.path.join(ROOT, 'scripts', 'diagram.py'),
                            os.path.join(folder, 'diagrams.fold'), folder, recipe], check=True)
            root = ElementTree.parse(os.path.join(folder, 'diagram.svg')).getroot()
            with open(os.path.join(folder, 'diagram.pdf'), 'rb') as file:
                pages = len(re.findall(rb'/Type /Page\b', file.read()))
        return [Picture(group) for group in root.iter(SVG + 'g')], pages

    def plain(self, steps):
        return self.draw('plain.yaml', text=SHEET + 'steps:\n' + steps)[0]

    def check_line(self, picture, kind, ends):
        """Checks the one line of a kind; `ends` are corners (0, 0) to (1, 1) of the paper's box."""
        self.assertEqual(len(picture.of(kind)), 1)
        line = picture.of(kind)[0]
        self.assertEqual(line.get('stroke-dasharray'), VALLEY if kind == 'valley' else MOUNTAIN)
        xs, ys = zip(*[point for panel in picture.panels() for point in points(panel)])
        expected = [(min(xs) + x * (max(xs) - min(xs)), max(ys) - y * (max(ys) - min(ys))) for x, y in ends]
        found = points(line)
        self.assertEqual(len(found), 2)
        for end in expected:
            self.assertLess(min(math.dist(end, point) for point in found), 0.5)

    def test_the_cup(self):
        pictures, pages = self.draw(os.path.join(ROOT, 'recipes', 'cup.yaml'))
        self.assertEqual([picture.name for picture in pictures],
                         ['step_%d' % k for k in range(1, 6)] + ['finished'])
        self.assertEqual(pages, 1)
        for picture in pictures[:-1]:
            # Each fold is a valley on the layer in view, and its arrow comes over the paper.
            self.assertEqual(len(picture.of('valley')), 1, picture.name)
            self.assertEqual(len(picture.of('arrow')), 1, picture.name)
            self.assertEqual(picture.of('mountain') + picture.of('hidden') + picture.of('arrow behind'), [])
        self.check_line(pictures[0], 'valley', [(0, 1), (1, 0)])
        self.assertEqual([len(picture.of('turn-over')) for picture in pictures], [0, 0, 0, 1, 0, 0])
        self.assertIn('Turn over.', pictures[3].caption)
        # The names of the recipe, in the caption and beside the marks.
        self.assertIn('1. Bring the back rim to the rim.', pictures[0].caption)
        self.assertLessEqual({'back rim', 'rim'}, set(pictures[0].texts))
        self.assertIn('Take only the top layer.', pictures[4].caption)
        self.assertIn('The finished cup.', pictures[5].caption)
        # No mesh is seen: the square has four corners, and the folded one two triangles.
        self.assertEqual([len(points(panel)) for panel in pictures[0].panels()], [4])
        self.assertEqual([len(points(panel)) for panel in pictures[1].panels()], [3, 3])
        self.assertEqual(pictures[-1].of('valley') + pictures[-1].of('arrow'), [])

    def test_what_lies_on_top_is_drawn_last(self):
        over = self.plain('  - fold: [%s]\n' % HALF % 175 + SETTLE)
        self.check_line(over[0], 'valley', [(0.5, 0), (0.5, 1)])
        self.assertEqual([panel.get('class') for panel in over[1].panels()], ['front', 'back'])
        behind = self.plain('  - fold: [%s]\n' % HALF % -175 + SETTLE)
        self.assertEqual([panel.get('class') for panel in behind[1].panels()], ['back', 'front'])

    def test_folds_behind(self):
        picture = self.plain('  - fold: [%s]\n' % HALF % -175 + SETTLE)[0]
        self.check_line(picture, 'mountain', [(0.5, 0), (0.5, 1)])
        self.assertEqual(len(picture.of('arrow behind')), 1)
        self.assertEqual([head.get('fill') for head in picture.of('head behind')], [WHITE])
        self.assertIn('Fold behind along the line (middle).', picture.caption)

    def test_lower_layers_are_fanned(self):
        half, _, finished = self.plain('  - fold: [%s]\n' % HALF % 177 + SETTLE +
                                       '  - fold: [{crease: middle, angle_deg: 178}]\n' + SETTLE)
        self.assertEqual(len(half.panels()), 1)
        lower, upper = (list(zip(*points(panel))) for panel in finished.panels())
        # On some side the border below stands out by a layer's offset, or its part along that side.
        axes = list(zip(lower, upper))
        out = [max(a) - max(b) for a, b in axes] + [min(b) - min(a) for a, b in axes]
        self.assertGreater(max(out), 0.3)
        self.assertLess(max(out), 1)

    def test_the_side_that_is_turned_up(self):
        pictures = self.plain('  - turn_over: {}\n  - fold: [%s]\n' % HALF % 175 + SETTLE)
        self.assertEqual([panel.get('class') for panel in pictures[0].panels()], ['back'])
        # A valley of the front is a mountain for who sees the back.
        self.check_line(pictures[0], 'mountain', [(0.5, 0), (0.5, 1)])

    def test_lines_that_nobody_sees(self):
        # What lies below a flap is creased, up to where the flap ends.
        picture = self.plain('  - fold: [{line: [[0.06, 0], [0.06, 0.1]], angle_deg: 175}]\n' + SETTLE +
                             '  - fold: [{line: [[0.03, 0.05], [0.06, 0.05]], angle_deg: -10}]\n')[1]
        self.assertEqual(len(picture.of('hidden')), 1)
        self.assertEqual(picture.of('valley') + picture.of('mountain'), [])

    def test_creases_that_are_there(self):
        picture = self.plain('  - fold: [%s]\n' % HALF % 1 + SETTLE +
                             '  - fold: [{line: [[0, 0.05], [0.1, 0.05]], angle_deg: 60}]\n')[1]
        # It ends before the edges of the paper, and is no line to be folded.
        crease, = picture.of('crease')
        ys = [y for _, y in points(crease)]
        edge = [y for panel in picture.panels() for _, y in points(panel)]
        self.assertGreater(min(ys), min(edge) + 0.5)
        self.assertLess(max(ys), max(edge) - 0.5)
        self.assertEqual(len(picture.of('valley')), 1)
        self.assertIn('Turn it by 60 degrees.', picture.caption)

    def test_a_file_that_is_no_sequence(self):
        pattern = os.path.join(ROOT, 'recipes', 'patterns', 'miura.fold')
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, os.path.join(ROOT, 'scripts', 'diagram.py'), pattern, folder],
                                 stderr=subprocess.PIPE, text=True)
            self.assertEqual(os.listdir(folder), [])
        self.assertEqual((run.returncode, run.stderr),
                         (1, 'diagram: %s is no folding sequence that origami_batch wrote\n' % pattern))

    def test_pages(self):
        fold = '  - fold: [{line: [[0, %g], [0.1, %g]], angle_deg: 1}]\n    duration: 0.05\n'
        steps = ''.join(fold % (0.01 * k, 0.01 * k) for k in range(1, 10))
        pictures, pages = self.draw('pages.yaml', text=SHEET + 'steps:\n' + steps)
        self.assertEqual(len(pictures), 10)
        self.assertEqual(pages, 2)  # of nine pictures


if __name__ == '__main__':
    unittest.main()
