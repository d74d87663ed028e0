#!/usr/bin/env python3
"""Runs chooser_test.cpp: chooser_test.py TRADE_SWEEP CHOOSER_TEST SCENES.csv FOLDER

Measures ten of the committed scenes again, all with TSUYA_LONG=1, with other paths of light.
"""

import csv
import os
import pathlib
import subprocess
import sys

sweep, judge, scenes, folder = sys.argv[1:]
with open(scenes, encoding='utf-8', newline='') as file:
    rows = csv.DictReader(line for line in file if not line.startswith('#'))
    seeds = sorted({int(row['scene']) for row in rows})
seeds = seeds if os.environ.get('TSUYA_LONG') == '1' else seeds[:10]
again = pathlib.Path(folder) / f'chooser_again_{len(seeds)}.csv'
again.unlink(missing_ok=True)
starts = [seed for seed in seeds if seed - 1 not in seeds]
ends = [seed for seed in seeds if seed + 1 not in seeds]
for first, last in zip(starts, ends):
    subprocess.run([sweep, str(again), '--from', str(first), '--count', str(last - first + 1),
                    '--paths', '1', '--samples', '48'], check=True)
sys.exit(subprocess.run([judge, scenes, str(again)], check=False).returncode)
