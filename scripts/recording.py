"""A recorded run: the sheets and states of a bag, read without the message types of its version."""
import os

import rosbag
import rospy

from rviz_config import Failure

# Of the node in the namespace that ROS_NAMESPACE names.
SHEET, STATE = rospy.resolve_name("origami/sheet"), rospy.resolve_name("origami/state")


def key(message):
    """What a sheet and its states have in common. Obstacles come without a new revision, and older
    recordings have none."""
    return message.revision, len(getattr(message, "obstacles", ()))


class Recording:
    """Reads the bag again in every method, because a long run does not fit into memory."""

    def __init__(self, path):
        if not os.path.isfile(path):
            raise Failure("there is no bag '%s'" % path)
        self.path = path
        try:
            self.bag = rosbag.Bag(path)
        except rosbag.ROSBagUnindexedException:
            raise Failure("'%s' was not finished: rosbag reindex mends that" % path)
        except (rosbag.ROSBagException, OSError) as error:
            raise Failure("cannot read '%s': %s" % (path, error))
        for topic in (SHEET, STATE):
            if not self.bag.get_message_count(topic):
                raise Failure("'%s' holds nothing of %s" % (path, topic))
        self.sheets = {key(sheet): sheet for sheet in self._messages(SHEET)}

    def _messages(self, topic):
        try:
            for _, message, _ in self.bag.read_messages([topic]):
                yield message
        except rosbag.ROSBagException as error:
            raise Failure("cannot read '%s': %s" % (self.path, error))

    def states(self):
        """Yields the states in order, each with the time since the first [s]. Where stamps jump back
        (a simulator was reset), time continues."""
        elapsed, last = 0, None
        for state in self._messages(STATE):
            sheet = self.sheets.get(key(state))
            if sheet is None or len(sheet.flat_positions) != len(state.positions):
                continue
            if last is not None:
                elapsed += max(0, (state.header.stamp - last).to_sec())
            last = state.header.stamp
            yield elapsed, state

    def sheet_of(self, state):
        return self.sheets[key(state)]

    def frames(self, fps, speed):
        """Returns the states that a film shows, as pairs of the state's number and its count of frames.
        The last one is the end of the run."""
        times = [elapsed for elapsed, _ in self.states()]
        if not times:
            raise Failure("no state of '%s' belongs to a sheet of it" % self.path)
        shown, state = [], 0
        for frame in range(int(times[-1] / speed * fps + 0.5) + 1):
            # Half a millisecond for the rounding of stamps.
            while state + 1 < len(times) and times[state + 1] <= frame * speed / fps + 5e-4:
                state += 1
            if shown and shown[-1][0] == state:
                shown[-1][1] += 1
            else:
                shown.append([state, 1])
        if shown[-1][0] != len(times) - 1:
            shown.append([len(times) - 1, 1])
        return shown

    def pick(self, wanted):
        """Yields the states with these numbers, which must ascend."""
        wanted = set(wanted)
        for number, (_, state) in enumerate(self.states()):
            if number in wanted:
                yield state
