"""Goals of ~fold_recipe, as the tests send them."""

import threading

import actionlib

from origami_client import wait_until
from shell_origami.msg import FoldRecipeAction, FoldRecipeGoal


def connect():
    """The client of the node's action."""
    client = actionlib.ActionClient('/origami/fold_recipe', FoldRecipeAction)
    client.wait_for_server()
    return client


class Goal(object):
    """A goal that was sent, and all that came back."""

    def __init__(self, client, **fields):
        self.feedback = []
        self.ended = threading.Event()
        self.handle = client.send_goal(FoldRecipeGoal(**fields), self._changed, self._progress)

    def _changed(self, handle):
        if handle.get_comm_state() == actionlib.CommState.DONE:
            self.ended.set()

    def _progress(self, _, feedback):
        self.feedback.append(feedback)

    def wait(self, timeout=20):
        if not self.ended.wait(timeout):
            raise AssertionError('the goal does not end')
        return self.handle.get_goal_status(), self.handle.get_goal_status_text()

    def starts(self):
        """Whether it does, and does not end before."""
        wait_until(lambda: self.feedback or self.ended.is_set(), 'the goal starts or ends')
        return not self.ended.is_set()

    def wait_for_progress(self, progress):
        wait_until(lambda: any(feedback.progress >= progress for feedback in self.feedback),
                   'progress of %g' % progress)

    def id(self):
        return self.handle.comm_state_machine.action_goal.goal_id.id
