"""What doc/reference.md and config/origami.yaml say, for a test to hold against what runs."""

import collections
import os
import re

import yaml

ROOT = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..')

Bounds = collections.namedtuple('Bounds', 'low high low_is_inside')
INFINITY = float('inf')


def read(*path):
    with open(os.path.join(ROOT, *path)) as handle:
        return handle.read()


def tables():
    """{section: [{column: cell} of each row]}, the tables of a section one after the other."""
    result = collections.OrderedDict()
    for section in re.split(r'^## ', read('doc', 'reference.md'), flags=re.MULTILINE)[1:]:
        title, rows, columns = section.split('\n')[0], [], None
        for row in section.split('\n'):
            if not row.startswith('|'):
                columns = None
                continue
            cells = [cell.strip() for cell in row.strip('|').split('|')]
            if not columns:
                columns = cells
            elif not cells[0].startswith('---'):
                rows.append(dict(zip(columns, cells)))
        result[title] = rows
    return result


def names(cell):
    """The words in backticks."""
    return re.findall(r'`([^`]+)`', cell)


def bounds(row):
    """Those of a number; None of anything else."""
    text = row['bounds']
    between = re.match(r'(?:0 or )?from (\S+) to (\S+)$', text)
    if between:
        return Bounds(float(between.group(1)), float(between.group(2)), True)
    if text in ('> 0', '>= 0'):
        return Bounds(0.0, INFINITY, text == '>= 0')
    return None


def choices(row):
    """The words of which one has to be chosen."""
    text = row['bounds']
    return text.split(', ') if re.match(r'\w+(, \w+)+$', text) else []


def flat(tree, prefix=''):
    """{'material/density': 800.0, ...}"""
    result = {}
    for name, value in tree.items():
        nested = isinstance(value, dict)
        result.update(flat(value, prefix + name + '/') if nested else {prefix + name: value})
    return result


def manual():
    """{parameter: its default} of config/origami.yaml."""
    return flat(yaml.safe_load(read('config', 'origami.yaml')))
