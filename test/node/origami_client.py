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
from tf2_msgs.msg import TFMessage

import shell_origami
from shell_origami import msg

def wait_until(condition, what, timeout=20, period=0.02):
    """Returns the first true value of `condition()`. `what` is awaited, in words: a text, or a
    function that returns one in the end."""
    deadline = time.time() + timeout
    while True:
        value = condition()
        if value:
            return value
        if time.time() > deadline:
            raise AssertionError('within %g s never: %s' % (timeout, what() if callable(what) else what))
        time.sleep(period)


def repeat(action, period):
    """Does it again and again in a thread of its own, until the test ends."""
    def run():
        while not rospy.is_shutdown():
            action()
            time.sleep(period)
    threading.Thread(target=run, daemon=True).start()


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
                    raise AssertionError('no such message on %s within %g s, and %d others' %
                                         (self.subscriber.name, timeout, len(self.messages)))
                self.news.wait(0.05)


class Origami(shell_origami.Origami):
    """The client of the package, and every message of the node."""

    def __init__(self, name='/origami'):
        super(Origami, self).__init__(name, timeout=20)
        self.sheets = Recorder(self.name + '/sheet', msg.Sheet)
        self.states = Recorder(self.name + '/state', msg.SheetState)
        self.edits = Recorder(self.name + '/edits', msg.Edit)
        self.states.wait()

    def call(self, service, **fields):
        """Returns the answer of a service, be it a rejection."""
        return self.services[service](**fields)

    do = shell_origami.Origami.request

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

    def pass_steps(self, count):
        """Waits until the node, which must be running, has taken so many more steps."""
        start = self.states.wait(since=len(self.states.all())).step
        self.states.wait(lambda state: state.step >= start + count, timeout=20)

    def stand_still(self):
        """Waits while a paused node publishes twice: what has changed, and half a second later the
        same again. One that ran would take steps from one to the other."""
        for _ in range(2):
            self.states.wait(since=len(self.states.all()))

    def edits_since(self, number):
        """Every edit after the one of this number. Pauses the node."""
        last = self.state().edits
        if last > number:
            self.edits.wait(lambda edit: edit.number == last)  # they arrive in order
        return [edit for edit in self.edits.all() if edit.number > number]

    def api(self):
        return xmlrpc.client.ServerProxy(rospy.get_master().lookupNode(self.name)[2])

    def wait_for_listener(self, node, topics):
        """Waits until a node whose name begins so is connected to these topics of this one."""
        def connected():
            _, _, connections = self.api().getBusInfo('/test')
            return {topic for _, other, way, _, topic, *_ in connections
                    if way == 'o' and other.startswith(node)}
        wait_until(lambda: connected().issuperset(topics), '%s hears %s' % (node, topics))

    def memory(self):
        """What the node keeps resident [bytes]."""
        _, _, pid = self.api().getPid('/test')
        with open('/proc/%d/statm' % pid) as statm:
            return int(statm.read().split()[1]) * os.sysconf('SC_PAGE_SIZE')

    def alive(self):
        return rosnode.rosnode_ping(self.name, max_count=1, verbose=False)


def wait_for_transform(wanted):
    """Waits until the node has heard a transform that is sent again and again: it hears it about when
    this test does, and by the second time for sure."""
    frames = Recorder('/tf', TFMessage)
    for _ in range(2):
        frames.wait(lambda m: any(wanted(t) for t in m.transforms), since=len(frames.all()))
    frames.subscriber.unregister()


def wait_for_panels():
    """Waits until a paused node, which sends them itself, knows the panels' frames as they are."""
    wait_for_transform(lambda t: t.child_frame_id.startswith('panel_'))


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
