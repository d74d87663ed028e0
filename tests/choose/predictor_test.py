#!/usr/bin/env python3
"""The library's predictor against the one that the table is fitted with.

    predictor_test.py ROWS TRADE_CSV

ROWS prints scenes at random and the library's answers; tests/bench/trade_predict.py answers the
same from TRADE_CSV, with the C library's exp and log. They agree within the float that is printed.
"""
import csv
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'bench'))
import trade_predict as tp  # noqa: E402


def main(program, path):
    _, table = tp.embed.read(path)
    ranges = {n: (table['*', 'range', n + '.min'], table['*', 'range', n + '.max'])
              for n in tp.RANGES}
    fits = {t: [[table[t, 'fit_' + what, term] for term in tp.TERMS]
                for what in ('rms', 'luminance')] for t in tp.HAIR}
    text = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
    worst, seen, beyond = 0.0, set(), 0
    for row in csv.DictReader(text.splitlines()):
        channels, outside = [], set()
        for c in 'rgb':
            scene = {n: float(row['' + c if n == 'sigma_a' else n]) for n in tp.RANGES}
            inside, out = tp.held(scene, ranges)
            channels.append(inside)
            # The library says nothing of a thousandth beyond an end.
            outside |= {n for n in out if abs(scene[n] - inside[n]) > 2e-3 * abs(inside[n]) + 2e-6}
        said = {n for i, n in enumerate(tp.RANGES) if int(row['outside']) >> i & 1}
        if not outside <= said:
            sys.exit(f'{row}: outside are {sorted(outside)}, said {sorted(said)}')
        rms, luminance = tp.predict(*fits[row['tier']], channels)
        off = max(abs(float(row['error']) / rms - 1.0),
                  abs((1.0 + float(row['luminance'])) / (1.0 + luminance) - 1.0))
        if not off < 2e-6:
            sys.exit(f'{row}: {rms} and {luminance} expected')
        worst = max(worst, off)
        beyond += bool(said)
        seen.add(row['tier'])
    if seen != set(tp.HAIR) or beyond < 10:
        sys.exit(f'too few rows: tiers {sorted(seen)}, {beyond} beyond the ranges')
    print(f'largest difference {worst:.2g}')


if __name__ == '__main__':
    main(*sys.argv[1:])
