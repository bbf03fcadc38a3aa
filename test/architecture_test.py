#!/usr/bin/python3
"""The house's rules: the order of the rooms, no include circle, one spelling of includes, and what is
allowed in one room alone."""
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SOURCE = os.path.join(ROOT, 'src', 'shell_origami')
# Each room includes itself and the rooms before it.
ORDER = ['base', 'mesh', 'sheet', 'fold_format', 'linear', 'energy', 'contact', 'dynamics', 'origami', 'node', 'rviz', 'tools']
ROS = re.compile(r'(ros|roscpp|tf2|tf2_ros|tf2_eigen|actionlib|rosbag|dynamic_reconfigure|'
                 r'diagnostic_updater|interactive_markers|rviz|\w+_msgs|\w+_srvs)/')
GENERATED = re.compile(r'shell_origami/[A-Z]\w*\.h$')  # a message, a service, an action or a configuration
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def sources(folder):
    """Yields each source's path below SOURCE with the (quote, path) of its includes."""
    for root, _, files in os.walk(os.path.join(SOURCE, folder)):
        for name in sorted(files):
            if name.endswith(('.h', '.cpp')):
                path = os.path.join(root, name)
                with open(path) as handle:
                    yield os.path.relpath(path, SOURCE), INCLUDE.findall(handle.read())


def own(include):
    """The included file of ours below SOURCE, or None."""
    prefix = 'shell_origami/'
    if include.startswith(prefix) and not GENERATED.match(include):
        return include[len(prefix):]
    return None


class ArchitectureTest(unittest.TestCase):
    def test_every_room_has_its_place(self):
        self.assertEqual(sorted(ORDER), sorted(os.listdir(SOURCE)))

    def test_rooms_include_only_those_before_them(self):
        seen = 0
        for depth, room in enumerate(ORDER):
            for path, includes in sources(room):
                for _, include in includes:
                    if own(include):
                        seen += 1
                        other = own(include).split('/')[0]
                        self.assertIn(other, ORDER, path)
                        self.assertLessEqual(ORDER.index(other), depth, '%s includes %s' % (path, include))
        self.assertGreater(seen, 100)

    def test_includes_have_one_spelling(self):
        for path, includes in sources(''):
            for quote, include in includes:
                self.assertEqual(quote, '<', '%s includes "%s"' % (path, include))
                if own(include):
                    self.assertTrue(os.path.isfile(os.path.join(SOURCE, own(include))),
                                    '%s includes %s' % (path, include))

    def test_no_include_circle(self):
        graph = {path: [own(include) for _, include in includes if own(include)]
                 for path, includes in sources('')}
        done = set()

        def visit(path, trail):
            self.assertNotIn(path, trail, 'circle: ' + ' -> '.join(trail + [path]))
            if path not in done:
                for other in graph[path]:
                    visit(other, trail + [path])
                done.add(path)

        for path in graph:
            visit(path, [])

    def test_no_ros_outside_node_and_the_plugin(self):
        for room in ORDER:
            if room == 'node':
                continue
            for path, includes in sources(room):
                if path.startswith('rviz/plugin/'):
                    continue
                for _, include in includes:
                    self.assertIsNone(ROS.match(include), '%s includes %s' % (path, include))
                    self.assertIsNone(GENERATED.match(include), '%s includes %s' % (path, include))

    def test_one_blas(self):
        """Others are slower and give other bits."""
        named = set()
        for path in ('package.xml', 'README.md', 'scripts/install_dependencies'):
            with open(os.path.join(ROOT, path)) as handle:
                named |= set(re.findall(r'libopenblas[\w-]*', handle.read()))
        self.assertEqual(named, {'libopenblas0-serial'})

    def test_libraries_stay_in_their_rooms(self):
        rooms = {'Q': 'rviz/plugin/', 'Ogre': 'rviz/plugin/', 'CGAL/': 'mesh/', 'cholmod': 'linear/cholesky.cpp', 'SuiteSparse': 'linear/', 'omp.h': 'linear/',
                 'yaml-cpp/': 'origami/', 'assimp/': 'origami/surface_file.cpp', 'tbb/': 'base/parallel.cpp',
                 'tinyxml2.h': 'fold_format/', 'rosbag/': 'node/record/'}
        for path, includes in sources(''):
            for _, include in includes:
                for library, room in rooms.items():
                    if include.startswith(library):
                        self.assertTrue(path.startswith(room), '%s includes %s' % (path, include))


if __name__ == '__main__':
    unittest.main()
