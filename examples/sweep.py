#!/usr/bin/python3
"""Folds many papers at once, each by random folds of its own seed, on Dask (Debian's python3-distributed):

    examples/sweep.py --papers 100 --workers 2
    examples/sweep.py --papers 100 --scheduler tcp://host:8786

Without --scheduler it starts workers on this machine. What comes out does not depend on the workers, nor on
the order in which they are done; papers of a worker that is lost are folded by others. Writes a line of JSON
for each paper, in the order of their seeds."""

import argparse
import hashlib
import json
import math
import random
import sys

SIDE = 0.1            # [m]
FOLDS = 3             # of each paper
RETRIES = 3           # of a paper whose worker is lost


def fold_paper(seed):
    """Folds a square by random lines. Returns what became of it, and a hash of where it is."""
    from shell_origami import core  # on the worker
    dice = random.Random(seed)
    paper = core.Simulation(SIDE, SIDE, 0.01)
    rejected = 0
    for _ in range(FOLDS):
        line = [(dice.uniform(0, SIDE), dice.uniform(0, SIDE)) for _ in range(2)]
        angle = math.radians(dice.uniform(-150, 150))
        try:
            paper.fold(line=line, angle=angle, duration=0.5)
            paper.step(60)
        except (ValueError, core.SimulationError):
            rejected += 1
    return {'seed': seed, 'rejected': rejected, 'creases': len(paper.creases),
            'max_strain': paper.max_strain, 'crossings': paper.crossings(),
            'hash': hashlib.sha256(paper.positions.tobytes()).hexdigest()[:16]}


def sweep(client, seeds, tell=lambda done: None):
    """Folds the papers of these seeds on a Dask client. Returns their results in the seeds' order."""
    from distributed import as_completed
    futures = client.map(fold_paper, seeds, retries=RETRIES, pure=False)
    for done, _ in enumerate(as_completed(futures), 1):
        tell(done)
    return client.gather(futures)


def main():
    parser = argparse.ArgumentParser(description='Folds many papers at once, on Dask.')
    parser.add_argument('--papers', type=int, default=100)
    parser.add_argument('--workers', type=int, default=2, help='processes on this machine')
    parser.add_argument('--scheduler', help='address of a Dask scheduler, such as tcp://host:8786')
    options = parser.parse_args()
    if options.papers < 1 or options.workers < 1:
        parser.error('--papers and --workers are at least 1')
    from distributed import Client, LocalCluster
    where = options.scheduler or LocalCluster(n_workers=options.workers, threads_per_worker=1,
                                              dashboard_address=None)

    def tell(done):
        sys.stderr.write('\r%d of %d papers' % (done, options.papers) + '\n' * (done == options.papers))

    with Client(where) as client:
        for result in sweep(client, range(options.papers), tell):
            print(json.dumps(result, sort_keys=True))
    if not options.scheduler:
        where.close()


if __name__ == '__main__':
    main()
