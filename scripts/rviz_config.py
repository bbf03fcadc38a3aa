"""rviz's configuration for a picture of the paper, with the camera where a recipe's `view` says."""
import math
import os

import yaml

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


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


def config_for(view, box):
    """rviz/origami.rviz looking at the middle of the box."""
    with open(os.path.join(ROOT, "rviz", "origami.rviz")) as file:
        config = yaml.safe_load(file)
    middle = [(low + high) / 2 for low, high in box]
    manager = config["Visualization Manager"]
    camera = manager["Views"]["Current"]
    camera["Target Frame"] = "<Fixed Frame>"
    camera["Focal Point"] = dict(zip("XYZ", middle))
    if "yaw_deg" in view:
        camera["Yaw"] = math.radians(view["yaw_deg"]) % (2 * math.pi)
    if "pitch_deg" in view:
        camera["Pitch"] = math.radians(view["pitch_deg"])
    if "distance" in view:
        camera["Distance"] = view["distance"]
    return config


def write_config(path, config):
    with open(path, "w") as file:
        yaml.safe_dump(config, file)
