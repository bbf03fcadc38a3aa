"""A demonstration's launch file as a user starts it, and what its program says."""

import os
import queue
import signal
import subprocess
import threading
import time

# Debian 11's roslaunch keeps what it says to itself until it ends.
AT_ONCE = dict(os.environ, PYTHONUNBUFFERED='1')


class LaunchedDemo(object):
    def __init__(self, launch, program, *arguments):
        """launch: a launch file; program: the node that demonstrates, and ends"""
        self.program = program
        self.process = subprocess.Popen(
            ['roslaunch', 'shell_origami', launch, 'rviz:=false', *arguments], stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, universal_newlines=True, env=AT_ONCE)
        self.lines = queue.Queue()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait()
        self.reader.join()

    def _read(self):
        with self.process.stdout as lines:
            for line in lines:
                self.lines.put(line)

    def listen(self, seconds):
        """Returns what is said until the program has ended, within so many seconds."""
        deadline, said = time.time() + seconds, ''
        while '[' + self.program not in said.split('started with pid')[-1]:
            try:
                said += self.lines.get(timeout=max(0, deadline - time.time()))
            except queue.Empty:
                raise AssertionError('%s does not come to an end: %s' % (self.program, said))
        return said
