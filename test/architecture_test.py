#!/usr/bin/python3
"""The house's rules: no ROS outside src/node, and every folder includes only what stands above it."""
import os
import re
import unittest

SOURCE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'src')
ORDER = ['sheet', 'shell', 'dynamics', 'origami', 'node']
ROS = re.compile(r'(ros|roscpp|tf2|tf2_ros|tf2_eigen|actionlib|rosbag|dynamic_reconfigure|'
                 r'diagnostic_updater|interactive_markers|shell_origami|\w+_msgs|\w+_srvs)/')
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def sources(folder):
    for root, _, files in os.walk(os.path.join(SOURCE, folder)):
        for name in sorted(files):
            if name.endswith(('.h', '.cpp')):
                path = os.path.join(root, name)
                with open(path) as handle:
                    yield os.path.relpath(path, SOURCE), INCLUDE.findall(handle.read())


class ArchitectureTest(unittest.TestCase):
    def test_no_ros_header_outside_node(self):
        seen = 0
        for folder in os.listdir(SOURCE):
            if folder == 'node':
                continue
            for path, includes in sources(folder):
                seen += 1
                for include in includes:
                    self.assertIsNone(ROS.match(include), '%s includes %s' % (path, include))
        self.assertGreater(seen, 20)

    def test_dependencies_point_one_way(self):
        for depth, folder in enumerate(ORDER):
            for path, includes in sources(folder):
                for include in includes:
                    first = include.split('/')[0]
                    if first in ORDER:
                        self.assertLessEqual(ORDER.index(first), depth,
                                             '%s includes %s' % (path, include))

    def test_solver_and_triangulator_are_hidden(self):
        for folder in ORDER:
            for path, includes in sources(folder):
                for include in includes:
                    if include == 'cholmod.h':
                        self.assertEqual(path, 'dynamics/cholesky.cpp')
                    if include.startswith('CGAL/'):
                        self.assertTrue(path.startswith('sheet/') and path.endswith('.cpp'), path)


if __name__ == '__main__':
    unittest.main()
