"""The figures of the verification, from the CSV files that origami_verify wrote."""
import csv
import math
import os

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402 (the backend has to be chosen before)
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402

plt.rcParams.update({'figure.figsize': (5.6, 3.8), 'figure.dpi': 110, 'axes.grid': True,
                     'grid.alpha': 0.3, 'axes.spines.top': False, 'axes.spines.right': False,
                     'font.size': 9, 'legend.frameon': False, 'lines.markersize': 4})
COLOURS = ['#1b6ca8', '#d1495b', '#3a8f5c', '#8a5fbf', '#c77f1a', '#555555']


def read(folder, name):
    """Returns the rows as dictionaries; values that are numbers become floats."""
    with open(os.path.join(folder, name + '.csv'), newline='') as file:
        rows = list(csv.DictReader(file))

    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    return [{key: value(text) for key, text in row.items()} for row in rows]


def groups(rows, key):
    """Returns (value, rows, color) for each value of a column, in order."""
    values = list(dict.fromkeys(row[key] for row in rows))
    return [(value, [row for row in rows if row[key] == value], COLOURS[i % len(COLOURS)])
            for i, value in enumerate(values)]


def column(rows, key):
    return [row[key] for row in rows]


def slope(axes, x, y, order, label):
    """A dashed line of this order through the first point."""
    axes.plot(x, [y[0] * (at / x[0]) ** order for at in x], 'k--', linewidth=0.8, label=label)


def few_decades(axis):
    """Labels 1, 2 and 5 of each decade of a logarithmic axis on which powers of ten are too few."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter('{x:g}')
    axis.set_minor_formatter(NullFormatter())


def cantilever_shape(rows, axes):
    for gamma, of, colour in groups(rows, 'gamma'):
        exact, mesh = [[row for row in of if row['kind'] == kind] for kind in (0, 1)]
        axes.plot(column(exact, 'x'), column(exact, 'z'), color=colour, label=r'$\Gamma$ = %g' % gamma)
        axes.plot(column(mesh, 'x'), column(mesh, 'z'), 'o', color=colour, markersize=2.5)
    axes.set(xlabel='x / L', ylabel='z / L', aspect='equal')
    axes.legend(loc='lower left')


def cantilever_convergence(rows, axes):
    for gamma, of, colour in groups(rows, 'gamma'):
        x = column(of, 'row')
        axes.loglog(x, [abs(row['endless_drop_error']) for row in of], 'o-', color=colour,
                    label=r'$\Gamma$ = %g' % gamma)
        axes.loglog(x, [abs(row['drop_error']) for row in of], ':', color=colour)
    slope(axes, x, [abs(row['endless_drop_error']) for row in of], 2, 'order 2')
    axes.set(xlabel='height of a row of triangles / L', ylabel='error of the tip drop / L')
    axes.set_ylim(1e-5, None)
    few_decades(axes.xaxis)
    axes.legend()


def vibration(rows, axes):
    time = column(rows, 'periods')
    amplitude = 0.01
    axes.plot(time, [math.sin(2 * math.pi * t) for t in time], 'k', linewidth=0.8, label='closed form')
    axes.plot(time, [row['tip'] / amplitude for row in rows], 'o', color=COLOURS[0], markersize=1.5,
              label='tip deflection')
    axes.plot(time, [1e5 * (row['energy'] - 1) for row in rows], color=COLOURS[1], linewidth=0.9,
              label=r'energy, change in $10^{-5}$')
    axes.set(xlabel='time / period of the closed form', ylabel='tip / amplitude')
    axes.legend(loc='lower left', ncol=3, fontsize=8)
    axes.set_ylim(-1.5, 1.2)


def time_order(rows, axes):
    for scheme, of, colour in groups(rows, 'scheme'):
        axes.loglog(column(of, 'steps_per_period'), column(of, 'difference'), 'o-', color=colour,
                    label=scheme)
        order = -2 if 'gamma = 1/2' in scheme else -1
        slope(axes, column(of, 'steps_per_period'), [0.7 * y for y in column(of, 'difference')], order,
              None)
    axes.set(xlabel='steps per period', ylabel='change of the state by halving the step')
    axes.set_ylim(1e-6, None)
    axes.legend(fontsize=8, loc='lower left')


def cylinder(rows, axes):
    for direction, of, colour in groups(rows, 'direction'):
        # The mesh is nearly symmetric: dashes let the mirrored direction be seen.
        axes.loglog(column(of, 'max_edge'), [abs(row['ratio'] - 1) for row in of],
                    'o-' if direction <= 90 else 'o--', color=colour, label='%g degrees' % direction)
    x = column(of, 'max_edge')
    axes.loglog(x, [edge / 0.1 for edge in x], 'k--', linewidth=0.8, label='edge / side')
    axes.set(xlabel='longest edge [m]', ylabel='relative error of the energy')
    few_decades(axes.xaxis)
    axes.legend(ncol=2, fontsize=8)


def crease_moment(rows, axes):
    stiffness = 5e-3
    angles = [0.5 * i for i in range(6, 345)]
    tangents = [math.tan(math.radians(angle) / 2) for angle in angles]
    axes.semilogy(angles, [stiffness * 2 * t * (1 + t * t) for t in tangents], 'k', linewidth=0.9,
                  label=r'$c\,\phi\,\sec^2(\theta/2)$')
    axes.semilogy(column(rows, 'angle'), column(rows, 'moment'), 'o', color=COLOURS[1],
                  label='a weight on the flap')
    axes.set(xlabel='fold angle [degrees]', ylabel='moment per length [N]')
    axes.legend()


def degree4(rows, axes):
    for twisted, of, colour in groups(rows, 'twisted'):
        way = r'$\rho_0 = -\rho_2$' if twisted else r'$\rho_0 = \rho_2$'
        axes.plot(column(of, 'rho0'), column(of, 'exact1'), color=colour, linewidth=0.9,
                  label='closed form, ' + way)
        axes.plot(column(of[::20], 'rho0'), column(of[::20], 'rho1'), 'o', color=colour, markersize=3,
                  label='simulation')
    axes.set(xlabel='driven crease 0 [degrees]', ylabel='free crease 1 [degrees]')
    axes.legend()


def miura(rows, axes):
    acute = math.radians(60)
    angles = range(0, 180)
    halves = [math.radians(angle) / 2 for angle in angles]
    across = [math.cos(g) * math.tan(acute) for g in halves]
    exact = {'length': [math.sqrt(1 - (math.sin(g) * math.sin(acute)) ** 2) for g in halves],
             'width': [u / math.sqrt(1 + u * u) for u in across]}
    for name, colour in (('length', COLOURS[0]), ('width', COLOURS[1])):
        axes.plot(angles, exact[name], color=colour, linewidth=0.9, label=name + ', closed form')
        axes.plot(column(rows, 'angle'), column(rows, name), 'o', color=colour, label='simulation')
    axes.set(xlabel='fold angle of the zigzags [degrees]', ylabel='of a panel / its side')
    axes.legend()


def waterbomb(rows, axes):
    axes.plot(column(rows, 'valley'), column(rows, 'exact'), 'k', linewidth=0.9, label='closed form')
    axes.plot(column(rows, 'valley'), column(rows, 'mountain'), 'o', color=COLOURS[1],
              label='simulation')
    axes.set(xlabel='driven valleys [degrees]', ylabel='free mountains [degrees]')
    axes.legend()


def cone(rows, axes):
    angles = [0.5 * i for i in range(10, 71)]
    axes.plot(angles, [math.degrees(math.acos(1 - angle / 180)) for angle in angles], 'k',
              linewidth=0.9, label=r'$\arccos(1 - \alpha / \pi)$')
    axes.plot(column(rows, 'alpha'), column(rows, 'slope'), 'o', color=COLOURS[1], label='simulation')
    axes.set(xlabel=r'angle between the creases $\alpha$ [degrees]', ylabel='slope [degrees]')
    axes.legend()


def flat_folded(rows, axes):
    for model, of, colour in groups(rows, 'model'):
        axes.loglog(column(of, 'd'), column(of, 'distance'), 'o-', color=colour, label=model)
    x = column(of, 'd')
    slope(axes, x, [0.8 * y for y in column(of, 'distance')], 1, 'order 1')
    axes.set(xlabel='d [degrees]', ylabel='largest distance / size of the sheet')
    few_decades(axes.xaxis)
    few_decades(axes.yaxis)
    axes.legend(fontsize=8)


def pressed_crease(rows, axes):
    gaps = [0.0012 + 0.00005 * i for i in range(65)]
    for hardening, of, colour in groups(rows, 'hardening'):
        axes.semilogx([1000 * gap for gap in gaps],
                      [math.degrees((1.332 - 1.690 * math.log(200 * gap)) / (1 + hardening))
                       for gap in gaps], color=colour, label='formula, hardening %g' % hardening)
        axes.semilogx([1000 * row['gap'] for row in of], column(of, 'simulated'), 'o', color=colour,
                      label='simulation')
    axes.set(xlabel='gap [mm]', ylabel='angle that is kept [degrees]', xticks=[1.5, 2, 3, 4])
    axes.xaxis.set_major_formatter('{x:g}')
    axes.xaxis.set_minor_formatter('')
    axes.legend()


FIGURES = [
    ('3 Order in time', time_order, 'Change of the state after 1.25 periods when the time step is '
     'halved. Dashed: orders 2 and 1.'),
    ('4 First frequency of a cantilever', vibration, 'The tip of a clamped sheet that starts flat '
     'with the velocities of its first mode; the energy of the same run.'),
    ('4 Cantilever under its own weight', cantilever_shape, 'Lines: the heavy elastica. Dots: the '
     'finest mesh, one dot for each row of vertices; the first two rows are held.'),
    ('4 Cantilever under its own weight', cantilever_convergence, 'Full lines: extrapolated to '
     'infinite breadth. Dotted: the sheet three times as wide as long, whose free sides curl. This '
     'adds to the drop, so that the error changes its sign.'),
    ('5 Energy of a cylinder', cylinder, 'Directions from the rows of triangles.'),
    ('6 Crease opened by a moment', crease_moment, 'A crease with a rest angle of zero.'),
    ('7 Flat-foldable vertex of four creases', degree4, 'Sectors of 110, 50, 70 and 130 degrees.'),
    ('8 Miura-ori', miura, '6 x 6 panels of 60 degrees.'),
    ('9 Waterbomb base', waterbomb, ''),
    ("10 The apple's cone", cone, ''),
    ('11 Flat-folded states', flat_folded, 'Creases folded to 180 - d degrees, against the flat '
     'sheet reflected in them.'),
    ('17 Creases pressed into paper', pressed_crease, 'A strip of copy paper that plates press to a '
     'gap.'),
]


def draw(results, folder):
    """Draws all figures; returns (item, name, caption) of each."""
    drawn = []
    for item, figure, caption in FIGURES:
        canvas, axes = plt.subplots()
        figure(read(results, figure.__name__), axes)
        canvas.tight_layout()
        canvas.savefig(os.path.join(folder, figure.__name__ + '.png'), metadata={'Software': None})
        plt.close(canvas)
        drawn.append((item, figure.__name__, caption))
    return drawn
