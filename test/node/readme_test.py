#!/usr/bin/python3
"""The rosservice lines of README.md, doc/folding.md and doc/tutorial.md run as they stand."""

import os
import re
import subprocess
import tempfile

import rospy
import rostest

from origami_client import NodeTest

ROOT = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..')
# A request may go on over several lines.
COMMAND = re.compile(r'^(?:rosservice call [^"\n]*(?:"[^"]*")?|sleep \d+)$', re.MULTILINE)


class ReadmeTest(NodeTest):
    def run_lines_of(self, page):
        """The services that were called."""
        with open(os.path.join(ROOT, page)) as text:
            commands = COMMAND.findall(text.read())
        self.origami.do('resume')
        called = set()
        for command in commands:
            answer = subprocess.run(command, shell=True, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, universal_newlines=True)
            if command.startswith('sleep'):
                continue
            self.assertIn('success: True', answer.stdout, '%s\n%s' % (command, answer.stdout))
            called.add(re.match(r'rosservice call /origami/(\w+)', command).group(1))
        return called

    def test_every_line_of_the_readme_succeeds(self):
        self.assertEqual(self.run_lines_of('README.md'),
                         {'fold', 'pin', 'unpin', 'add_vertex', 'load', 'save', 'step', 'pause', 'resume',
                          'reset', 'settle'})

    def test_every_line_about_folding_succeeds(self):
        self.assertEqual(self.run_lines_of('doc/folding.md'),
                         {'fold_through', 'layers', 'turn_over', 'undo', 'reset'})

    def test_every_line_of_the_tutorial_succeeds(self):
        # The other pages leave papers of their own, to which a reset would return.
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as recipe:
            recipe.write('sheet: {size: [0.15, 0.15], max_edge: 0.01}\nsteps: []\n')
            recipe.flush()
            self.origami.do('load', path=recipe.name)
        self.assertEqual(self.run_lines_of('doc/tutorial.md'), {'reset', 'resume', 'fold_through', 'undo'})


if __name__ == '__main__':
    rospy.init_node('readme_test')
    rostest.rosrun('shell_origami', 'readme_test', ReadmeTest)
