#!/usr/bin/env python3
"""What the image table says, and the claims it has to hold.

    claims.py IMAGES.csv                     print the table, check the claims
    claims.py IMAGES.csv SWEEP FOLDER        with TSUYA_LONG=1 also run the program SWEEP into
                                             FOLDER with another seed, check its table and hold it
                                             against the first

Exit 1 when a claim does not hold.
"""

import collections
import csv
import math
import os
import pathlib
import statistics
import subprocess
import sys

COLORS = ('black', 'brown', 'blond', 'white', 'dyed')
EQUAL = 1.05  # ratio of costs that are not told apart: frames of one tier differ by more
# The method as published costs more than the tiers that correct it and errs more: not on offer.
NOT_OFFERED = ('zinke',)
KEY = ('groom', 'color', 'light', 'dome', 'tier', 'size')
failed = []


def claim(what, holds):
    print(f'{"holds" if holds else "FAILS"}: {what}')
    if not holds:
        failed.append(what)


def read(path):
    lines = [line for line in pathlib.Path(path).read_text('utf-8').splitlines()
             if line and line[0] != '#']
    rows = list(csv.DictReader(lines))
    for row in rows:
        for name, value in row.items():
            if name not in ('groom', 'color', 'light', 'tier', 'scene'):
                row[name] = float(value)
    return rows


def mean_of(rows, name):
    """Mean of absolute values of a figure, and its standard error."""
    n = len(rows)
    error = math.sqrt(sum(row[name + '_se'] ** 2 for row in rows)) / n
    return sum(abs(row[name]) for row in rows) / n, error


def summary(rows):
    """Print the tiers. Returns: by name, cost, mean rel MSE, its error, rows."""
    by_tier = collections.defaultdict(list)
    for row in rows:
        by_tier[row['tier']].append(row)
    # The processor's time for a frame; a median, since the first frame of a tier compiles.
    cost = {tier: statistics.median(r['cost'] for r in of) for tier, of in by_tier.items()}
    tiers = {}
    print(f'{"tier":16}{"cost":>6}{"rel MSE":>18}{"|mean error|, %":>17}' +
          ''.join(f'{c + ":":>8}{"MSE":>8}{"mean":>7}' for c in COLORS))
    for tier in by_tier:
        of = by_tier[tier]
        mse, mse_error = mean_of(of, 'rel_mse')
        mean, _ = mean_of(of, 'mean_error')
        line = f'{tier:16}{cost[tier]:6.2f}{mse:10.4f} +-{mse_error:6.4f}{100 * mean:17.1f}'
        for color in COLORS:
            some = [r for r in of if r['color'] == color]
            if some:
                line += (f'{mean_of(some, "rel_mse")[0]:16.4f}'
                         f'{100 * mean_of(some, "mean_error")[0]:7.1f}')
        print(line)
        tiers[tier] = (cost[tier], mse, mse_error, of)
    return tiers


def by_cost(tiers):
    """Names by cost; where costs are as good as equal, as they stand in the file."""
    order = list(tiers)
    for _ in order:
        for i in range(len(order) - 1):
            if tiers[order[i]][0] > EQUAL * tiers[order[i + 1]][0]:
                order[i:i + 2] = order[i + 1], order[i]
    return order


def check(rows, whole):
    big = [r for r in rows if r['size'] == 256 and r['dome'] == 1.5]
    cells = {(r['groom'], r['color'], r['light']) for r in big}
    grooms = sorted({c[0] for c in cells})
    print(f'{len(cells)} cells; grooms: {", ".join(grooms)}')
    claim('every colour and light of every groom is there',
          len(cells) == len(grooms) * 3 * len(COLORS) and {'straight', 'curly'} <= set(grooms) and
          (len(grooms) >= 3 or not whole))
    tiers = summary(big)
    best = min(tiers, key=lambda t: tiers[t][1])
    for row in tiers[best][3]:
        if row['color'] == 'blond':
            print(f'  {best} on blond, {row["groom"]}, {row["light"]}: '
                  f'{100 * row["mean_error"]:+.1f} +- {100 * row["mean_error_se"]:.1f} %')
    mean, _ = mean_of([r for r in tiers[best][3] if r['color'] == 'blond'], 'mean_error')
    claim(f'on blond the best tier, {best}, misses the mean luminance by {100 * mean:.1f} <= 10 %',
          mean <= 0.1)
    for name in NOT_OFFERED:
        claim(f'{name} is dominated: {best} costs less and errs less',
              tiers[best][0] < tiers[name][0] and tiers[best][1] < tiers[name][1])
    order = by_cost({name: tier for name, tier in tiers.items() if name not in NOT_OFFERED})
    print('by cost:', ', '.join(f'{t} {tiers[t][0]:.2f}' for t in order))
    for cheap, dear in zip(order, order[1:]):
        margin = 3 * math.hypot(tiers[cheap][2], tiers[dear][2])
        claim(f'rel MSE does not rise from {cheap} to {dear}: {tiers[cheap][1]:.4f}, '
              f'{tiers[dear][1]:.4f}', tiers[dear][1] <= tiers[cheap][1] + margin)
    smallest = min(t[1] for t in tiers.values())
    claim('standard errors of mean rel MSE are a fifth of the smallest at most',
          all(t[2] <= smallest / 5 for t in tiers.values() if t[1] < 10 * smallest))


def compare(committed, again):
    by_key = {tuple(r[k] for k in KEY): r for r in committed}
    count = beyond = 0
    for row in again:
        old = by_key.get(tuple(row[k] for k in KEY))
        for name in ('mean_error', 'rel_mse') if old else ():
            count += 1
            # The last digit of the file is 1e-5.
            error = math.hypot(row[name + '_se'], old[name + '_se'], 1e-5)
            beyond += abs(row[name] - old[name]) > 3 * error
    print(f'{count} figures again, {beyond} beyond 3 standard errors')
    claim('a hundredth of the figures at most is beyond 3 standard errors of the committed ones',
          count > 0 and beyond <= 0.01 * count)


committed = read(sys.argv[1])
check(committed, True)
if len(sys.argv) == 4 and os.environ.get('TSUYA_LONG') == '1':
    path = pathlib.Path(sys.argv[3]) / 'images.csv'
    path.unlink(missing_ok=True)
    subprocess.run([sys.argv[2], str(path), '--seed', '2', '--samples', '32'], check=True)
    again = read(path)
    check(again, False)
    compare(committed, again)
sys.exit(bool(failed))
