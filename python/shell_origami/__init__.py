"""Folds the paper of an origami node from Python:

    import rospy
    from shell_origami import Origami

    rospy.init_node('folder')
    paper = Origami()
    paper.fold(line=[(0, 0), (0.15, 0.15)], angle=2.0)
    paper.wait_until_settled()
"""

from shell_origami.client import Crease, Origami, OrigamiError, landmark

__all__ = ['Crease', 'Origami', 'OrigamiError', 'landmark']
