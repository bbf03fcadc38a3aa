#!/usr/bin/python3
"""Golden states: every recipe that folds within a minute ends at the same bits as when test/data/golden.txt was written.

Bits belong to a toolchain: compiler, C library and OpenBLAS. The file names the one that its hashes
are of; CMake registers this test where the compiler is the same. After a change that is meant to
move the paper, write the file anew and say in the commit why:
    test/golden_test.py --write
"""
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
GOLDEN = os.path.join(ROOT, 'test', 'data', 'golden.txt')
BATCH = os.environ.get('ORIGAMI_BATCH', os.path.join(ROOT, 'build/devel/lib/shell_origami/origami_batch'))
LONG = ('crane',)  # folds for minutes
MISSED = 3  # folded to its end, but creases miss their targets
HEAD = ('# recipe, SHA-256 of final.obj (its first 16 digits), steps, Newton iterations, factorizations\n'
        '# g++ 12.2, glibc 2.36, libopenblas0-serial 0.3.21 with its Haswell kernels\n')


def recipes():
    names = [name[:-5] for name in os.listdir(os.path.join(ROOT, 'recipes')) if name.endswith('.yaml')]
    return sorted(name for name in names if name not in LONG)


def fold(recipe):
    """Folds the recipe and returns its line of the file."""
    with tempfile.TemporaryDirectory() as out:
        # One set of kernels on every processor.
        environment = dict(os.environ, OPENBLAS_CORETYPE='Haswell')
        batch = subprocess.run([BATCH, os.path.join(ROOT, 'recipes', recipe + '.yaml'), '--out', out],
                               env=environment, stderr=subprocess.DEVNULL)
        if batch.returncode not in (0, MISSED):
            raise RuntimeError('%s ends with %d' % (recipe, batch.returncode))
        with open(os.path.join(out, 'final.obj'), 'rb') as handle:
            digest = hashlib.sha256(handle.read()).hexdigest()[:16]
        with open(os.path.join(out, 'report.json')) as handle:
            report = json.load(handle)
    return '%s %s %d %d %d' % (recipe, digest, report['steps'], report['newton_iterations'],
                               report['factorizations'])


def write():
    with open(GOLDEN, 'w') as handle:
        handle.write(HEAD + ''.join(fold(recipe) + '\n' for recipe in recipes()))


class GoldenTest(unittest.TestCase):
    def test_every_recipe_ends_at_the_same_bits(self):
        with open(GOLDEN) as handle:
            golden = [line.rstrip('\n') for line in handle if not line.startswith('#')]
        self.assertEqual([fold(recipe) for recipe in recipes()], golden)


if __name__ == '__main__':
    if sys.argv[1:] == ['--write']:
        write()
    else:
        unittest.main()
