"""What the node tests share: the node's services as functions, and its latest messages."""

import math
import os
import threading
import time
import unittest
import xmlrpc.client

import rosnode
import rospy
from geometry_msgs.msg import Point
from std_srvs.srv import Trigger

from shell_origami import msg, srv

# Debian 11's rospy still asks threads by this name as it ends, which its Python no longer knows.
if not hasattr(threading.Thread, 'isAlive'):
    threading.Thread.isAlive = threading.Thread.is_alive

SERVICES = {
    'fold': srv.Fold, 'pin': srv.Pin, 'unpin': srv.Unpin, 'add_vertex': srv.AddVertex,
    'load': srv.Load, 'save': srv.Save, 'step': srv.Step,
    'settle': Trigger, 'pause': Trigger, 'resume': Trigger, 'reset': Trigger,
}


class Recorder(object):
    """Every message of a topic."""

    def __init__(self, topic, kind):
        self.messages = []
        self.news = threading.Condition()
        self.subscriber = rospy.Subscriber(topic, kind, self._hear, queue_size=1000)

    def _hear(self, message):
        with self.news:
            self.messages.append(message)
            self.news.notify_all()

    def all(self):
        with self.news:
            return list(self.messages)

    def forget(self):
        with self.news:
            self.messages.clear()

    def wait(self, wanted=lambda message: True, since=0, timeout=10):
        """The first message from index `since` on that is wanted."""
        deadline = time.time() + timeout
        with self.news:
            while True:
                for message in self.messages[since:]:
                    if wanted(message):
                        return message
                since = len(self.messages)
                if time.time() > deadline:
                    raise AssertionError('no such message within %g s' % timeout)
                self.news.wait(0.05)


class Origami(object):
    def __init__(self, name='/origami'):
        self.name = name
        self.services = {}
        for service, kind in SERVICES.items():
            rospy.wait_for_service(name + '/' + service, 20)
            self.services[service] = rospy.ServiceProxy(name + '/' + service, kind)
        self.sheets = Recorder(name + '/sheet', msg.Sheet)
        self.states = Recorder(name + '/state', msg.SheetState)
        self.edits = Recorder(name + '/edits', msg.Edit)
        self.states.wait()

    def call(self, service, **fields):
        return self.services[service](**fields)

    def do(self, service, **fields):
        """Calls a service that must succeed."""
        response = self.call(service, **fields)
        if not response.success:
            raise AssertionError('%s was refused: %s' % (service, response.message))
        return response

    def state(self):
        """The state as it is after every request answered so far. Pauses the node."""
        now = rospy.Time.now()
        self.do('pause')  # which publishes
        return self.states.wait(lambda state: state.header.stamp >= now)

    def sheet(self):
        revision = self.state().revision
        return self.sheets.wait(lambda sheet: sheet.revision == revision)

    def last_edit(self, kind):
        """The last edit so far, which must be of this kind."""
        self.state()
        return self.edits.wait(lambda edit: edit.kind == kind and edit is self.edits.messages[-1])

    def memory(self):
        """What the node keeps resident [bytes]."""
        node_api = rospy.get_master().lookupNode(self.name)[2]
        _, _, pid = xmlrpc.client.ServerProxy(node_api).getPid('/test')
        with open('/proc/%d/statm' % pid) as statm:
            return int(statm.read().split()[1]) * os.sysconf('SC_PAGE_SIZE')

    def alive(self):
        return rosnode.rosnode_ping(self.name, max_count=1, verbose=False)


def line(x0, y0, x1, y1):
    return [Point(x0, y0, 0), Point(x1, y1, 0)]


def distance(p, q):
    return math.sqrt((p.x - q.x) ** 2 + (p.y - q.y) ** 2 + (p.z - q.z) ** 2)


class NodeTest(unittest.TestCase):
    """Starts each test on the paper as it was loaded, paused, and ends it with a living node."""

    @classmethod
    def setUpClass(cls):
        cls.origami = Origami()

    def setUp(self):
        self.origami.do('pause')
        self.origami.do('reset')

    def tearDown(self):
        self.assertTrue(self.origami.alive(), 'the node died')
