"""What every paper is, as ~sheet and ~state show it, whatever was asked of it."""

import collections
import math

# Of an edge. Between creases that lie close to each other, and that pins keep from folding, some
# hundredths are real; what float32 leaves of a length is below that.
MOST_STRAIN = 0.1
# While creases of a pattern fold, paper gives way in its plane; a triangle collapses at 0.95.
MOST_STRAIN_OF_SOFT_PAPER = 0.5


class Broken(AssertionError):
    pass


def require(holds, sentence, *values):
    if not holds:
        raise Broken(sentence % values)


def edges_of(triangle):
    a, b, c = triangle.vertex_indices
    return (a, b), (b, c), (c, a)


def double_area(p, q, r):
    """Of a flat triangle, positive where its corners go counter-clockwise [m^2]."""
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)


def area(sheet):
    """Of the flat sheet [m^2]."""
    flat = sheet.flat_positions
    return sum(double_area(*(flat[v] for v in t.vertex_indices)) for t in sheet.triangles) / 2


def distance(p, q):
    return math.sqrt((p.x - q.x) ** 2 + (p.y - q.y) ** 2 + (p.z - q.z) ** 2)


def check_sheet(sheet):
    """Its triangles are the right way round, and meet along edges, some of which are creases."""
    flat = sheet.flat_positions
    require(all(math.isfinite(c) for p in flat for c in (p.x, p.y)), 'a flat point is not finite')
    sides = collections.Counter()
    for number, triangle in enumerate(sheet.triangles):
        require(all(v < len(flat) for v in triangle.vertex_indices),
                'triangle %d names a vertex that is none', number)
        corners = [flat[v] for v in triangle.vertex_indices]
        require(double_area(*corners) > 0, 'triangle %d lies on its back', number)
        sides.update(edges_of(triangle))
    # In two triangles, which then pass it in both directions, or in one.
    require(max(sides.values()) == 1, 'an edge is in more than two triangles')
    ids = [crease.id for crease in sheet.creases]
    require(len(set(ids)) == len(ids), 'two creases have one id')
    for crease in sheet.creases:
        require(len(crease.vertices) >= 2, 'crease %d is no line', crease.id)
        for a, b in zip(crease.vertices, crease.vertices[1:]):
            require((a, b) in sides and (b, a) in sides, 'crease %d leaves the edges at vertex %d',
                    crease.id, a)


def check_state(sheet, state):
    """Every edge of the sheet is about as long in space as it is flat."""
    require(state.revision == sheet.revision, 'the state is of another sheet')
    flat, now = sheet.flat_positions, state.positions
    require(len(now) == len(flat), '%d positions for %d vertices', len(now), len(flat))
    require(all(math.isfinite(c) for p in now for c in (p.x, p.y, p.z)), 'a position is not finite')
    require(all(v < len(now) for v in state.pinned), 'a pin holds no vertex')
    require([c.id for c in state.creases] == [c.id for c in sheet.creases], 'creases are others')
    for crease in state.creases:
        angles = crease.angle, crease.rest_angle, crease.target_angle
        require(all(abs(angle) < math.pi for angle in angles), 'crease %d is shut', crease.id)
    most = MOST_STRAIN if state.settled else MOST_STRAIN_OF_SOFT_PAPER
    for triangle in sheet.triangles:
        for a, b in edges_of(triangle):
            flat_length = distance(flat[a], flat[b])
            strain = distance(now[a], now[b]) / flat_length - 1
            require(abs(strain) < most, 'edge %d, %d of %g m is strained by %g', a, b,
                    flat_length, strain)
