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

STEPS = 1000  # published each, in so many that every queue is full
# What is published meanwhile would be more than twice of what the node is. Queues of those who do
# read are now fuller, now emptier.
MOST_GROWTH = 1.2


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
    def publish(self):
        """Steps of a paper at rest cost next to nothing. Each is published."""
        self.origami.do('pin', vertices=[0])
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
        for _ in range(3):
            self.publish()
        before = self.origami.memory()
        markers.forget()
        steps = []
        for _ in range(5):
            steps += [state.step for state in self.publish()]
        growth = float(self.origami.memory()) / before
        rospy.loginfo('%d bytes, then %.4f of it; %d states heard, %d of markers', before, growth,
                      len(steps), len(markers.all()))
        self.assertLess(growth, MOST_GROWTH)
        self.assertEqual(steps, sorted(steps))
        self.assertGreater(len(steps), STEPS)
        self.assertGreater(len(markers.all()), 10)
        self.assertEqual(len(deaf), 12)  # they were there all the time


if __name__ == '__main__':
    rospy.init_node('deaf_subscriber_test')
    rostest.rosrun('shell_origami', 'deaf_subscriber_test', DeafSubscriberTest)
