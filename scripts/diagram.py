#!/usr/bin/python3
"""Draws a folding sequence as instructions in Yoshizawa and Randlett's style:
   scripts/diagram.py SEQUENCE.fold OUT_DIR [RECIPE.yaml]
SEQUENCE.fold is a diagrams.fold of origami_batch. OUT_DIR takes diagram.svg, with all pictures, and
diagram.pdf. Without a recipe the captions are the titles of the frames."""
import math
import os
import subprocess
import sys
import tempfile

from diagram_layers import Layers
from diagram_paper import orbit_view, read_sequence, scaled, views_of
from diagram_picture import Move, Picture, Placement, lines_to_crease, text_element
from diagram_words import Recipe, Titles, Words

# The page [mm]: A4, with cells of a picture above its caption.
WIDTH, HEIGHT, MARGIN, TITLE = 210, 297, 12, 14
COLUMNS, ROWS = 3, 3
CELL_WIDTH, CELL_HEIGHT = (WIDTH - 2 * MARGIN) / COLUMNS, 84
PICTURE = 38, 44             # what the paper may take of a cell
AREA_HEIGHT = 58             # of a cell, above the caption
LINE_HEIGHT, LETTERS = 3.7, 35  # of a caption
# Small paper is drawn larger, up to so many times.
MOST_ZOOM = 1.6


def wrapped(text):
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > LETTERS:
            lines.append("")
        lines[-1] = (lines[-1] + " " + word).strip()
    return lines


def corners_of(paper):
    """Returns where the border of the flat sheet turns."""
    corners = []
    for (a, b) in paper.face_at:
        if (b, a) in paper.face_at:
            continue
        c = next(c for (v, c) in paper.face_at if v == b and (c, v) not in paper.face_at)
        p, q, r = (paper.flat[v] for v in (a, b, c))
        turn = math.atan2(r[1] - q[1], r[0] - q[0]) - math.atan2(q[1] - p[1], q[0] - p[0])
        if abs(math.remainder(turn, 2 * math.pi)) > math.radians(5):
            corners.append(q)
    return corners


class Diagram:
    """The pictures of a sequence, as SVG elements of a cell each."""

    def __init__(self, papers, text):
        self.papers, self.text = papers, text
        self.views = views_of(papers)
        self.layers = [Layers(paper, view) for paper, view in zip(papers, self.views)]
        self.scale = min(self.fit(layers.points) for layers in self.layers)

    @staticmethod
    def fit(points):
        return min(room / max(1e-9, max(axis) - min(axis)) for room, axis in zip(PICTURE, zip(*points)))

    def picture(self, layers, *also):
        """Returns the picture of a paper with room for other points as well."""
        points = layers.points + list(also)
        scale = min(self.fit(points), MOST_ZOOM * self.scale)
        return Picture(layers, Placement(points, CELL_WIDTH, AREA_HEIGHT, scale))

    def step(self, number):
        """Returns the picture of the paper before a step, from 1 on, and its caption."""
        before, after = self.papers[number - 1:number + 1]
        layers = self.layers[number - 1]
        words = self.text.words(after.step)
        move = Move(before, self.views[number - 1], after, self.views[number])
        flat = words.moves or move.farthest(layers)
        start, end = move.start(flat), move.end(flat)
        picture = self.picture(layers, end[:2])
        picture.draw_paper()
        picture.draw_lines(lines_to_crease(layers, after))
        picture.draw_arrow(picture.at(flat), picture.place(end[:2]), end[2] < start[2])
        picture.draw_marks([(name, picture.at(flat)) for name, flat in self.text.places.marks.items()])
        caption = words.caption
        next_step = self.papers[number + 1].step if number + 1 < len(self.papers) else 0
        turns = self.text.turns_over(after.step, next_step)
        lines = wrapped("%d. %s%s" % (number, caption, " Turn over." if turns else ""))
        if turns:
            picture.draw_turn_over(CELL_WIDTH / 2 - 6, AREA_HEIGHT + LINE_HEIGHT * (len(lines) + 1) + 2)
        return picture.elements, lines

    def finished(self, name):
        layers, view = self.layers[-1], self.text.view()
        if view and not layers.is_flat:
            paper = self.papers[-1]
            paper.points = paper.space
            layers = Layers(paper, orbit_view(*view))
        picture = self.picture(layers)
        picture.draw_paper()
        return picture.elements, ["The finished %s." % name]

    def cells(self, name):
        cells = [self.step(number) for number in range(1, len(self.papers))]
        return cells + [self.finished(name)]


def cell_element(cell, index, x, y, last):
    elements, lines = cell
    name = "finished" if last else "step_%d" % (index + 1)
    texts = [text_element(CELL_WIDTH / 2, AREA_HEIGHT + 4 + LINE_HEIGHT * k, line, 2.8)
             for k, line in enumerate(lines)]
    return '<g id="%s" class="picture" transform="translate(%g %g)">\n%s\n</g>' % (
        name, x, y, "\n".join(elements + texts))


def page(cells, first, count, title, height):
    """Returns a page of SVG with `count` cells, `first` is the first."""
    body = [text_element(WIDTH / 2, MARGIN + 5, title, 5.5, weight="bold")]
    for k, cell in enumerate(cells[first:first + count]):
        x, y = MARGIN + k % COLUMNS * CELL_WIDTH, MARGIN + TITLE + k // COLUMNS * CELL_HEIGHT
        body.append(cell_element(cell, first + k, x, y, first + k == len(cells) - 1))
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="%dmm" height="%gmm" viewBox="0 0 %d %g">\n'
            '<rect width="%d" height="%g" fill="#ffffff"/>\n%s\n</svg>\n' % (
                WIDTH, height, WIDTH, height, WIDTH, height, "\n".join(body)))


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def write_pdf(path, cells, title):
    with tempfile.TemporaryDirectory() as folder:
        pages = []
        for first in range(0, len(cells), COLUMNS * ROWS):
            pages.append(os.path.join(folder, "page_%d.svg" % len(pages)))
            write(pages[-1], page(cells, first, COLUMNS * ROWS, title, HEIGHT))
        subprocess.run(["rsvg-convert", "--format", "pdf", "--output", path, *pages], check=True)


def main(sequence, out, recipe=None):
    papers, name = read_sequence(sequence)
    text = Recipe(recipe, corners_of(papers[0])) if recipe else Titles(papers)
    name = name.replace("_", " ")
    cells = Diagram(papers, text).cells(name)
    rows = -(-len(cells) // COLUMNS)
    height = 2 * MARGIN + TITLE + rows * CELL_HEIGHT
    write(os.path.join(out, "diagram.svg"), page(cells, 0, len(cells), name.capitalize(), height))
    write_pdf(os.path.join(out, "diagram.pdf"), cells, name.capitalize())


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except (OSError, ValueError) as error:
        sys.exit("diagram: %s" % error)
