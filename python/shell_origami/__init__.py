"""Folds the paper of an origami node from Python:

    import rospy
    from shell_origami import Origami

    rospy.init_node('folder')
    paper = Origami()
    paper.fold(line=[(0, 0), (0.15, 0.15)], angle=2.0)
    paper.wait_until_settled()
"""

from pkgutil import extend_path

# In a build folder messages and core are in another folder than this file, which a process that is given
# this one's path may find first.
__path__ = extend_path(__path__, __name__)

from shell_origami.client import Crease, Origami, OrigamiError, landmark  # noqa: E402

__all__ = ['Crease', 'Origami', 'OrigamiError', 'landmark']
