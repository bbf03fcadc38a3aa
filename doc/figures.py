#!/usr/bin/python3
"""Draws the figures of doc/algorithms.md:
   doc/figures.py RESULTS_DIR ORIGAMI_BATCH
RESULTS_DIR is what origami_verify wrote; ORIGAMI_BATCH is that program. The pictures go to doc/algorithms/."""
import csv
import json
import math
import os
import re
import subprocess
import sys
import tempfile

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402 (the backend has to be chosen before)
import numpy as np  # noqa: E402

DOC = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.join(DOC, '..', 'src', 'shell_origami')
plt.rcParams.update({'figure.dpi': 110, 'axes.grid': True, 'grid.alpha': 0.3, 'axes.spines.top': False,
                     'axes.spines.right': False, 'font.size': 9, 'legend.frameon': False,
                     'lines.markersize': 4})
BLUE, RED, GREEN, GRAY = '#1b6ca8', '#d1495b', '#3a8f5c', '#888888'


def fold(batch, recipe, every=0.1):
    """Folds a recipe (its text); returns the final and the animated FOLD document."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'recipe.yaml')
        with open(path, 'w') as file:
            file.write(recipe)
        # 3: folded to its end, though not all as it was asked for
        code = subprocess.run([batch, path, '--out', folder, '--every', str(every)]).returncode
        if code not in (0, 3):
            raise RuntimeError('origami_batch ended with %d' % code)

        def read(name):
            with open(os.path.join(folder, name)) as file:
                return json.load(file)
        return read('final.fold'), read('frames.fold')


def draw_mesh(axes, document, title):
    flat = np.array(document['vertices_coords'])
    axes.triplot(flat[:, 0], flat[:, 1], document['faces_vertices'], color=GRAY, linewidth=0.5)
    for (a, b), assignment in zip(document['edges_vertices'], document['edges_assignment']):
        if assignment in 'MV':
            axes.plot(flat[[a, b], 0], flat[[a, b], 1], color=BLUE, linewidth=1.8)
    axes.set(aspect='equal', title=title, xticks=[], yticks=[])
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)
    return flat


def edge_making(_, batch):
    """One edit of a coarse sheet: before it, and after it with what it did to the vertices."""
    sheet = 'sheet: {size: [0.1, 0.1], max_edge: 0.02}\nsteps: '
    line = np.array([[0.0, 0.021], [0.1, 0.083]])
    before, _ = fold(batch, sheet + '[]')
    after, _ = fold(batch, sheet + '[{fold: [{line: %s, angle_deg: 1}], duration: 0.1}]' % line.tolist())
    canvas, (left, right) = plt.subplots(1, 2, figsize=(8, 4.1))
    old = draw_mesh(left, before, 'before')
    left.plot(*line.T, '--', color=BLUE, linewidth=1.2)
    new = draw_mesh(right, after, 'after')
    moved = [v for v in range(len(old)) if np.linalg.norm(new[v] - old[v]) > 1e-9]
    for v in moved:
        right.plot(*old[v], 'o', markerfacecolor='none', color=RED, markersize=4)
        right.plot(*np.array([old[v], new[v]]).T, color=RED, linewidth=1)
    right.plot(*new[moved].T, 'o', color=RED, label='shifted (circle: from where)')
    right.plot(*new[len(old):].T, 's', color=GREEN, label='new')
    right.legend(loc='upper center', bbox_to_anchor=(0.5, 0.0), ncol=2)
    return canvas


def crease_energy(results, _):
    """Moment over stiffness of creases that rest at three angles."""
    with open(os.path.join(results, 'crease_law.csv'), newline='') as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    canvas, axes = plt.subplots(figsize=(6.4, 3.8))
    for rest, color in ((0, GREEN), (90, BLUE), (170, RED)):
        of = [row for row in rows if row['rest'] == rest]
        angles = [row['angle'] for row in of]
        axes.plot(angles, [row['moment'] for row in of], color=color, label='rest angle %d°' % rest)
        axes.plot(angles, [row['plain_moment'] for row in of], ':', color=color, linewidth=1)
        axes.plot([rest], [0], 'o', color=color)
    axes.set(xlabel='fold angle [degrees]', ylabel='moment / stiffness', xlim=(-60, 180), ylim=(-4.5, 3))
    axes.legend(loc='lower right')
    return canvas


def rod_solves(predicted):
    """The iterates of Newton's method on a stiff rod that is turned within one step: minimizes
    k/2 e^2 + 1/2 |x - anchor|^2 with the Green strain e = (|x|^2 - 1) / 2."""
    stiffness, anchor = 1e4, np.array([math.cos(0.6), math.sin(0.6)]) * 1.05
    x, stress = np.array([1.0, 0.0]), 0.0
    iterates = [x]
    for _ in range(12):
        strain = (x @ x - 1) / 2
        if not predicted:
            stress = stiffness * strain
        hessian = stiffness * np.outer(x, x) + (stress + 1) * np.eye(2)
        step = -np.linalg.solve(hessian, stiffness * strain * x + x - anchor)
        stress = stiffness * (strain + x @ step)  # to first order
        x = x + step
        iterates.append(x)
    return np.array(iterates)


def newton(_, __):
    """The rod's iterates, and how fast they converge."""
    canvas, (left, right) = plt.subplots(1, 2, figsize=(8, 3.8), gridspec_kw={'width_ratios': [1, 1.5]})
    turn = np.linspace(-0.05, 0.85, 100)
    left.plot(np.cos(turn), np.sin(turn), color=GRAY, linewidth=0.8, label='not stretched')
    exact = rod_solves(True)[-1]
    for predicted, color, label in ((False, RED, "stress of the iterate"), (True, BLUE, 'predicted stress')):
        iterates = rod_solves(predicted)
        left.plot(*iterates[:5].T, 'o-', color=color, linewidth=1)
        errors = np.linalg.norm(iterates - exact, axis=1)
        shown = [i for i, error in enumerate(errors) if error > 1e-13]
        right.semilogy(shown, errors[shown], 'o-', color=color, label=label)
    left.set(aspect='equal', title='iterates of the rod\'s end', xlim=(0.62, 1.12), ylim=(-0.05, 0.72))
    left.legend(loc='lower left', fontsize=8)
    right.set(xlabel='iteration', ylabel='distance from the solution / length', title='convergence')
    right.legend()
    return canvas


def ramps(_, batch):
    """Two folds that run together: rest angles by the formula, angles as simulated."""
    targets, duration = {'first': 170, 'second': 100}, 1.0
    recipe = ('sheet: {size: [0.15, 0.05], max_edge: 0.01}\nsteps:\n  - fold:\n' + ''.join(
        '      - {line: [[%g, 0], [%g, 0.05]], angle_deg: %d, name: %s}\n' % (x, x, targets[name], name)
        for name, x in (('first', 0.05), ('second', 0.1))) + '    duration: %g\n  - settle: {timeout: 0.3}\n' % duration)
    _, film = fold(batch, recipe, 0.05)
    names = {}
    flat = film['vertices_coords']
    for i, (a, b) in enumerate(film['edges_vertices']):
        if film['edges_assignment'][i] in 'MV':
            names.setdefault('first' if flat[a][0] < 0.075 else 'second', []).append(i)
    canvas, axes = plt.subplots(figsize=(6.4, 3.8))
    time = np.linspace(0, duration, 200)
    smooth = time ** 2 * (3 - 2 * time)
    lead = np.radians(targets['first']) * smooth
    part = np.tan(lead / 2) / np.tan(np.radians(targets['first']) / 2)
    follow = 2 * np.arctan(part * np.tan(np.radians(targets['second']) / 2))
    for angles, color, name in ((lead, RED, 'first'), (follow, BLUE, 'second')):
        axes.plot(time, np.degrees(angles), color=color, linewidth=1,
                  label='to %d°: rest angle' % targets[name])
        measured = [np.mean([frame['edges_foldAngle'][i] for i in names[name]])
                    for frame in film['file_frames']]
        instants = [frame['shell_origami:time'] for frame in film['file_frames']]
        axes.plot(instants, measured, 'o', color=color, label='simulated fold angle')
    axes.plot(time, targets['second'] * smooth, ':', color=BLUE, linewidth=1, label='to 100° alone')
    axes.set(xlabel='time since the folds began [s]', ylabel='angle [degrees]')
    axes.legend(loc='upper left', fontsize=8)
    return canvas


def constant(name):
    """A constant of held_frames.cpp."""
    with open(os.path.join(SOURCE, 'node', 'held_frames.cpp')) as file:
        return float(re.search(r'\b%s = ([0-9.e+-]+)' % name, file.read()).group(1))


def held_frames(_, __):
    """HeldFrames' clock for a frame that is sent ten times a second and arrives late."""
    half_life, catch_up, far = constant('kHalfLife'), constant('kCatchUp'), constant('kFarBehind')
    rate, dt = 10.0, 1.0 / 60
    random = np.random.RandomState(1)
    stamps = np.arange(-0.5, 3, 1 / rate)
    arrivals = np.maximum.accumulate(stamps + 0.05 + 0.02 * random.rand(len(stamps)))

    def path(t):
        return np.where(t < 0.3, 0, 0.05 * (1 - np.cos(2.2 * (np.maximum(t, 0.3) - 0.3))))

    played, behind, ends, paper = 0.0, 0.0, np.arange(dt, 2.2, dt), []
    played = stamps[arrivals <= 0][-1]
    for end in ends:
        latest = stamps[arrivals <= end][-1]
        behind = max(end - latest, behind * 2 ** (-dt / half_life))
        played += dt
        lag = end - played - behind
        if lag > far:
            played += lag
        elif lag > 0:
            played += min(lag, catch_up * dt)
        played = min(played, latest)
        paper.append(np.interp(played, stamps, path(stamps)))
    canvas, axes = plt.subplots(figsize=(6.4, 3.8))
    time = np.linspace(0, 2.2, 300)
    axes.plot(time, 1000 * path(time), color=GRAY, linewidth=1, label='the frame')
    shown = (arrivals > 0) & (arrivals < 2.2)
    axes.step(arrivals[shown], 1000 * path(stamps[shown]), where='post', color=RED, linewidth=0.7,
              label='its newest transform, as it arrives')
    axes.plot(ends, 1000 * np.array(paper), color=BLUE, linewidth=1.4, label='the paper')
    axes.set(xlabel='time [s]', ylabel='position [mm]')
    axes.legend(loc='upper left')
    return canvas


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, batch = sys.argv[1:]
    folder = os.path.join(DOC, 'algorithms')
    os.makedirs(folder, exist_ok=True)
    for figure in (edge_making, crease_energy, newton, ramps, held_frames):
        canvas = figure(results, batch)
        canvas.tight_layout()
        canvas.savefig(os.path.join(folder, figure.__name__ + '.png'), bbox_inches='tight',
                       metadata={'Software': None})
        plt.close(canvas)


main()
