#!/usr/bin/python3
"""Holds the counters of named scenes against bench/counters.json, and fails where one is worse by
more than 5 %:
   bench/gate.py ORIGAMI_BENCH            runs the scenes and compares
   bench/gate.py ORIGAMI_BENCH --write    writes what they are now
Counters do not depend on how busy a machine is, as times do."""
import json
import os
import subprocess
import sys
import tempfile

TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'counters.json')
SCENES = ['dog/2000', 'swing/2000', 'scroll', 'contact_half_fold/500', 'contact_pleats/500',
          'contact_map_arriving/500']
# The fewer the better, each a mean or a median of a step, or a figure of the whole run.
COUNTERS = ['triangles', 'newton', 'factorizations', 'retries', 'allocations', 'contacts_max']
WORSE = 0.05


def run(bench):
    """The counters of each scene, by its name."""
    names = '|'.join('%s%s' % (scene, '' if '/' in scene else '/') for scene in SCENES)
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, 'bench.json')
        subprocess.run([bench, '--benchmark_filter=^(%s)' % names, '--benchmark_out=' + out,
                        '--benchmark_out_format=json'], check=True, stdout=subprocess.DEVNULL)
        with open(out) as file:
            found = json.load(file)['benchmarks']
    return {scene: counters_of(scene, found) for scene in SCENES}


def counters_of(scene, found):
    wanted = [b for b in found if b['name'].startswith(scene + '/')]
    if not wanted:
        sys.exit('gate: there is no benchmark %s' % scene)
    if 'error_occurred' in wanted[0]:
        sys.exit('gate: %s: %s' % (scene, wanted[0].get('error_message')))
    return {name: number(wanted[0][name]) for name in COUNTERS if name in wanted[0]}


def number(value):
    return int(value) if value == int(value) else round(value, 4)


def worse(before, now):
    """Whether a counter has risen by more than the bound, and whole ones by more than one."""
    whole = before == int(before) and now == int(now)
    return now > (1 + WORSE) * before and (not whole or now - before > 1)


def main():
    bench = sys.argv[1]
    now = run(bench)
    if '--write' in sys.argv:
        with open(TABLE, 'w') as file:
            json.dump(now, file, indent=2)
            file.write('\n')
        return
    with open(TABLE) as file:
        table = json.load(file)
    failed = False
    for scene, counters in now.items():
        for name, value in counters.items():
            before = table.get(scene, {}).get(name)
            mark = ''
            if before is None:
                mark = 'not in the table'
            elif worse(before, value):
                mark = 'worse'
            failed |= bool(mark)
            print('%-26s %-16s %10s %10s %s' % (scene, name, before, value, mark))
    if failed:
        sys.exit('gate: worse than %s; where that is wanted, write it anew (--write)' % TABLE)


if __name__ == '__main__':
    main()
