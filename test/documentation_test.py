#!/usr/bin/python3
"""The pages agree with the tree: names and paths of doc/architecture.md and CONTRIBUTING.md exist, the
table of the former lists every folder, README's C++ example is the program that test/install_test
builds."""
import os
import re
import unittest

from architecture_test import ORDER, ROOT

SOURCE = 'src/shell_origami/'
# Extensions of the files in which names are looked for.
CODE = ('.h', '.cpp', '.py', '.msg', '.srv', '.action', '.cfg', '.yaml', '.launch', '.txt')
# Folders that builds and runs make.
PRODUCTS = ('build', 'out', '__pycache__')
# In backticks, but neither a name of the code nor a path.
OTHERS = {'<shell_origami/room/file.h>', 'build/', 'rosrun', 'c', 'u', 'c/2 u^2', 'k = B/6',
          'test/<room>/*_test.cpp', 'test/node/*.test', '*_test.py', '--write', 'kCamelCase',
          'clang-format -i FILE', 'void verifyName(VerificationReport& report)',
          'CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache'}
# Targets and tests that CMakeLists.txt names by a loop.
MADE = {'sheet_test', 'acceptance_test'}


def read(path):
    with open(os.path.join(ROOT, path), encoding='utf-8') as file:
        return file.read()


def source_files():
    """Paths below the root, without hidden folders and those of builds and results."""
    paths = []
    for root, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if name[0] != '.' and name not in PRODUCTS]
        paths += [os.path.relpath(os.path.join(root, name), ROOT) for name in files]
    return paths


def is_path(name):
    return name.endswith('/') or re.search(r'\.(h|cpp|py|msg|yaml|launch|md|test)$', name) or \
        name.startswith(('scripts/', 'test/', '.'))


class DocumentationTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = source_files()
        cls.folders = {os.path.dirname(path) + '/' for path in cls.files}
        cls.text = '\n'.join(read(path) for path in cls.files
                             if path != os.path.relpath(__file__, ROOT) and
                             (path.endswith(CODE) or path.startswith(('nodes/', 'scripts/'))))
        cls.headers = [read(path) for path in cls.files if path.endswith('.h')]
        cls.words = set(re.findall(r'\w+', cls.text))

    def path_exists(self, name):
        """Whether there is such a folder below the root or the rooms, or a file whose path ends so."""
        if name.endswith('/'):
            return any(folder.startswith((name, SOURCE + name)) for folder in self.folders)
        return any(path == name or path.endswith('/' + name) for path in self.files)

    def name_exists(self, name):
        """Whether the sources have it: a topic or service, a member of a class, or another name."""
        if name.startswith('~'):
            return '"%s"' % name[1:] in self.text
        if name.endswith('()') or re.match(r'\w+\.\w+$', name):
            return re.search(r'\b%s\(' % name.split('.')[-1].rstrip('()'), self.text)
        if '::' in name:
            pattern = r'(class|enum class) %s\b.*\b%s\b' % tuple(name.split('::'))
            return any(re.search(pattern, header, re.DOTALL) for header in self.headers)
        return name in self.words or re.search(r'\b%s\b' % re.escape(name), self.text)

    def test_names_and_paths_exist(self):
        for page, least in (('doc/architecture.md', 80), ('CONTRIBUTING.md', 40)):
            prose = re.sub(r'^```.*?^```$', '', read(page), flags=re.MULTILINE | re.DOTALL)
            names = set(re.findall(r'`([^`\n]+)`', prose)) - OTHERS - MADE
            self.assertGreater(len(names), least)
            for name in sorted(names):
                if name.startswith('rosservice call'):
                    continue  # test/node/readme_test.py calls it
                found = self.path_exists(name) if is_path(name) else self.name_exists(name)
                self.assertTrue(found, '`%s` of %s does not exist' % (name, page))

    def test_the_table_lists_every_folder(self):
        cells = re.findall(r'^\| (`[^|]*) \|', read('doc/architecture.md'), re.MULTILINE)
        listed = [folder for cell in cells for folder in re.findall(r'`([^`]+)/`', cell)]
        rooms = [folder for folder in listed if folder in ORDER]
        self.assertEqual(rooms, ORDER, 'the order of test/architecture_test.py')
        top = {path.split('/')[0] for path in self.files if '/' in path and not path.startswith('.')}
        self.assertEqual(top - {'src'} - set(listed), set())

    def test_the_readme_shows_the_program_that_is_built(self):
        example, = re.findall(r'^```cpp\n(.*?)^```$', read('README.md'), re.MULTILINE | re.DOTALL)
        self.assertEqual(example, read('test/consumer/fold_a_sheet.cpp'))


if __name__ == '__main__':
    unittest.main()
