#!/usr/bin/python3
"""A bad parameter stops the start with one sentence that names it and its value."""

import signal
import subprocess
import unittest

import roslib.packages
import rospy
import rostest

NAME = '/refused'

# Parameter, value, and words that the sentence must hold.
REFUSALS = [
    ('sheet/width', -0.1, ['sheet/width', '-0.1']),
    ('sheet/height', 0, ['sheet/height', '0']),
    ('sheet/max_edge', float('nan'), ['sheet/max_edge', 'nan']),
    ('sheet/max_edge', 1e-6, ['1e-06']),
    ('material/thickness', 'thin', ['material/thickness', 'thin', 'number']),
    ('material/thickness', '1e-4', ['material/thickness', '1.0e-4']),
    ('material/thickness', -1, ['material/thickness', '-1']),
    ('material/youngs_modulus', 0.0, ['material/youngs_modulus', '0']),
    ('material/poisson_ratio', 0.5, ['material/poisson_ratio', '0.5']),
    ('material/density', float('inf'), ['material/density', 'inf', 'finite']),
    ('material/crease_stiffness', -1.0, ['material/crease_stiffness', '-1']),
    ('material/air_damping', -1.0, ['material/air_damping', '-1']),
    ('material/membrane', 'rubber', ['material/membrane', 'rubber', 'st_venant_kirchhoff']),
    ('material/crease_height_term', 'no', ['material/crease_height_term', 'true or false']),
    ('material/yield_curvature', -1.0, ['material/yield_curvature', '-1']),
    ('material/hardening', -1.0, ['material/hardening', '-1']),
    ('material/youngs_modulsu', 2e9, ['material/youngs_modulsu']),
    ('material', 5, ['~material', '5']),
    ('gravity', -9.81, ['gravity', '-9.81', 'three']),
    ('gravity', [0, 0], ['gravity', 'three']),
    ('gravity', [0, 0, 'down'], ['gravity', 'down']),
    ('gravity', [0, 0, -2e4], ['gravity', '[0, 0, -20000]', 'from -10000 to 10000']),
    ('solver/integrator', 'runge_kutta', ['solver/integrator', 'runge_kutta', 'newmark']),
    ('solver/time_step', 0, ['solver/time_step', '0']),
    ('solver/tolerance', -1e-3, ['solver/tolerance', '-0.001', '> 0 and finite']),
    ('solver/max_iterations', 2.5, ['solver/max_iterations', '2.5', 'integer']),
    ('solver/max_iterations', 0, ['solver/max_iterations', '0']),
    ('solver/threads', -1, ['solver/threads', '-1', 'from 0 to 1024']),
    ('solver/threads', 1.5, ['solver/threads', '1.5', 'integer']),
    ('fold_duration', -1, ['fold_duration', '-1']),
    ('publish_rate', 0, ['publish_rate', '0']),
    ('world_frame', '', ['world_frame']),
    ('world_frame', '/world', ['world_frame', '/world']),
    ('world_frame', 'paper', ['world_frame', '"paper"', 'own frames']),
    ('world_frame', 'panel_0', ['world_frame', '"panel_0"', 'own frames']),
    ('frame_prefix', '/left', ['frame_prefix', '/left', 'slash']),
    ('diagnostic_period', 0, ['diagnostic_period', '0', 'from 0.1 to 1e6']),
    ('paused', 'yes', ['paused', 'yes', 'true or false']),
    ('colouring', 'rainbow', ['colouring', 'rainbow', 'contact or curvature or paper or strain']),
    ('cloud/points', 1, ['cloud/points', '1', 'from 2 to 1e6']),
    ('depth/frame', '', ['depth/frame', 'without a leading slash']),
    ('depth/frame', '/camera', ['depth/frame', '/camera', 'slash']),
    ('depth/width', 4097, ['depth/width', '4097']),
    ('depth/rate', 0, ['depth/rate', '0', 'from 0.01 to 100']),
    ('depth/near', 10, ['depth/near', '10', 'less than depth/far']),
    ('clock', 'sundial', ['clock', 'sundial', 'follow or lead']),
    ('clock', 'lead', ['clock', 'lead', 'use_sim_time']),
    ('real_time_factor', -1, ['real_time_factor', '-1']),
    ('recipe', 'no_such_recipe', ['recipe', 'no_such_recipe']),
    ('speed', 3, ['speed']),
]


class ParametersTest(unittest.TestCase):
    def start(self, program='origami_node'):
        program = roslib.packages.find_node('shell_origami', program)[0]
        return subprocess.Popen([program, '__name:=' + NAME[1:]], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True)

    def refused(self, refusals, program):
        wrong = []
        for parameter, value, words in refusals:
            rospy.set_param(NAME + '/' + parameter, value)
            node = self.start(program)
            try:
                said, _ = node.communicate(timeout=5)
            except subprocess.TimeoutExpired:
                node.kill()
                said, _ = node.communicate()
            rospy.delete_param(NAME)
            fatal = [text for text in said.splitlines() if 'FATAL' in text]
            if (node.returncode != 1 or len(fatal) != 1 or
                    not all(word in fatal[0] for word in words)):
                wrong.append('%s = %s: %s' % (parameter, value, said))
        self.assertEqual(wrong, [])

    def test_bad_values_stop_the_start(self):
        self.refused(REFUSALS, 'origami_node')

    def test_what_draws_a_recording_refuses_as_the_node_does(self):
        self.refused([('colouring', 'rainbow', ['colouring', 'rainbow', 'strain']),
                      ('colouring', 1, ['colouring', '1', 'string']),
                      ('vertex_ids', 'yes', ['vertex_ids', 'yes', 'true or false']),
                      ('gravity', [0, 0, 0], ['gravity'])], 'origami_markers')

    def test_integers_do_for_numbers(self):
        rospy.set_param(NAME, {'material': {'density': 800}, 'gravity': [0, 0, -10],
                               'solver': {'max_iterations': 20.0},
                               # Of diagnostic_updater, in whose name it is often set.
                               'diagnostic_period': 2, 'world_frame': 'panel_beater'})
        node = self.start()
        rospy.wait_for_service(NAME + '/step', 10)
        node.send_signal(signal.SIGINT)
        said, _ = node.communicate(timeout=10)
        rospy.delete_param(NAME)
        self.assertEqual(node.returncode, 0, said)


if __name__ == '__main__':
    rospy.init_node('parameters_test')
    rostest.rosrun('shell_origami', 'parameters_test', ParametersTest)
