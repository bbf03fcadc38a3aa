#!/usr/bin/python3
"""Draws the figures of a verification and writes its page:
   verify/document.py RESULTS_DIR doc/verification.md
RESULTS_DIR is what origami_verify wrote; pictures go beside the page, into doc/verification/."""
import csv
import os
import sys

import figures

HEAD = """# Verification

What has a closed form, measured: written by `scripts/verify`, which builds `origami_verify`
([verify/](../verify/)), runs it and draws its figures. A row holds when measured is within the
tolerance of expected; {count} of {total} do.
"""


def rows_of(path):
    with open(path, newline='') as file:
        return list(csv.DictReader(file))


def number(text):
    """Five digits, and none for what is exact."""
    return '%.5g' % float(text)


def cell(text):
    return text.replace('|', r'\|')


def reasons(rows):
    """Why the tolerances are what they are, each once."""
    return list(dict.fromkeys(row['why'] for row in rows))


def table(rows):
    yield '| quantity | expected | measured | tolerance | why |'
    yield '| --- | ---: | ---: | ---: | --- |'
    for row in rows:
        measured = number(row['measured'])
        yield '| %s | %s | %s | %s | %s |' % (
            cell(row['quantity']), number(row['expected']),
            measured if row['holds'] == '1' else '**%s: off**' % measured,
            '%.2g' % float(row['tolerance']), 'abcdef'[reasons(rows).index(row['why'])])


def section(item, rows, pictures):
    yield '\n## %s\n' % item
    yield from table(rows)
    yield ''
    for letter, why in zip('abcdef', reasons(rows)):
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
    with open(page, 'w') as file:
        file.write('\n'.join(lines) + '\n')


main()
