#!/usr/bin/env python3
"""`tsuya reference` and `tsuya compare` against the sweep of the trade table, and what compare
refuses.

    compare_test.py /path/to/tsuya /path/to/trade_sweep

Prints one line a case; exits 1 when one fails.
"""

import csv
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'demo'))
from command_support import CASES, Wrong, case, expect, output, refused, run, use  # noqa: E402

SMALL = ['straight-brown', 'strands=1000', 'width_scale=20', '--size', '24x24']
TIERS = ['unshadowed', 'kajiya_kay', 'marschner', 'zinke', 'exact', 'plane_parallel']
SCENE = '2'  # number of the sweep's scene


@case
def figures_are_those_of_the_sweep():
    """Another seed of the paths and another way to standard errors, the same figures."""
    with tempfile.TemporaryDirectory() as folder:
        scene, rows, truth = (folder + '/' + name for name in ('a.scene', 'a.csv', 'a.exr'))
        words = subprocess.run([SWEEP, '--print', SCENE], capture_output=True, check=True)
        pathlib.Path(scene).write_bytes(words.stdout)
        subprocess.run([SWEEP, rows, '--from', SCENE, '--count', '1', '--samples', '48'],
                       check=True)
        output('reference', scene, '--samples', '48', '--seed', '77', '-o', truth)
        said = json.loads(output('compare', scene, '--all', '--reference', truth, '--json'))
        expect(said['samples'] == 48 and said['hair_pixels'] > 100, said)
        expect([tier['tier'] for tier in said['tiers']] == TIERS, said)
        with open(rows, encoding='utf-8') as file:
            swept = {row['tier']: row for row in csv.DictReader(file) if row['channel'] == 'r'}
        for tier in (tier for tier in said['tiers'] if tier['tier'] != 'zinke'):  # not swept
            row = swept[tier['tier']]
            for here, there in (('rel_mse', 'picture_rel_mse'), ('luminance', 'luminance_error')):
                error = math.hypot(tier[here + '_se'], float(row[there + '_se']))
                off = (tier[here] - float(row[there])) / error
                print(f"{tier['tier']} {here} {tier[here]:.4f} +- {tier[here + '_se']:.4f}, sweep "
                      f"{row[there]} +- {row[there + '_se']}: {off:+.2f} errors off")
                expect(abs(off) < 3.5 and tier[here + '_se'] > 0.0, tier)
            expect(abs(tier['rms'] ** 2 - max(tier['rel_mse'], 0.0)) < 1e-9, tier)


@case
def words_and_maps():
    with tempfile.TemporaryDirectory() as folder:
        truth, picture = folder + '/a.exr', pathlib.Path(folder, 'm.png')
        output('reference', *SMALL, '--samples', '8', '-o', truth)
        # What the renderer alone reads may differ.
        said = output('compare', *SMALL, 'model=kajiya_kay', 'exposure=1', 'tier=zinke', 'tier=exact',
                      '--reference', truth, '--map', str(picture))
        lines = [line.split() for line in said.splitlines() if line.startswith(('zinke', 'exact'))]
        expect([line[0] for line in lines] == ['zinke', 'exact'], said)
        values = json.loads(output('compare', *SMALL, 'tier=exact', '--reference', truth, '--json',
                                   '--map', str(picture)))['tiers'][0]
        expect(abs(float(lines[1][1]) - values['rel_mse']) < 1e-4, said)
        expect(abs(float(lines[1][4]) - values['rms']) < 1e-4, said)
        expect(abs(float(lines[1][7]) - 100.0 * values['luminance']) < 0.01, said)
        names = sorted(path.name for path in pathlib.Path(folder).glob('*.png'))
        expect(names == ['m.png', 'm_exact.png', 'm_zinke.png'], names)
        tiles = pathlib.Path(folder, 'sheet.png')
        output('compare', *SMALL, 'tier=exact', '--reference', truth, '--sheet', str(tiles))
        width, height = struct.unpack('>II', tiles.read_bytes()[16:24])
        expect(width == 2 * 24 + 4 and height > 2 * 24, (width, height))
        width, height = struct.unpack('>II', picture.read_bytes()[16:24])
        expect((width, height) == (24, 24 + 1 + 4), (width, height))
        expect(picture.read_bytes() == pathlib.Path(folder, 'm_exact.png').read_bytes(), 'maps')


@case
def bad_input_is_named():
    with tempfile.TemporaryDirectory() as folder:
        truth, drawn = folder + '/a.exr', folder + '/drawn.exr'
        output('reference', *SMALL, '--samples', '2', '-o', truth)
        output('render', *SMALL, '-o', drawn)
        pathlib.Path(folder, 'text.exr').write_text('no picture')
        given = ['--reference', truth]

        def no(words, *parts):
            refused(['compare', *words], None, *parts)

        no([], 'no scene')
        no(['no-such-scene', 'tier=exact', *given], 'no-such-scene')
        no([*SMALL, *given], 'tier=NAME', 'unshadowed')
        no([*SMALL, 'tier=fast', *given], 'no tier fast', 'plane_parallel')
        no([*SMALL, 'tier=', *given], 'no tier ""')
        no([*SMALL, 'tier=leaf', *given], 'tier=leaf', 'no reference')
        no([*SMALL, 'tier=exact', 'tier=exact', *given], 'tier=exact', 'twice')
        no([*SMALL, 'tier=exact', '--all', *given], 'tier=exact', '--all')
        no([*SMALL, 'tier=exact'], '--reference FILE.exr is missing')
        no([*SMALL, 'tier=exact', '--reference', folder + '/none.exr'], 'none.exr')
        no([*SMALL, 'tier=exact', '--reference', folder + '/text.exr'], 'text.exr', 'not an EXR')
        no([*SMALL, 'tier=exact', '--reference', drawn], 'drawn.exr', 'se.R', 'tsuya reference')
        no([*SMALL, 'tier=exact', *given, '--map', folder + '/m.jpg'], 'm.jpg', '.png')
        no([*SMALL, 'tier=exact', 'dome=-1', *given], 'dome', '[0, 10000]')
        no([*SMALL[:-1], '25x24', 'tier=exact', *given], '24x24', '25x24')
        no([*SMALL, 'dome=2', 'tier=exact', *given], 'another scene', 'dome is 1.5 there and 2')
        no([*SMALL, 'color=red', 'tier=exact', *given], 'another scene', 'color')
        no([*SMALL, 'beta_R_deg=9', 'tier=exact', *given], 'another scene', 'beta_R_deg', '9 here')
        no([*SMALL, 'light0.intensity=1', 'tier=exact', *given], 'another scene', 'lightN')
        no(['leaf', 'tier=leaf', *given], 'tier=leaf')
        no(['leaf', '--all', *given], 'leaf', 'hair alone')
        done = run('compare', *SMALL, 'tier=exact', *given, '--map', folder + '/no/m.png')
        expect(done.returncode == 1 and b'no/m.png' in done.stderr, done.stderr.decode())


def main():
    global SWEEP
    if len(sys.argv) != 3:
        print('usage: compare_test.py /path/to/tsuya /path/to/trade_sweep', file=sys.stderr)
        return 2
    use(str(pathlib.Path(sys.argv[1]).resolve()))
    SWEEP = str(pathlib.Path(sys.argv[2]).resolve())
    failed = 0
    for function in CASES:
        name = function.__name__.replace('_', ' ')
        try:
            function()
            print('pass', name, flush=True)
        except (Wrong, subprocess.SubprocessError, ValueError, KeyError, OSError) as why:
            failed += 1
            print('FAIL', name + ':', why, flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
