#!/usr/bin/python3
"""doc/reference.md and config/origami.yaml name every topic, service, action and parameter that there
is, with the types, defaults and bounds that the nodes have. (That both say what the table of parameters
says is tested by parameter_table_test.cpp.)"""

import glob
import multiprocessing.pool
import os
import re
import signal
import subprocess
import unittest

import roslib.packages
import rosgraph
import rospy
import rosservice
import rostest
import yaml
from dynamic_reconfigure.client import Client
from dynamic_reconfigure.msg import ConfigDescription
from visualization_msgs.msg import MarkerArray

import reference
from origami_client import Origami, Recorder, wait_until
from shell_origami.msg import SheetState

TABLES = reference.tables()
PARAMETERS = TABLES['Parameters of origami_node']
# What roscpp gives every node.
OF_EVERY_NODE = ('/rosout', '~get_loggers', '~set_logger_level')
ACTION = {'goal': 'in', 'cancel': 'in', 'status': 'out', 'feedback': 'out', 'result': 'out'}
LIVE = [('~live/parameter_descriptions', 'dynamic_reconfigure/ConfigDescription', 'out'),
        ('~live/parameter_updates', 'dynamic_reconfigure/Config', 'out')]
JUST_ABOVE_ZERO = 1e-6


def full(kind):
    return kind if '/' in kind else 'shell_origami/' + kind


def topics_of(section):
    return {(name, full(reference.names(row['type'])[0]), row['way'])
            for row in TABLES[section] if 'topic' in row for name in reference.names(row['topic'])}


def topics_of_actions():
    result = set()
    for row in TABLES['Actions of origami_node']:
        (name,), (kind,) = reference.names(row['action']), reference.names(row['type'])
        for part, way in ACTION.items():
            part_type = {'cancel': 'actionlib_msgs/GoalID', 'status': 'actionlib_msgs/GoalStatusArray'}
            of_kind = full(kind) + 'Action' + part.capitalize()
            result.add((name + '/' + part, part_type.get(part, of_kind), way))
    return result


class Master(object):
    """What nodes have registered, with ~ for their name."""

    def __init__(self):
        master = rosgraph.Master(rospy.get_name())
        self.published, self.subscribed, self.served = master.getSystemState()
        self.types = dict(master.getTopicTypes())

    @staticmethod
    def own(name, node):
        name = '~' + name[len(node) + 1:] if name.startswith(node + '/') else name
        name = name.replace('~wrench/stone', '~wrench/<id>')
        return re.sub('^~wrench/[^<]*$', '~wrench/<frame>', name)

    def of(self, registered, node):
        return {(self.own(name, node), name) for name, nodes in registered if node in nodes
                if self.own(name, node) not in OF_EVERY_NODE}

    def topics(self, node):
        return {(own, self.types[name], way)
                for way, registered in (('out', self.published), ('in', self.subscribed))
                for own, name in self.of(registered, node)}

    def services(self, node):
        return {(own, rosservice.get_service_type(name)) for own, name in self.of(self.served, node)}


def start(name, parameters):
    """A node with these parameters."""
    rospy.set_param(name, parameters)
    program = roslib.packages.find_node('shell_origami', 'origami_node')[0]
    return subprocess.Popen([program, '__name:=' + name[1:]], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, universal_newlines=True)


def refusal(name, parameters):
    """The sentence with which a node refuses these parameters."""
    node = start(name, parameters)
    try:
        said, _ = node.communicate(timeout=20)
    except subprocess.TimeoutExpired:
        node.kill()
        said, _ = node.communicate()
    fatal = re.findall(r'\[FATAL\].*?: ([^\x1b\n]*)', said)
    return fatal[0] if node.returncode == 1 and len(fatal) == 1 else 'not refused: ' + said


def in_parallel(function, values):
    with multiprocessing.pool.ThreadPool(4) as pool:
        return pool.map(function, values)


def nested(name, value):
    """{'material': {'density': value}} for material/density."""
    for word in reversed(name.split('/')):
        value = {word: value}
    return value


def merge(trees):
    result = {}
    for tree in trees:
        for name, value in tree.items():
            is_folder = isinstance(value, dict)
            result[name] = merge([result.get(name, {}), value]) if is_folder else value
    return result


def just_outside(row):
    """[(name, parameters that set it just out of bounds)]"""
    bounds, default = reference.bounds(row), yaml.safe_load(row['default'].strip('`'))
    (name,) = reference.names(row['parameter'])

    def step(bound):
        return 1 if isinstance(default, int) else 1e-6 * abs(bound) or 1e-9
    values = [bounds.low - step(bounds.low) if bounds.low_is_inside else bounds.low]
    if bounds.high < reference.INFINITY:
        values.append(bounds.high + step(bounds.high))
    if name == 'gravity':
        values = [[value if i == place else 0.0 for i in range(3)]
                  for value in values for place in range(3)]
    return [(name, nested(name, value)) for value in values]


class ReferenceTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.origami, cls.manual = Origami('/origami'), Origami('/manual')
        cls.numbers = [row for row in PARAMETERS if reference.bounds(row)]

    def test_topics(self):
        self.origami.do('pin', vertices=[0])
        self.origami.add_obstacle('stone', sphere=0.01, position=(5, 5, 5))
        clock = ('/clock', 'rosgraph_msgs/Clock', 'out')
        of_origami = topics_of('Topics of origami_node') | topics_of_actions() | set(LIVE)
        wanted = {'/origami': of_origami - {clock}, '/markers': topics_of('origami_markers'),
                  '/hand': topics_of('hand')}

        def differences():
            found = Master()
            return {node: found.topics(node) ^ wanted[node] for node in wanted
                    if found.topics(node) != wanted[node]}
        # A wrench and a hand come a little later.
        wait_until(lambda: not differences(), lambda: 'topics as documented, but for %s' % differences())
        self.assertIn(clock, Master().topics('/leader'))

    def test_services(self):
        wanted = {(reference.names(row['service'])[0], full(reference.names(row['type'])[0]))
                  for row in TABLES['Services of origami_node']}
        wanted.add(('~live/set_parameters', 'dynamic_reconfigure/Reconfigure'))
        found = Master()
        self.assertEqual(found.services('/origami'), wanted)
        self.assertEqual(found.services('/markers') | found.services('/hand'), set())

    def test_programs(self):
        installed = re.findall(r'install\(TARGETS ([^)]*?)\s+RUNTIME', reference.read('CMakeLists.txt'))
        programs = set(' '.join(installed).split()) | set(os.listdir(os.path.join(reference.ROOT, 'nodes')))
        self.assertEqual({reference.names(row['program'])[0] for row in TABLES['Programs']}, programs)

    def test_every_field_of_a_message_is_explained(self):
        silent, seen = [], 0
        for kind in ('msg', 'srv', 'action'):
            for path in glob.glob(os.path.join(reference.ROOT, kind, '*')):
                for text in reference.read(path).split('\n'):
                    field = text.strip() and not text.startswith(('#', '---')) and '=' not in text
                    seen += bool(field)
                    if field and not re.search(r'#.*\w', text):
                        silent.append('%s: %s' % (os.path.basename(path), text))
        self.assertEqual(silent, [])
        self.assertGreater(seen, 80)

    def test_defaults_are_those_of_a_node_without_parameters(self):
        manual = reference.manual()
        # Neither paused nor waiting for a recorder.
        self.assertFalse(manual['paused'] or manual['wait_for_recorder'])
        Recorder('/leader/state', SheetState).wait(lambda state: state.step > 0)
        papers, drawings, lives = [], [], []
        for node in (self.origami, self.manual):
            markers = Recorder(node.name + '/markers', MarkerArray)
            node.do('reset')
            # The whole paper holds the configuration of its simulation.
            papers.append(node.last_edit('reset').paper)
            drawings.append([(m.ns, m.header.frame_id, m.action, m.scale, m.color, m.colors)
                             for m in markers.wait().markers])
            lives.append(Client(node.name + '/live', timeout=10).get_configuration(timeout=10))
        self.assertEqual(papers[0], papers[1])
        self.assertEqual(drawings[0], drawings[1])
        for config in lives:
            config.pop('groups')
        self.assertEqual(lives[0], lives[1])
        # What shows in files alone.
        code = reference.read('src', 'shell_origami', 'node', 'parameters.h')
        for field, name in (('recipe', 'recipe'), ('output', 'output'), ('checkpoint', 'checkpoint/file')):
            self.assertEqual(manual[name], '')
            self.assertIn('std::string %s;' % field, code)
        self.assertIn('double checkpoint_period = %g;' % manual['checkpoint/period'], code)

    def test_just_out_of_bounds_is_refused(self):
        tried = [pair for row in self.numbers for pair in just_outside(row)]
        self.assertGreater(len(tried), 30)

        def refused(numbered):
            number, (name, parameters) = numbered
            said = refusal('/outside_%d' % number, parameters)
            return None if re.search(r'~%s\b' % name, said) else '%s: %s' % (parameters, said)
        self.assertEqual([wrong for wrong in in_parallel(refused, enumerate(tried)) if wrong], [])

    def test_just_inside_is_accepted(self):
        """All at once, lower bounds and then upper ones: one that is refused stops the start."""
        lower, upper = [{'paused': True}], [{'paused': True}]
        for row in self.numbers:
            (name,), bounds = reference.names(row['parameter']), reference.bounds(row)
            lowest = bounds.low if bounds.low_is_inside else JUST_ABOVE_ZERO
            for trees, value in ((lower, lowest), (upper, bounds.high)):
                if value < reference.INFINITY:
                    trees.append(nested(name, 3 * [value] if name == 'gravity' else value))
        for name, parameters in (('/lower', merge(lower)), ('/upper', merge(upper))):
            node = start(name, parameters)
            try:
                rospy.wait_for_service(name + '/step', 10)
            except rospy.ROSException:
                pass
            node.send_signal(signal.SIGINT)
            said, _ = node.communicate(timeout=10)
            self.assertEqual(node.returncode, 0, '%s: %s' % (parameters, said))

    def test_words_to_choose_from(self):
        rows = [row for row in PARAMETERS if reference.choices(row)]
        self.assertGreater(len(rows), 5)

        def offered(row):
            (name,) = reference.names(row['parameter'])
            said = refusal('/chooses_' + name.replace('/', '_'), nested(name, 'nothing_of_these'))
            return sorted(said.split('must be ')[-1].split(' or '))
        for row, words in zip(rows, in_parallel(offered, rows)):
            self.assertEqual(words, sorted(reference.choices(row)), row['parameter'])

    def test_bounds_of_what_is_live(self):
        wanted = {}
        for row in PARAMETERS:
            for name in reference.names(row['live']):
                wanted[name] = reference.bounds(row)
        told = Recorder('/origami/live/parameter_descriptions', ConfigDescription)
        description = told.wait(lambda m: any(v.value == 1e4 for v in m.max.doubles))
        low = {v.name: v.value for v in description.min.doubles}
        high = {v.name: v.value for v in description.max.doubles}
        self.assertEqual({name: (low[name], high[name]) for name in low},
                         {name: (b.low, b.high) for name, b in wanted.items() if b})
        self.assertEqual({v.name for v in description.dflt.doubles + description.dflt.bools + description.dflt.strs},
                         set(wanted))


if __name__ == '__main__':
    rospy.init_node('reference_test')
    rostest.rosrun('shell_origami', 'reference_test', ReferenceTest)
