#!/usr/bin/python3
"""The README's rosservice lines run as they stand."""

import os
import re
import subprocess

import rospy
import rostest

from origami_client import NodeTest

README = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'README.md')
SERVICES = {'fold', 'pin', 'unpin', 'add_vertex', 'load', 'save', 'step', 'pause', 'resume', 'reset',
            'settle'}


class ReadmeTest(NodeTest):
    def test_every_line_succeeds(self):
        with open(README) as readme:
            lines = re.findall(r'^rosservice call .*$', readme.read(), re.MULTILINE)
        called = set()
        for command in lines:
            answer = subprocess.run(command, shell=True, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, universal_newlines=True)
            self.assertIn('success: True', answer.stdout, '%s\n%s' % (command, answer.stdout))
            called.add(re.match(r'rosservice call /origami/(\w+)', command).group(1))
        self.assertEqual(called, SERVICES)


if __name__ == '__main__':
    rospy.init_node('readme_test')
    rostest.rosrun('shell_origami', 'readme_test', ReadmeTest)
