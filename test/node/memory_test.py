#!/usr/bin/python3
"""An hour of folding and unfolding takes no more memory than its first five minutes."""

import rospy
import rostest

from origami_client import NodeTest, line

STEP = 1.0 / 60    # [s]
PERIOD = 2.0       # [s] of one fold, be it up or down
FOLD = 1.0         # [s] of it in which the crease moves
TOPICS = ['/origami/sheet', '/origami/state', '/origami/energy', '/origami/edits',
          '/origami/markers', '/tf', '/diagnostics', '/clock']
MOST_GROWTH = 1.05


class MemoryTest(NodeTest):
    def fold(self, hours):
        """Folds and unfolds for so long. Returns the largest angle [rad]."""
        largest = 0
        for number in range(int(hours * 3600 / PERIOD)):
            up = number % 2 == 0
            self.origami.do('fold', crease=self.crease, angle=1.0 if up else 0.0, duration=FOLD)
            time = self.origami.do('step', steps=int(PERIOD / STEP)).time
            state = self.origami.states.wait(
                lambda state: state.creases and state.header.stamp.to_sec() > time - 0.2)
            largest = max(largest, state.creases[0].angle)
            self.origami.states.forget()
            self.origami.edits.forget()
        return largest

    def test_memory_stays_flat(self):
        heard = {topic: 0 for topic in TOPICS}

        def listen(topic):
            def hear(_):
                heard[topic] += 1
            return rospy.Subscriber(topic, rospy.AnyMsg, hear)

        listeners = [listen(topic) for topic in TOPICS]
        revision = self.origami.do('fold', line=line(0, 0, 0.15, 0.15), angle=0.5).revision
        sheet = self.origami.sheets.wait(lambda sheet: sheet.revision == revision)
        self.crease = sheet.creases[0].name
        start = self.origami.do('step', steps=1).time
        self.fold(1.0 / 12)
        before = self.origami.memory()
        hours = rospy.get_param('~hours')
        largest = self.fold(hours - 1.0 / 12)
        growth = float(self.origami.memory()) / before
        rospy.loginfo('%d bytes after five minutes, %.4f of it after %g h; heard: %s', before,
                      growth, hours, heard)
        self.assertLess(growth, MOST_GROWTH)
        self.assertAlmostEqual(self.origami.do('step', steps=1).time - start, hours * 3600, delta=1)
        self.assertGreater(largest, 0.9)
        self.assertEqual([topic for topic in TOPICS if heard[topic] < 2], [])
        self.assertEqual(len(listeners), len(TOPICS))


if __name__ == '__main__':
    rospy.init_node('memory_test')
    rostest.rosrun('shell_origami', 'memory_test', MemoryTest)
