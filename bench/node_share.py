#!/usr/bin/python3
"""Measures how much of its time the node spends outside the solver while somebody watches:
   bench/node_share.py BENCH.json
Folds the dog at 2,000 triangles as fast as the machine can, with a subscriber to what rviz shows
and 30 publications a simulated second, and adds the result to the benchmarks in the file, as
`node/2000`. Wants a sourced workspace and a free ROS_MASTER_URI."""
import json
import os
import subprocess
import sys
import tempfile
import time

import rosgraph
import rospy
import yaml
from std_srvs.srv import Trigger

RECIPE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'recipes', 'dog.yaml')
MAX_EDGE = 0.0056  # [m], of about 2,000 triangles
TOPICS = ['/origami/markers', '/origami/state', '/origami/sheet', '/tf']
PATIENCE = 120  # [s]


def write_recipe(path):
    with open(RECIPE) as file:
        recipe = yaml.safe_load(file)
    recipe['sheet']['max_edge'] = MAX_EDGE
    with open(path, 'w') as file:
        yaml.safe_dump(recipe, file)


def wait(ready, what):
    deadline = time.monotonic() + PATIENCE
    while not ready():
        if time.monotonic() > deadline:
            sys.exit('node_share.py: %s after %d s' % (what, PATIENCE))
        time.sleep(0.05)


def fold(folder):
    """The report of a watched run. The paper waits until every topic is heard."""
    report = os.path.join(folder, 'report.json')
    rospy.wait_for_service('/origami/resume', PATIENCE)
    # Undeserialized, so that Python's slowness is not the node's.
    watched = [rospy.Subscriber(topic, rospy.AnyMsg, lambda message: None) for topic in TOPICS]
    wait(lambda: all(s.get_num_connections() for s in watched), 'not every topic is connected')
    rospy.ServiceProxy('/origami/resume', Trigger)()
    wait(lambda: os.path.exists(report), 'the recipe is not done')
    with open(report) as file:
        return json.load(file)


def measure():
    with tempfile.TemporaryDirectory() as folder:
        recipe = os.path.join(folder, 'dog.yaml')
        write_recipe(recipe)
        launched = subprocess.Popen(
            ['roslaunch', 'shell_origami', 'origami.launch', 'rviz:=false', 'paused:=true',
             'clock:=lead', 'real_time_factor:=0', 'recipe:=' + recipe, 'output:=' + folder],
            stdout=subprocess.DEVNULL)
        try:
            wait(rosgraph.is_master_online, 'there is no master')
            rospy.init_node('node_share')
            return fold(folder)
        finally:
            launched.terminate()
            launched.wait()


def main():
    report = measure()
    share = 1 - report['solver_time'] / report['wall_time']
    with open(sys.argv[1]) as file:
        run = json.load(file)
    run['benchmarks'].append({'name': 'node/2000', 'wall_s': report['wall_time'],
                              'solver_s': report['solver_time'], 'outside': share})
    with open(sys.argv[1], 'w') as file:
        json.dump(run, file, indent=1)


if __name__ == '__main__':
    main()
