#!/usr/bin/python3
"""The master dies and another takes its place: the node is found there, with its paper."""

import os
import signal
import socket
import socketserver
import subprocess
import tempfile
import threading
import time
import unittest
import xmlrpc.client
import xmlrpc.server

import roslib.packages
import rostest

from origami_client import wait_until


def free_port():
    with socket.socket() as free:
        free.bind(('127.0.0.1', 0))
        return free.getsockname()[1]


class Relay(socketserver.ThreadingMixIn, xmlrpc.server.SimpleXMLRPCServer):
    """Passes calls on to a master, but those in `nonsense`."""
    daemon_threads = True

    def __init__(self, port):
        super().__init__(('127.0.0.1', 0), logRequests=False)
        self.master = 'http://127.0.0.1:%d' % port
        self.uri = 'http://127.0.0.1:%d' % self.server_address[1]
        self.calls = []  # (method, caller)
        self.nonsense = set()
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def _dispatch(self, method, params):
        self.calls.append((method, params[0]))
        if method in self.nonsense:
            return [1, '', 'nonsense']
        return getattr(xmlrpc.client.ServerProxy(self.master), method)(*params)


class MasterRestartTest(unittest.TestCase):
    def setUp(self):
        self.port = free_port()
        self.environment = dict(os.environ, ROS_IP='127.0.0.1',
                                ROS_MASTER_URI='http://127.0.0.1:%d' % self.port)
        self.environment.pop('ROS_NAMESPACE', None)

    def start(self, *command, **options):
        process = subprocess.Popen(command, env=self.environment, **options)
        def end():
            if process.poll() is None:
                process.kill()
            process.wait()
        self.addCleanup(end)
        return process

    def start_master(self):
        master = self.start('rosmaster', '--core', '-p', str(self.port),
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.until('rostopic', 'list')
        return master

    def until(self, *command):
        """What the command says as soon as it succeeds."""
        said = None

        def succeeds():
            nonlocal said
            try:
                said = subprocess.check_output(command, env=self.environment, timeout=5,
                                               stderr=subprocess.STDOUT, universal_newlines=True)
                return True
            except subprocess.SubprocessError as error:
                said = getattr(error, 'output', error)
                return False
        wait_until(succeeds, lambda: '%s succeeds, but: %s' % (command, said), period=0.2)
        return said

    def until_heard(self, heard, count):
        """Until a listener has heard so many states: it fails where the listener was lost."""
        wait_until(lambda: len(heard) > count, 'a listener, which may be lost, hears more')

    def start_node(self, *parameters):
        return self.start(roslib.packages.find_node('shell_origami', 'origami_node')[0], *parameters)

    def test_nobody_watches_the_master_unasked(self):
        self.start_master()
        relay = Relay(self.port)
        self.environment['ROS_MASTER_URI'] = relay.uri
        node = self.start_node()
        self.until('rostopic', 'echo', '-n', '3', '/diagnostics')
        mine = [method for method, caller in relay.calls if caller == '/origami']
        self.assertIn('registerService', mine)
        self.assertNotIn('getSystemState', mine)
        self.assertIsNone(node.poll())

    def test_a_master_that_answers_nonsense_is_survived(self):
        self.start_master()
        relay = Relay(self.port)
        self.environment['ROS_MASTER_URI'] = relay.uri
        relay.nonsense = {'getSystemState', 'getPid'}
        node = self.start_node('_watch_master:=true')
        for method in 'getPid', 'getSystemState':
            relay.nonsense = {method, 'getSystemState'}
            wait_until(lambda: relay.calls.count((method, '/origami')) >= 2,
                       'the node calls %s twice' % method)
        self.assertIn('success: True', self.until('rosservice', 'call', '/origami/pause'))
        self.assertIsNone(node.poll())

    def test_the_node_is_found_by_the_next_master(self):
        master = self.start_master()
        node = self.start_node('_watch_master:=true')
        fold = 'rosservice call /origami/fold'.split()
        self.assertIn('success: True', self.until(
            *fold, '{line: [{x: 0, y: 0}, {x: 0.15, y: 0.15}], angle: 1.0}'))
        heard = []
        echo = self.start('rostopic', 'echo', '-p', '/origami/state/step',
                          stdout=subprocess.PIPE, universal_newlines=True)
        threading.Thread(target=lambda: heard.extend(iter(echo.stdout.readline, '')),
                         daemon=True).start()
        time.sleep(3)  # until the node has asked the master about itself, which nothing shows
        self.until_heard(heard, 10)

        master.send_signal(signal.SIGKILL)
        master.wait()
        self.until_heard(heard, len(heard) + 10)
        self.assertIsNone(node.poll())

        self.start_master()
        wait_until(lambda: '/origami/fold' in self.until('rosservice', 'list'),
                   'the next master knows the node')
        self.assertIn('success: True', self.until(*fold, "{crease: 'fold_0', angle: -0.5}"))
        self.assertIn('fold_0', self.until('rostopic', 'echo', '-n', '1', '/origami/sheet/creases'))
        # What it listens to, too.
        with tempfile.TemporaryFile('w+') as picked:
            listener = self.start('rostopic', 'echo', '-n', '1', '/origami/picked/vertex',
                                  stdout=picked)
            self.start('rostopic', 'pub', '-r', '2', '/clicked_point', 'geometry_msgs/PointStamped',
                       "{header: {frame_id: 'world'}, point: {x: 0.0, y: 0.0, z: 0.0}}",
                       stdout=subprocess.DEVNULL)
            self.assertEqual(listener.wait(15), 0)
            picked.seek(0)
            self.assertRegex(picked.read(), r'^\d+')
        self.until_heard(heard, len(heard) + 10)
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(10), 0)


if __name__ == '__main__':
    rostest.rosrun('shell_origami', 'master_restart_test', MasterRestartTest)
