#!/usr/bin/python3
"""Writes rviz's configuration for a recipe, with the camera at the recipe's `view`.

scripts/rviz_config.py OUT.rviz --recipe RECIPE.yaml --paper PAPER.obj

The camera looks at the middle of the paper, and the grid lies below it.
"""
import argparse
import math
import os
import sys

import yaml

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOM = 0.05  # [m] between the grid and flat paper, which may fold downwards


class Failure(Exception):
    pass


def read_view(recipe):
    if not recipe:
        return {}
    try:
        with open(recipe) as file:
            return (yaml.safe_load(file) or {}).get("view") or {}
    except (OSError, yaml.YAMLError, AttributeError) as error:
        raise Failure("cannot read the view of %s: %s" % (recipe, error))


def box_of(points):
    """Returns the least and the greatest coordinate along each axis."""
    return [(min(axis), max(axis)) for axis in zip(*points)]


def config_for(view, box, ground):
    """Returns rviz/origami.rviz looking at the middle of the box, with the grid at height `ground` [m]."""
    with open(os.path.join(ROOT, "rviz", "origami.rviz")) as file:
        config = yaml.safe_load(file)
    middle = [(low + high) / 2 for low, high in box]
    manager = config["Visualization Manager"]
    camera = manager["Views"]["Current"]
    camera["Focal Point"] = dict(zip("XYZ", middle))
    if "yaw_deg" in view:
        camera["Yaw"] = math.radians(view["yaw_deg"]) % (2 * math.pi)
    if "pitch_deg" in view:
        camera["Pitch"] = math.radians(view["pitch_deg"])
    if "distance" in view:
        camera["Distance"] = view["distance"]
    for display in manager["Displays"]:
        if display["Class"] == "rviz/Grid":
            display["Offset"] = dict(zip("XYZ", middle[:2] + [ground]))
    return config


def write_config(path, config):
    with open(path, "w") as file:
        yaml.safe_dump(config, file)


def obj_points(path):
    with open(path) as file:
        return [tuple(map(float, line.split()[1:])) for line in file if line.startswith("v ")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("config", metavar="OUT.rviz")
    parser.add_argument("--recipe", metavar="RECIPE.yaml", required=True, help="whose view to take")
    parser.add_argument("--paper", metavar="PAPER.obj", required=True, help="what to look at")
    arguments = parser.parse_args()
    try:
        box = box_of(obj_points(arguments.paper))
        write_config(arguments.config,
                     config_for(read_view(arguments.recipe), box, box[2][0] - ROOM))
    except (Failure, OSError) as error:
        sys.exit("rviz_config: %s" % error)


if __name__ == "__main__":
    main()
