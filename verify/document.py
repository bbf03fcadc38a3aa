#!/usr/bin/python3
"""Draws the figures of the verification and writes its page:
   verify/document.py RESULTS_DIR doc/verification.md
RESULTS_DIR was written by origami_verify; pictures are put beside the page, in doc/verification/."""
import csv
import os
import string
import sys

import figures

HEAD = """# Verification

The simulation compared with closed forms. This page is written by `scripts/verify`, which builds
`origami_verify` ([verify/](../verify/)), runs it and draws its figures. A row holds if the measured
value is within the tolerance of the expected one; {count} of {total} do.
"""


def rows_of(path):
    with open(path, newline='') as file:
        return list(csv.DictReader(file))


def number(text):
    """At most five digits."""
    return '%.5g' % float(text)


def cell(text):
    return text.replace('|', r'\|')


def reasons(rows):
    """The different reasons for tolerances, in order."""
    return list(dict.fromkeys(row['why'] for row in rows))


def table(rows):
    yield '| quantity | expected | measured | tolerance | why |'
    yield '| --- | ---: | ---: | ---: | --- |'
    for row in rows:
        measured = number(row['measured'])
        yield '| %s | %s | %s | %s | %s |' % (
            cell(row['quantity']), number(row['expected']),
            measured if row['holds'] == '1' else '**%s: off**' % measured,
            '%.2g' % float(row['tolerance']), string.ascii_lowercase[reasons(rows).index(row['why'])])


# For some items: the data of a second table, its heading, and a text.
COMPARISONS = {
    '12 Integrators on one fold': (
        'integrators',
        ['integrator', 'largest step that holds [s]', 'step taken [s]',
         'elapsed over simulated time', 'against Newmark'],
        'The first diagonal of a 0.15 m square of some 2,000 triangles, folded to 170 degrees within '
        'a second. Implicit steps were doubled from 1/60 s until one had to be cut in two. Paper '
        'hardly stretches: waves in its plane cross a triangle in microseconds, and an explicit '
        'step must not be longer.'),
    '13 Membranes': (
        'membranes', ['membrane'] + ['%d degrees' % a for a in range(0, 180, 30)],
        'Energy of a stretch over E t / 2 e^2 A in six directions. The terms of edges and areas '
        'cannot represent a Poisson\'s ratio below 1/3, and on a mesh that is not equilateral their '
        'stiffness depends on the direction. St. Venant-Kirchhoff is the default.'),
    '14 The height term of creases': (
        'crease_laws', ['mesh', 'without', 'with'],
        'Energy of a crease folded by 1 rad between stiff flaps, over c / 2 phi^2 L. With the height '
        'of its triangles in the energy the stiffness of a crease depends on the mesh. Without, as '
        'Discrete Shells Origami proposes, it is the stiffness that was asked for: the default.'),
}


def comparison(results, item):
    if item not in COMPARISONS:
        return
    name, heading, says = COMPARISONS[item]
    yield '\n' + says + '\n'
    yield '| %s |' % ' | '.join(heading)
    yield '| --- |' + ' ---: |' * (len(heading) - 1)
    for row in rows_of(os.path.join(results, name + '.csv')):
        first, *values = row.values()
        yield '| %s | %s |' % (first, ' | '.join('%.3g' % float(value) for value in values))


def section(item, rows, pictures):
    yield '\n## %s\n' % item
    yield from table(rows)
    yield ''
    for letter, why in zip(string.ascii_lowercase, reasons(rows)):
        yield '- %s: %s' % (letter, why)
    for name, caption in pictures:
        yield '\n![%s](verification/%s.png)' % (name, name)
        if caption:
            yield '\n' + caption


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, page = sys.argv[1:]
    rows = rows_of(os.path.join(results, 'results.csv'))
    folder = os.path.splitext(page)[0]
    os.makedirs(folder, exist_ok=True)
    pictures = figures.draw(results, folder)
    lines = [HEAD.format(count=sum(row['holds'] == '1' for row in rows), total=len(rows))]
    items = sorted(dict.fromkeys(row['item'] for row in rows), key=lambda item: int(item.split()[0]))
    for item in items:
        lines += section(item, [row for row in rows if row['item'] == item],
                         [(name, caption) for of, name, caption in pictures if of == item])
        lines += comparison(results, item)
    with open(page, 'w') as file:
        file.write('\n'.join(lines) + '\n')


main()
