#!/usr/bin/python3
"""Makes a Markdown table of a run of origami_bench:
   bench/table.py BENCH.json [RESULTS_DIR COMMIT]
With a folder the table also becomes a section of RESULTS_DIR/<machine>.md, the newest first, in the
place of one of the same day and commit."""
import json
import math
import os
import re
import sys

DEGREES_ASKED = 0.1


def machine():
    """Model and number of cores."""
    with open('/proc/cpuinfo') as file:
        model = re.search(r'model name\s*:\s*(.*)', file.read()).group(1)
    return '%s, %d cores' % (model.strip(), os.cpu_count())


def named(run):
    """Benchmarks by (name, argument)."""
    result = {}
    for benchmark in run['benchmarks']:
        parts = benchmark['name'].split('/')
        size = int(parts[1]) if len(parts) > 1 and parts[1].isdigit() else 0
        result[parts[0], size] = benchmark
    return result


def table(head, rows):
    if not rows:
        return
    yield ''
    yield '| %s |' % ' | '.join(head)
    yield '| --- |' + ' ---: |' * (len(head) - 1)
    for row in rows:
        yield '| %s |' % ' | '.join(row)


def number(value):
    return '%.3g' % value if abs(value) < 1000 else '%.0f' % value


def scene_row(name, b):
    parts = [b[part + '_ms'] for part in ('assembly', 'symbolic', 'numeric', 'solve', 'search')]
    rest = b['step_mean_ms'] - sum(parts)
    times = [b['step_median_ms'], b['step_mean_ms'], *parts, rest, b['edit_ms']]
    counts = [b['newton'], b['factorizations'], b['retries'], b['real_time_factor']]
    return ([name, number(b['triangles'])] + [number(x) for x in times + counts] +
            ['%d (%d)' % (b['allocations'], b['cholmod_allocations'])])


def scenes(benchmarks):
    """Times in milliseconds."""
    rows = [scene_row(name, b) for (name, _), b in benchmarks.items()
            if 'step_median_ms' in b and 'contacts_max' not in b]
    yield from table(['scene, ms a step', 'triangles', 'median', 'mean', 'assembly', 'symbolic',
                      'numeric', 'solve', 'search', 'rest', 'an edit', 'Newton',
                      'factorizations', 'retries', 'real time', 'allocations (CHOLMOD)'], rows)


def contact_row(name, b):
    counts = [b[key] for key in ('newton', 'newton_median', 'newton_p95', 'newton_max', 'factorizations',
                                 'factorizations_p95', 'factorizations_max', 'contacts_max', 'gap_um', 'crossings')]
    times = [b['step_median_ms'], b['step_mean_ms'], b['step_max_ms']]
    limit = number(b['step_over_contact_limit']) if 'step_over_contact_limit' in b else ''
    return [name, number(b['triangles'])] + [number(x) for x in times] + [limit] + [number(x) for x in counts]


def contact(benchmarks):
    """Times in milliseconds. Steps over their limit are those of every twentieth step that touches,
    crossings those of every tenth step."""
    rows = [contact_row(name, b) for (name, _), b in benchmarks.items() if 'contacts_max' in b]
    yield from table(['contact, ms a step', 'triangles', 'median', 'mean', 'longest', 'step / limit', 'Newton',
                      'median', '95 %',
                      'most', 'factorizations', '95 %', 'most', 'pairs', 'smallest gap, um', 'crossings'], rows)


def limit_row(b, dgemm):
    rate = b['factorization_GFlop'] / (b['own_numeric_ms'] / 1e3)
    return [number(b['triangles']), number(b['step_over_limit']),
            '%.0f %%' % (100 * b['assembly_ms'] / b['step_mean_ms']),
            number(b['limit_numeric_ms']), number(b['limit_solve_ms']), b['label'],
            number(b['own_numeric_ms']), number(b['own_solve_ms']),
            number(b['factorization_allocations']),
            number(rate) + (', %.0f %%' % (100 * rate / dgemm) if dgemm else '')]


def limits(benchmarks):
    dgemm = benchmarks.get(('dgemm', 0), {}).get('GFlop_per_s')
    rows = [limit_row(b, dgemm) for b in benchmarks.values() if 'step_over_limit' in b]
    yield from table(['triangles', 'step / limit', 'assembly', 'limit: numeric, ms', 'solve, ms',
                      'by', 'own: numeric, ms', 'solve, ms', 'allocations', 'GFlop/s, of dgemm'],
                     rows)


def growth(benchmarks):
    """Exponent of the cost of a step in the number of triangles."""
    small, large = (benchmarks.get(('first_fold', size)) for size in (2000, 50000))
    if not (small and large):
        return None
    return (math.log(large['step_median_ms'] / small['step_median_ms']) /
            math.log(large['triangles'] / small['triangles']))


def accuracy_row(size, b):
    end, way = re.match('end (.*), way (.*)', b['label']).groups()
    held = '' if b['end_deg'] <= DEGREES_ASKED else ' **off**'
    return ["dog's angles, %d triangles, at the end and on the way" % size,
            '%s deg (%s)%s, %s deg (%s)' % (number(b['end_deg']), end, held,
                                            number(b['way_deg']), way)]


def figures(benchmarks):
    rows = []
    if ('dgemm', 0) in benchmarks:
        dgemm = benchmarks['dgemm', 0]
        rows.append(['dgemm', '%s GFlop/s, kernels for %s' % (number(dgemm['GFlop_per_s']),
                                                              dgemm['label'])])
    if ('triad', 0) in benchmarks:
        rows.append(['triad', number(benchmarks['triad', 0]['GB_per_s']) + ' GB/s'])
    if growth(benchmarks) is not None:
        rows.append(['first fold: a step grows from 2,000 to 50,000 triangles with their power',
                     number(growth(benchmarks))])
        rows.append(['peak memory, first fold at 50,000 triangles',
                     number(benchmarks['first_fold', 50000]['peak_memory_MB']) + ' MB'])
    for (name, size), b in benchmarks.items():
        if name == 'explicit':
            keys = ('explicit_over_implicit', 'explicit_s_per_s', 'implicit_s_per_s',
                    'stable_step_us')
            rows.append(['explicit over implicit cost, %d triangles' % size,
                         '%s (%s against %s s a simulated second, steps of %s us)' %
                         tuple(number(b[key]) for key in keys)])
        if name == 'accuracy':
            rows.append(accuracy_row(size, b))
        if name == 'node':
            rows.append(['node outside the solver, watched at 30 Hz, dog at %d triangles' % size,
                         '%.0f %% of %s s' % (100 * b['outside'], number(b['wall_s']))])
        if name.startswith('edit'):
            rows.append(['%s, %d triangles' % (name, size), number(b['real_time']) + ' ms'])
    yield from table(['', ''], rows)


def page(run):
    benchmarks = named(run)
    return '\n'.join([*scenes(benchmarks), *contact(benchmarks), *limits(benchmarks), *figures(benchmarks)]) + '\n'


HEAD = """# {machine}

Written by `scripts/bench`. A step's parts are means; what is left of the mean is `rest`, and real
time is simulated over wall time at a time step of 1/60 s. The limit is one factorization and one
solve of the matrix halfway through the dog's first fold by the fastest of several settings of
CHOLMOD, against which the median step stands; `own` is the solver's own factorization. Allocations
are the median step's. The dog's angles are held against a run with a tenth of the time step and a
tolerance of 1e-7 m/s.
"""


def write(path, title, text):
    sections = {}
    if os.path.exists(path):
        with open(path) as file:
            parts = re.split(r'^## (.*)\n', file.read(), flags=re.MULTILINE)
        sections = dict(zip(parts[1::2], parts[2::2]))
    sections = {title: text + '\n', **{k: v for k, v in sections.items() if k != title}}
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as file:
        file.write(HEAD.format(machine=machine()))
        file.writelines('\n## %s\n%s\n' % (k, v.rstrip('\n')) for k, v in sections.items())


def main():
    with open(sys.argv[1]) as file:
        run = json.load(file)
    text = page(run)
    print(text)
    if len(sys.argv) > 2:
        folder, commit = sys.argv[2:]
        name = re.sub(r'\W+', '_', machine().lower()).strip('_')
        path = os.path.join(folder, name + '.md')
        write(path, '%s, %s' % (run['context']['date'][:10], commit), text)
        print('written to ' + path)


if __name__ == '__main__':
    main()
