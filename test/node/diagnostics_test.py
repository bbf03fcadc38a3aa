#!/usr/bin/python3
"""/diagnostics tells every second how solver, pace and paper are, while simulation time stands still."""

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from dynamic_reconfigure.client import Client
from geometry_msgs.msg import Point, Point32, Polygon

from origami_client import NodeTest, Origami, Recorder, line
from shell_origami.srv import Step
from std_srvs.srv import Trigger

SIDE = 0.15
OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR


def values(status):
    return {value.key: value.value for value in status.values}


class DiagnosticsTest(NodeTest):
    @classmethod
    def setUpClass(cls):
        cls.heard = Recorder('/diagnostics', DiagnosticArray)
        cls.origami = Origami()

    def told(self, task, level, since=0):
        """The first status of a task with this level."""
        def matches(status):
            return status.name == task and status.level == level
        message = self.heard.wait(lambda m: any(matches(s) for s in m.status), since=since)
        return next(s for s in message.status if matches(s))

    def test_is_told_every_second_while_time_stands_still(self):
        tasks = ['origami: solver', 'origami: pace', 'origami: paper']
        seen = len(self.heard.all())
        for _ in range(2):
            message = self.heard.wait(lambda m: m.status[0].name == tasks[0], since=seen, timeout=3)
            seen = self.heard.all().index(message) + 1
            self.assertEqual([s.name for s in message.status], tasks)
            solver, pace, paper = message.status
            self.assertEqual((solver.level, solver.message), (OK, 'paused'))
            self.assertEqual((pace.level, pace.message), (OK, 'paused'))
            self.assertEqual((paper.level, paper.message), (OK, 'settled'))
            self.assertEqual(float(values(pace)['real_time_factor']), 0)
            sheet = self.origami.sheets.messages[-1]
            self.assertEqual(int(values(paper)['triangles']), len(sheet.triangles))
            self.assertEqual(int(values(paper)['vertices']), len(sheet.flat_positions))

    def test_the_work_of_every_step_is_told_once(self):
        since = len(self.heard.all())
        self.told('origami: solver', OK, since)  # what was before is told
        since = len(self.heard.all())
        self.origami.do('fold', line=line(0, 0, SIDE, SIDE), angle=1, duration=0.5)
        self.origami.do('step', steps=40)
        self.origami.do('reset')
        self.origami.do('step', steps=2)
        steps = iterations = 0
        while steps < 42:
            message = self.heard.wait(lambda m: m.status[0].name == 'origami: solver', since=since)
            since = self.heard.all().index(message) + 1
            figures = values(message.status[0])
            steps += int(figures['steps'])
            iterations += int(figures['steps']) * float(figures['newton_iterations_per_step'])
        self.assertEqual(steps, 42)
        self.assertGreater(iterations, 40)

    def test_paper_that_is_stretched(self):
        self.origami.do('pin', points=[Point(x * 0.01, SIDE, 0) for x in range(16)])
        live = Client('/origami/live', timeout=10)
        self.addCleanup(live.update_configuration, {'gravity_y': 0})
        live.update_configuration({'gravity_y': -1000})
        self.origami.do('step', steps=60)
        paper = self.told('origami: paper', WARN, since=len(self.heard.all()))
        self.assertGreater(float(values(paper)['max_strain']), 0.02)
        self.assertGreater(float(values(paper)['strain_energy']), 0)
        self.assertIn('stretched', paper.message)

    def test_paper_that_is_not_as_it_was_asked_for(self):
        for x0, x1 in (0, 0.06), (0.09, SIDE):  # the crease between them cannot fold
            self.origami.do('pin', region=Polygon([Point32(x0, 0, 0), Point32(x1, 0, 0),
                                                   Point32(x1, SIDE, 0), Point32(x0, SIDE, 0)]))
        self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=1, duration=0)
        self.origami.do('step', steps=120)
        paper = self.told('origami: paper', WARN, since=len(self.heard.all()))
        self.assertIn('1 crease has missed the target angle', paper.message)
        self.assertEqual(values(paper)['missed'], '1')
        # The same paper is asked for something else.
        self.origami.do('fold', line=line(0.075, 0, 0.075, SIDE), angle=0, duration=0)
        self.origami.do('step', steps=120)
        paper = self.told('origami: paper', OK, since=len(self.heard.all()))
        self.assertEqual(values(paper)['missed'], '0')

    def test_a_node_that_cannot_go_on_says_why(self):
        step = rospy.ServiceProxy('/stuck/step', Step)
        step.wait_for_service(10)
        answer = step(steps=1)
        self.assertFalse(answer.success)
        solver = self.told('stuck: solver', ERROR)
        self.assertIn('nobody', solver.message)
        rospy.ServiceProxy('/stuck/reset', Trigger)()
        self.told('stuck: solver', OK, since=len(self.heard.all()))


if __name__ == '__main__':
    rospy.init_node('diagnostics_test')
    rostest.rosrun('shell_origami', 'diagnostics_test', DiagnosticsTest)
