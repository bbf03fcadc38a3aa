"""Nodes that a test starts and ends itself."""

import resource
import subprocess

import roslib.packages
import rospy

from origami_client import Origami


def program(name):
    return roslib.packages.find_node('shell_origami', name)[0]


def limit_files(size):
    """No file may grow beyond so many bytes, as on a full disk. (Python ignores the signal that
    would tell of it, and so does what it starts.)"""
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


class OwnNode(object):
    """One of origami_node called `name`, with private parameters."""

    def __init__(self, name, largest_file=None, **parameters):
        self.name = '/' + name
        rospy.set_param(self.name, parameters)
        self.process = subprocess.Popen(
            [program('origami_node'), '__name:=' + name], restore_signals=False,
            preexec_fn=lambda: largest_file and limit_files(largest_file))
        self.origami = Origami(self.name)

    def end(self, signal, timeout=10):
        """Sends it a signal and returns its exit code."""
        self.process.send_signal(signal)
        return self.process.wait(timeout)
