#!/usr/bin/python3
"""~load puts another paper in the place of this one; ~reset then gives that one again."""

import os
import shutil
import tempfile

import rospy
import rostest

from origami_client import NodeTest, line

STEP = 1.0 / 60
SQUARE = """{"vertices_coords": [[0, 0], [2, 0], [2, 2], [0, 2]], "faces_vertices": [[0, 1, 2, 3]],
"edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0]], "edges_assignment": ["B", "B", "B", "B"]}"""
RECIPE = """
sheet: {size: [0.1, 0.05], max_edge: 0.02}
material: {thickness: 2.0e-4}
steps:
  - fold: [{line: [[0.05, 0], [0.05, 0.05]], angle_deg: 90}]
"""


class LoadTest(NodeTest):
    def setUp(self):
        super(LoadTest, self).setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.recipe = os.path.join(self.folder, 'recipe.yaml')
        with open(self.recipe, 'w') as recipe:
            recipe.write(RECIPE)

    def assertExtent(self, width, height):
        flat = self.origami.sheet().flat_positions
        self.assertAlmostEqual(max(p.x for p in flat), width, delta=1e-6)
        self.assertAlmostEqual(max(p.y for p in flat), height, delta=1e-6)

    def test_a_saved_paper(self):
        self.origami.do('load', path=self.recipe)
        self.origami.do('fold', line=line(0, 0, 0.05, 0.05), angle=1.5, duration=0.1)
        self.origami.do('step', steps=40)
        before = self.origami.sheet()
        path = os.path.join(self.folder, 'paper.fold')
        self.origami.do('save', path=path)
        loaded = self.origami.do('load', path=path)
        after = self.origami.sheet()
        self.assertGreater(loaded.revision, before.revision)
        self.assertEqual(loaded.revision, after.revision)
        self.assertEqual(list(loaded.creases), [crease.name for crease in before.creases])
        self.assertEqual(loaded.vertices, len(after.flat_positions))
        self.assertEqual(loaded.triangles, len(after.triangles))
        self.assertExtent(0.1, 0.05)

    def test_the_sheet_of_a_recipe(self):
        time = self.origami.do('step', steps=1).time
        loaded = self.origami.do('load', path=self.recipe)
        self.assertEqual(loaded.vertices, len(self.origami.sheet().flat_positions))
        self.assertExtent(0.1, 0.05)
        edit = self.origami.last_edit('load')
        self.assertEqual((edit.path, edit.number), (self.recipe, loaded.edit))
        later = self.origami.do('step', steps=10).time
        self.assertAlmostEqual(later, time + 10 * STEP, delta=1e-9)
        self.assertEqual(len(self.origami.state().creases), 0, 'its steps are not run')

    def test_a_file_without_a_unit_needs_a_scale(self):
        path = os.path.join(self.folder, 'square.fold')
        with open(path, 'w') as file:
            file.write(SQUARE)
        refused = self.origami.call('load', path=path)
        self.assertFalse(refused.success)
        self.assertIn('scale', refused.message)
        loaded = self.origami.do('load', path=path, scale=0.06)
        self.assertGreater(loaded.triangles, 2)
        self.assertExtent(0.12, 0.12)

    def test_a_drawing_says_what_was_changed_to_read_it(self):
        path = os.path.join(self.folder, 'square.cp')
        with open(path, 'w') as file:
            file.write('1 -1 -1 1 -1\n1 1 -1 1 1\n1 1 1 -1 1\n1 -1 1 -1 -1\n2 -1 -1 1 1\n3 -1 1 1 -1\n')
        loaded = self.origami.do('load', path=path, scale=0.05)
        self.assertEqual(len(loaded.creases), 2)
        self.assertTrue(loaded.message.endswith(
            '; 2 edges were divided at crossings and at points of others'), loaded.message)
        self.assertExtent(0.1, 0.1)
        with open(path, 'w') as file:
            file.write('1 -1 -1 1 nan\n')
        refused = self.origami.call('load', path=path, scale=0.05)
        self.assertIn("square.cp: line 1 holds 'nan', not a finite number", refused.message)

    def test_a_path_may_begin_at_home(self):
        name = os.path.basename(tempfile.mkdtemp(dir=os.path.expanduser('~')))
        folder = os.path.join(os.path.expanduser('~'), name)
        self.addCleanup(shutil.rmtree, folder)
        self.origami.do('save', path='~/%s/paper.fold' % name)
        self.assertEqual(os.listdir(folder), ['paper.fold'])
        self.origami.do('load', path='~/%s/paper.fold' % name)

    def test_reset_gives_the_loaded_paper(self):
        loaded = self.origami.do('load', path=self.recipe)
        self.origami.do('fold', line=line(0.05, 0, 0.05, 0.05), angle=1)
        self.origami.do('step', steps=5)
        self.origami.do('reset')
        state = self.origami.state()
        self.assertEqual((len(state.positions), len(state.creases)), (loaded.vertices, 0))
        self.assertEqual(max(abs(p.z) for p in state.positions), 0)
        self.assertGreater(state.revision, loaded.revision + 1)


if __name__ == '__main__':
    rospy.init_node('load_test')
    rostest.rosrun('shell_origami', 'load_test', LoadTest)
