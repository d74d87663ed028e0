#!/usr/bin/env python3
"""The committed table is made of the committed measurements. table_test.py ROOT

Costs are those of results/static.csv, which the static gate holds against a fresh run; leaves those
of leaf.csv, lobes those of lobes.csv. The predictor's fit leaves no more in the scenes it was made
from than the table says it leaves in others, and the table knows as many scenes as there are.
"""
import csv
import math
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(root / 'tests/bench'))
import trade_predict as tp  # noqa: E402

errors = []
source, table = tp.embed.read(root / 'runtime/choose/trade.csv')


def rows(path):
    with open(root / path, encoding='utf-8', newline='') as file:
        return list(csv.DictReader(line for line in file if not line.startswith('#')))


def compare(path, wanted):
    """Every row of a file that the table should have."""
    count = 0
    for r in rows(path):
        row = (r['tier'], r['quantity'], r['key'])
        if not wanted(row):
            continue
        count += 1
        if row not in table:
            errors.append(f'{path}: the table has no row {",".join(row)}')
        elif abs(table[row] - float(r['value'])) > 1e-6 * abs(float(r['value'])):
            errors.append(f'{path}: {",".join(row)} is {r["value"]}, in the table {table[row]}')
    if count < 20:
        errors.append(f'{path}: only {count} rows are the table\'s')


compare('tests/bench/results/static.csv', lambda row: row[0] in tp.embed.TIERS)
compare('tests/bench/results/leaf.csv', lambda row: True)
compare('tests/bench/results/lobes.csv', lambda row: row[1] == 'lobe_share')

said = re.search(r'pictures: (\d+) scenes of (\S+?),', '\n'.join(source))
scenes = root / said.group(2) if said else None
if not said or not scenes.is_file():
    errors.append('the table does not say what pictures it is made from')
elif scenes.name == 'trade_scenes.csv':
    ranges = {n: (table['*', 'range', n + '.min'], table['*', 'range', n + '.max'])
              for n in tp.RANGES}
    fits = {t: [[table[t, 'fit_' + what, term] for term in tp.TERMS]
                for what in ('rms', 'luminance')] for t in tp.HAIR}
    pictures = {}
    for r in rows(said.group(2)):
        if r['tier'] in fits and r.get('split') != 'test':
            pictures.setdefault((r['scene'], r['tier']), {})[r['channel']] = r
    if len({scene for scene, _ in pictures}) != int(said.group(1)):
        errors.append(f'{scenes.name} has other scenes than the table')
    for tier in tp.HAIR:
        squares = []
        for (_, name), channels in pictures.items():
            if name == tier:
                inside = [tp.held({n: float(channels[c][n]) for n in tp.RANGES}, ranges)[0]
                          for c in 'rgb']
                rms, _ = tp.predict(*fits[tier], inside)
                true = math.sqrt(max(float(channels['r']['picture_rel_mse']), 1e-12))
                squares.append(math.log(true / rms) ** 2)
        left = math.sqrt(sum(squares) / len(squares))
        print(f'{tier:16} ln rms off by {left:.3f}, stated for new scenes '
              f'{table[tier, "spread", "rms"]:.3f}')
        if not 0.2 * table[tier, 'spread', 'rms'] < left <= table[tier, 'spread', 'rms']:
            errors.append(f'{tier}: the fit is not that of {scenes.name}')
sys.exit('\n'.join(errors) if errors else 0)
