"""The services and topics of an origami node as methods."""

import collections
import threading
import time

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import (Point, Point32, PointStamped, Polygon, PoseStamped, Quaternion,
                               Vector3)
from shape_msgs.msg import Plane, SolidPrimitive
from std_srvs.srv import Trigger

from shell_origami.msg import FoldRecipeAction, FoldRecipeGoal, Landmark, Sheet, SheetState
from shell_origami.srv import (AddObstacle, AddVertex, Fold, FoldThrough, Grasp, Layers, Load,
                               Pin, Release, RemoveObstacle, Save, Step, Undo, Unpin)

# Debian 11's rospy calls this method at its end, which Debian 11's Python no longer has.
if not hasattr(threading.Thread, 'isAlive'):
    threading.Thread.isAlive = threading.Thread.is_alive

SERVICES = {
    'fold': Fold, 'fold_through': FoldThrough, 'layers': Layers, 'turn_over': Trigger, 'pin': Pin,
    'unpin': Unpin, 'add_vertex': AddVertex, 'add_obstacle': AddObstacle,
    'remove_obstacle': RemoveObstacle, 'grasp': Grasp, 'release': Release, 'load': Load,
    'save': Save, 'step': Step, 'undo': Undo, 'settle': Trigger, 'pause': Trigger,
    'resume': Trigger, 'reset': Trigger,
}

# For each axiom of ~fold_through the recipe's words for its points, in the order of the request.
AXIOMS = {'bring': ('bring', 'to'), 'edges': ('edge', 'to_edge'), 'across': ('across', 'at', 'move'),
          'through': ('through', 'move')}

# A piece of a crease as it is now: angles [rad], moment [N*m per m].
Crease = collections.namedtuple('Crease', 'id name angle rest_angle target_angle moment vertices')


class OrigamiError(Exception):
    """What was asked for was not done; the message says why, in the node's own words."""


def flat_point(place):
    """Returns the point of the flat sheet at (x, y) [m]."""
    return place if isinstance(place, Point) else Point(place[0], place[1], 0)


def landmark(place):
    """Returns a Landmark: of a name of the recipe that was run last, of a point (x, y) of the flat
    sheet, or of a stamped point in space [m]."""
    if isinstance(place, Landmark):
        return place
    if isinstance(place, str):
        return Landmark(name=place)
    if isinstance(place, PointStamped):
        return Landmark(space=place)
    return Landmark(flat=flat_point(place))


class Latest(object):
    """The last message of a topic."""

    def __init__(self, topic, kind):
        self.message = None
        self.news = threading.Condition()
        self.topic = topic
        self.subscriber = rospy.Subscriber(topic, kind, self._hear, queue_size=1)

    def _hear(self, message):
        with self.news:
            self.message = message
            self.news.notify_all()

    def wait(self, wanted, timeout):
        """Waits, for so many seconds of elapsed time, for a message that is wanted."""
        deadline = time.time() + timeout
        with self.news:
            while self.message is None or not wanted(self.message):
                left = deadline - time.time()
                if left <= 0 or rospy.is_shutdown():
                    raise OrigamiError('%s does not tell within %g s what is waited for'
                                       % (self.topic, timeout))
                self.news.wait(min(left, 0.1))
            return self.message


class Origami(object):
    """The paper of a node. Angles are in radians, lengths in metres, times in seconds; points of
    the flat sheet are (x, y). Each method that asks the node for something returns its answer.

    node: its name, resolved as ROS names are
    timeout: of elapsed time, for what the node does at once [s]
    Raises OrigamiError where rospy.init_node() was not called or no such node answers."""

    def __init__(self, node='origami', timeout=5):
        if not rospy.core.is_initialized():
            raise OrigamiError('rospy.init_node() must be called first')
        self.name = rospy.resolve_name(node)
        self.timeout = timeout
        self.edit = 0  # number of the last one that was made here
        try:
            for service in SERVICES:
                rospy.wait_for_service(self.name + '/' + service, timeout)
        except rospy.ROSException:
            raise OrigamiError('no node %s answers within %g s: start it by roslaunch shell_origami '
                               'origami.launch' % (self.name, timeout)) from None
        self.services = {service: rospy.ServiceProxy(self.name + '/' + service, kind)
                         for service, kind in SERVICES.items()}
        self._latest = {}

    def request(self, service, **fields):
        """Calls a service by its own fields. Raises OrigamiError where the node rejects it."""
        try:
            answer = self.services[service](**fields)
        except (rospy.ServiceException, rospy.ROSException) as error:
            raise OrigamiError('%s/%s does not answer: %s' % (self.name, service, error)) from None
        if not answer.success:
            raise OrigamiError(answer.message)
        self.edit = max(self.edit, getattr(answer, 'edit', 0))
        return answer

    def listen(self, topic, kind):
        """Hears a topic of the node from now on."""
        if topic not in self._latest:
            self._latest[topic] = Latest(self.name + '/' + topic, kind)
        return self._latest[topic]

    def wait(self, topic, kind, wanted=lambda message: True, timeout=None):
        """Waits, for so many seconds of elapsed time, until the last message of a topic of the node is
        one that is wanted, and returns it."""
        return self.listen(topic, kind).wait(wanted, self.timeout if timeout is None else timeout)

    # Folding

    def fold(self, line=None, crease='', vertices=(), angle=0.0, part=0.0, duration=0.0,
             stiffness=0.0, name=''):
        """Folds along a line of two points, along that between two vertices, or at a crease or a
        group of creases, to an angle or a part of the pattern's. Further fields as of Fold.srv."""
        return self.request('fold', line=[flat_point(p) for p in line or ()], crease=crease,
                            vertices=vertices, angle=angle, part=part, duration=duration,
                            stiffness=stiffness, name=name)

    def fold_through(self, layers='all', flap=None, way='front', viewer=(0, 0, 0), angle=0.0,
                     duration=0.0, dry_run=False, name='', **words):
        """Folds through layers, told in the words of a recipe: bring, to; edge, to_edge; across,
        at, move; or through, move. Places are as landmark() takes them.

        layers: 'all', or the number of layers at the top
        flap: a place on the flap that is folded alone"""
        axiom = next((a for a, needed in AXIOMS.items() if set(needed) == set(words)), None)
        if axiom is None:
            raise OrigamiError('a fold through layers takes one of %s, not %s' % (
                '; '.join(', '.join(needed) for needed in AXIOMS.values()),
                ', '.join(sorted(words)) or 'none'))
        points = []
        for word in AXIOMS[axiom]:
            several = word in ('edge', 'to_edge', 'across', 'through')
            points += [landmark(p) for p in words[word]] if several else [landmark(words[word])]
        top = 0 if layers == 'all' else int(layers)
        chosen = 'flap' if flap is not None else 'top' if top else 'all'
        return self.request('fold_through', axiom=axiom, points=points, layers=chosen, count=top,
                            flap=Landmark() if flap is None else landmark(flap), way=way,
                            viewer=Vector3(*viewer), angle=angle, duration=duration, dry_run=dry_run,
                            name=name)

    def layers(self, point, viewer=(0, 0, 0)):
        """Asks what lies at a place, from front to back."""
        return self.request('layers', point=landmark(point), viewer=Vector3(*viewer))

    def turn_over(self):
        """Looks at the paper's other side from now on."""
        return self.request('turn_over')

    def fold_recipe(self, recipe='', yaml='', timeout=600, feedback=None):
        """Folds by a recipe, the path of one or its text, and returns the action's result.

        timeout: of elapsed time, after which the recipe is canceled [s]
        feedback: called with each FoldRecipeFeedback"""
        client = actionlib.ActionClient(self.name + '/fold_recipe', FoldRecipeAction)
        self._wait_for(client.wait_for_server, self.timeout, 'folds recipes')
        ended = threading.Event()

        def changed(handle):
            if handle.get_comm_state() == actionlib.CommState.DONE:
                ended.set()

        handle = client.send_goal(FoldRecipeGoal(recipe=recipe, yaml=yaml), changed,
                                  lambda _, news: feedback(news) if feedback else None)
        if not ended.wait(timeout):
            handle.cancel()
            raise OrigamiError('the recipe is not folded within %g s' % timeout)
        if handle.get_goal_status() != GoalStatus.SUCCEEDED:
            raise OrigamiError(handle.get_goal_status_text())
        return handle.get_result()

    def add_vertex(self, edge, fraction):
        return self.request('add_vertex', edge=edge, fraction=fraction)

    def undo(self, edits=1, since=0):
        """Takes back the last edits, or the one with the number `since` and all after it."""
        return self.request('undo', edits=0 if since else edits, since=since)

    # Holding

    def pin(self, vertices=(), points=(), region=(), center=None, radius=0.0, frame=''):
        """Holds vertices: by their ids, nearest to flat points, in a flat polygon, or within a
        radius of a stamped point; where they are, or carried along with a TF frame."""
        corners = Polygon([Point32(x, y, 0) for x, y in region])
        return self.request('pin', vertices=vertices, points=[flat_point(p) for p in points],
                            region=corners, center=center or PointStamped(), radius=radius,
                            frame_id=frame)

    def unpin(self, vertices=()):
        """Lets go of vertices; of all where none is given."""
        return self.request('unpin', vertices=vertices)

    def grasp(self, id, vertices=(), points=(), region=(), center=None, radius=0.0, frame='',
              stiffness=0.0, max_force=0.0, reach=0.0):
        """Holds vertices softly: by springs of a stiffness [N/m] up to a force [N], both of all of
        them together; beyond it the paper slips. Vertices are chosen as by pin()."""
        corners = Polygon([Point32(x, y, 0) for x, y in region])
        return self.request('grasp', id=id, vertices=vertices,
                            points=[flat_point(p) for p in points], region=corners,
                            center=center or PointStamped(), radius=radius, frame_id=frame,
                            stiffness=stiffness, max_force=max_force, reach=reach)

    def release(self, *ids):
        """Ends grasps; all where none is named."""
        return self.request('release', ids=ids)

    # Obstacles

    def add_obstacle(self, id, box=None, sphere=None, cylinder=None, plane=None, mesh='',
                     scale=(1, 1, 1), position=(0, 0, 0), orientation=(0, 0, 0, 1), frame='',
                     friction=-1.0):
        """Puts a rigid body beside the paper: a box of a size (x, y, z), a sphere of a radius, a
        cylinder of (radius, length) about its z axis, the half space under a plane (a, b, c, d) with
        a x + b y + c z + d = 0, or a mesh; at a pose in the world, or in a TF frame that carries it
        along. A negative friction: the node's parameter."""
        fields = dict(id=id, mesh=mesh, scale=Vector3(*scale), friction=friction)
        if box is not None:
            fields['primitive'] = SolidPrimitive(SolidPrimitive.BOX, box)
        if sphere is not None:
            fields['primitive'] = SolidPrimitive(SolidPrimitive.SPHERE, [sphere])
        if cylinder is not None:
            radius, length = cylinder
            fields['primitive'] = SolidPrimitive(SolidPrimitive.CYLINDER, [length, radius])
        if plane is not None:
            fields['plane'] = Plane(plane)
        pose = PoseStamped()
        pose.header.frame_id = frame
        pose.pose.position = Point(*position)
        pose.pose.orientation = Quaternion(*orientation)
        return self.request('add_obstacle', pose=pose, **fields)

    def remove_obstacle(self, *ids):
        """Takes obstacles away; all where none is named."""
        return self.request('remove_obstacle', ids=ids)

    # Files

    def load(self, path, scale=0.0):
        return self.request('load', path=path, scale=scale)

    def save(self, path):
        return self.request('save', path=path)

    # Time

    def step(self, steps=1):
        return self.request('step', steps=steps)

    def pause(self):
        return self.request('pause')

    def resume(self):
        return self.request('resume')

    def reset(self):
        return self.request('reset')

    def settle(self):
        """Brings the paper to equilibrium at once."""
        return self.request('settle')

    def wait_until_settled(self, timeout=60):
        """Waits until all that was asked for here is done and the paper rests. Returns the state.

        timeout: of elapsed time [s]"""
        state = self.wait('state', SheetState,
                           lambda s: s.edits >= self.edit and (s.settled or s.paused), timeout)
        if not state.settled:
            raise OrigamiError('%s is paused, and the paper has not settled' % self.name)
        return state

    # The paper as it is

    def state(self):
        """Returns a SheetState that shows all that was asked for here."""
        return self.wait('state', SheetState, lambda s: s.edits >= self.edit, self.timeout)

    def sheet(self):
        """Returns the flat sheet of state()."""
        return self._with_sheet()[1]

    def creases(self):
        """Returns the pieces of all creases as they are now, as a list of Crease."""
        state, sheet = self._with_sheet()
        return [Crease(s.id, c.name, s.angle, s.rest_angle, s.target_angle, s.moment,
                       tuple(c.vertices)) for c, s in zip(sheet.creases, state.creases)]

    def _with_sheet(self):
        for _ in range(10):  # the paper may be edited by others meanwhile
            state = self.state()
            sheet = self.wait('sheet', Sheet, lambda s: s.revision >= state.revision, self.timeout)
            if sheet.revision == state.revision:
                return state, sheet
        raise OrigamiError('the paper of %s is edited all the time' % self.name)

    def _wait_for(self, function, timeout, what):
        """Waits for a function that returns once it is there, by elapsed time: ROS time may stand."""
        waiter = threading.Thread(target=function, daemon=True)
        waiter.start()
        waiter.join(timeout)
        if waiter.is_alive():
            raise OrigamiError('no node %s %s' % (self.name, what))
