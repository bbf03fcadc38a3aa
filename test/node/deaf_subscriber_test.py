#!/usr/bin/python3
"""Subscribers that never read cost the node neither pace nor memory, and nobody else a message."""

import socket
import struct
import xmlrpc.client

import rospy
import rostest
from visualization_msgs.msg import MarkerArray

from origami_client import NodeTest, Recorder
from shell_origami.msg import Edit, Energy, SheetState

STEPS = 250  # published each, more than any queue holds but that of edits
ROUNDS = 20
# What is published meanwhile would be more than twice of what the node is. Before messages come to
# a subscriber's queue they wait for roscpp's own thread, on a busy machine a whole round of them.
MOST_GROWTH = 1.5


class DeafSubscriber(object):
    """It shakes hands, and that is the last it reads."""

    def __init__(self, topic, message):
        node = xmlrpc.client.ServerProxy(rospy.get_master().lookupNode('/origami')[2])
        _, _, (_, host, port) = node.requestTopic('/deaf', topic, [['TCPROS']])
        self.socket = socket.socket()
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.socket.connect((host, port))
        fields = {'callerid': '/deaf', 'topic': topic, 'type': message._type, 'md5sum': message._md5sum}
        lines = [('%s=%s' % field).encode() for field in fields.items()]
        header = b''.join(struct.pack('<I', len(text)) + text for text in lines)
        self.socket.sendall(struct.pack('<I', len(header)) + header)
        answer = self.socket.recv(4)
        if len(answer) != 4:
            raise AssertionError('the node hangs up')


class DeafSubscriberTest(NodeTest):
    pinned = False

    def publish(self):
        """Steps of a paper at rest cost next to nothing. Each is published, and the pin is drawn or gone."""
        self.pinned = not self.pinned
        self.origami.do('pin' if self.pinned else 'unpin', vertices=[0])
        time = self.origami.do('step', steps=STEPS).time
        self.origami.states.wait(lambda state: abs(state.header.stamp.to_sec() - time) < 1e-6)
        heard = self.origami.states.all()
        self.origami.states.forget()
        return heard

    def test_they_cost_nothing(self):
        markers = Recorder('/origami/markers', MarkerArray)
        deaf = [DeafSubscriber('/origami/' + name, message) for name, message in
                [('state', SheetState), ('markers', MarkerArray), ('energy', Energy), ('edits', Edit)]
                for _ in range(3)]
        for _ in range(8):
            self.publish()
        before = self.origami.memory()
        markers.forget()
        steps = []
        for _ in range(ROUNDS):
            steps += [state.step for state in self.publish()]
        growth = float(self.origami.memory()) / before
        rospy.loginfo('%d bytes, then %.4f of it; %d states heard, %d of markers', before, growth,
                      len(steps), len(markers.all()))
        self.assertLess(growth, MOST_GROWTH)
        self.assertEqual(steps, sorted(steps))
        self.assertGreater(len(steps), ROUNDS * STEPS / 5)
        self.assertGreater(len(markers.all()), 10)
        self.assertEqual(len(deaf), 12)  # they were there all the time


if __name__ == '__main__':
    rospy.init_node('deaf_subscriber_test')
    rostest.rosrun('shell_origami', 'deaf_subscriber_test', DeafSubscriberTest)
