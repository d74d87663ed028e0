#!/usr/bin/env python3
"""Makes the trade table, runtime/choose/trade.csv, from what was measured. Needs numpy.

    trade.py [--tsuya COMMAND] [--scenes FILE] [--try FILE] [-o trade.csv]

    tests/bench/results/static.csv       clocks and the like, fetches (static gate)
    tests/bench/results/lobes.csv        light that is lost with a lobe
    tests/bench/results/leaf.csv         errors and colours of leaves (leaf_error.py)
    tests/reference/trade_scenes.csv     pictures of random scenes against traced ones
    tests/reference/images.csv           the same for grooms and colours by name: means a tone
    tests/bench/results/*-*.csv          ns a pixel as ratios, measured (tsuya bench --csv)

The predictor (trade_predict.py): ln of a channel's relative MSE, and of its mean over the true one,
as polynomials in seven traits, by least squares with weights 1 / (variance + s0^2) and a ridge.
What is printed tells how often a choice by it holds: for scenes left out of the fit, and for those
of --try (or with split "test"), which it never saw.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import subprocess
import sys

import numpy as np

import trade_predict as tp

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = ROOT / 'tests/bench/results'
SCENES = ROOT / 'tests/reference/trade_scenes.csv'
IMAGES = ROOT / 'tests/reference/images.csv'
NOISE = 0.15  # s0: what no polynomial follows, so that quiet scenes do not rule the fit
RIDGES = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0)
FOLDS = 10
CHEAP = 0.91  # of scenes left out


class Failure(Exception):
    """What is missing, as one sentence."""


def rows_of(path):
    """Rows of a CSV with a head, lines with # left out."""
    with open(path, encoding='utf-8', newline='') as file:
        return list(csv.DictReader(line for line in file if not line.startswith('#')))


def long_form(path):
    """{(tier, quantity, key): value as text} of a table in long form; {} without the file."""
    if not path.is_file():
        return {}
    return {(r['tier'], r['quantity'], r['key']): r['value'] for r in rows_of(path)}


class Scene:
    """One scene: traits of its three channels, and what each tier does in it."""

    def __init__(self, name, split):
        self.name, self.split = name, split
        self.channels = [None] * 3
        self.rms, self.luminance = {}, {}  # tier -> channel -> (value, standard error)
        self.picture = {}                  # tier -> (relative MSE, luminance error)

    def whole(self):
        return (None not in self.channels and set(self.rms) >= set(tp.HAIR)
                and all(len(v) == 3 for v in self.rms.values()))


def random_scenes(path):
    """The scenes of trade_scenes.csv."""
    found = collections.OrderedDict()
    for row in rows_of(path):
        scene = found.setdefault(row['scene'], Scene(row['scene'], row.get('split') or 'table'))
        c, tier = 'rgb'.index(row['channel']), row['tier']
        scene.channels[c] = {n: float(row[n]) for n in tp.RANGES}
        scene.rms.setdefault(tier, {})[c] = (float(row['rel_mse']), float(row['rel_mse_se']))
        scene.luminance.setdefault(tier, {})[c] = (float(row['mean_ratio']),
                                                   float(row['mean_ratio_se']))
        if row.get('picture_rel_mse'):
            scene.picture[tier] = (float(row['picture_rel_mse']), float(row['luminance_error']))
    return list(found.values())


class Fit:
    """A polynomial by least squares with weights and a ridge; `names` are the terms it may use."""

    def __init__(self, points, names, ridge):
        """points: (terms, value, deviation) each."""
        use = [i for i, t in enumerate(tp.TERMS) if t in names]
        a = np.array([p[0] for p in points])[:, use]
        y = np.array([p[1] for p in points])
        weight = 1.0 / (np.array([p[2] for p in points]) ** 2 + NOISE ** 2)
        # Terms in units of their spread, so that one ridge suits all; the constant is free.
        middle = np.average(a, axis=0, weights=weight)
        scale = np.sqrt(np.average((a - middle) ** 2, axis=0, weights=weight))
        live = scale > 1e-9
        b = (a[:, live] - middle[live]) / scale[live]
        level = np.average(y, weights=weight)
        normal = (b * weight[:, None]).T @ b
        normal += ridge * weight.mean() * np.eye(normal.shape[0])
        slope = np.linalg.solve(normal, (b * weight[:, None]).T @ (y - level)) / scale[live]
        self.coefficients = [0.0] * len(tp.TERMS)
        for i, s in zip(np.array(use)[live], slope):
            self.coefficients[i] += float(s)
        self.coefficients[0] += float(level - middle[live] @ slope)


def points_of(scenes, tier, what):
    """(terms, logarithm, deviation) for each channel of each scene."""
    points = []
    for scene in scenes:
        for c, channel in enumerate(scene.channels):
            value, error = getattr(scene, what)[tier][c]
            if value > 0.0:
                points.append((tp.terms(channel), math.log(value), error / value))
    return points


def truth(scene, tier):
    """(rms, luminance error) of the picture; from the channels where it is not told."""
    if tier in scene.picture:
        mse, luminance = scene.picture[tier]
        return math.sqrt(max(mse, 1e-12)), luminance
    mse = sum(scene.rms[tier][c][0] for c in range(3)) / 3.0
    weights = [tp.weight(c, scene.channels[c]['sigma_a']) for c in range(3)]
    gain = sum(w * scene.luminance[tier][c][0] for c, w in enumerate(weights)) / sum(weights)
    return math.sqrt(max(mse, 1e-12)), gain - 1.0


def fit_tier(scenes, tier, names, ridge):
    return tuple(Fit(points_of(scenes, tier, what), names, ridge).coefficients
                 for what in ('rms', 'luminance'))


def left_out(scenes, tier, names, ridge):
    """Predictions for each scene from the others, whole scenes left out by folds."""
    result = {}
    for fold in range(min(FOLDS, len(scenes))):
        out = scenes[fold::FOLDS]
        rest = [s for s in scenes if s not in out]
        fits = fit_tier(rest, tier, names, ridge)
        for scene in out:
            result[scene.name] = tp.predict(*fits, scene.channels)
    return result


def spreads(scenes, tier, predicted):
    """Deviations of ln rms and of ln(1 + luminance)."""
    off = [[], []]
    for scene in scenes:
        true, guess = truth(scene, tier), predicted[scene.name]
        off[0].append(math.log(true[0] / guess[0]))
        off[1].append(math.log((1.0 + true[1]) / (1.0 + guess[1])))
    return [math.sqrt(sum(x * x for x in values) / len(values)) for values in off]


def choose(scene, clocks, predicted, spread, bound, z):
    """The chooser's rule: the cheapest within the bound, equal costs by error, else the least."""
    high = {t: predicted[t][scene.name][0] * math.exp(z * spread[t][0]) for t in tp.HAIR}
    good = [t for t in tp.HAIR if high[t] <= bound]
    if not good:
        return min(tp.HAIR, key=lambda t: high[t]), False
    least = min(clocks[t] for t in good)
    return min((t for t in good if clocks[t] <= 1.05 * least), key=lambda t: high[t]), True


def judge(scenes, clocks, predicted, spread, z):
    """Shares of (within the bound, within twice, cost within 1.25) over bounds from 0.1 to 3; only
    scenes and bounds where a tier meets the bound in truth."""
    count, within, twice, cheap = 0, 0, 0, 0
    for scene in scenes:
        true = {t: truth(scene, t)[0] for t in tp.HAIR}
        for i in range(40):
            bound = 0.1 * 30.0 ** ((i + 0.5) / 40.0)
            good = [clocks[t] for t in tp.HAIR if true[t] <= bound]
            if not good:
                continue
            tier, _ = choose(scene, clocks, predicted, spread, bound, z)
            count += 1
            within += true[tier] <= bound
            twice += true[tier] <= 2.0 * bound
            cheap += clocks[tier] <= 1.25 * min(good)
    return [x / max(count, 1) for x in (within, twice, cheap)]


def pick_margin(scenes, clocks, predicted, spread):
    """The greatest z that leaves CHEAP of the choices at a cost within 1.25: all that can be spent
    on safety; prints the course."""
    print('     z   within the bound   within twice   cost within 1.25')
    best = None
    for i in range(0, 33):
        z = i / 16.0
        shares = judge(scenes, clocks, predicted, spread, z)
        if i % 2 == 0:
            print(f'{z:6.3f} {100 * shares[0]:12.1f} % {100 * shares[1]:14.1f} %'
                  f' {100 * shares[2]:14.1f} %')
        if best is None or shares[2] >= CHEAP:
            best = (z, shares)
    print(f'z = {best[0]}: {100 * best[1][0]:.1f} % within, {100 * best[1][1]:.1f} % within twice, '
          f'{100 * best[1][2]:.1f} % at a cost within 1.25')
    return best[0]


def tones():
    """{(tier, tone): (rms, mean luminance error)} over the cells of images.csv."""
    tiers = {'none': 'unshadowed', 'deep_opacity': 'marschner', 'exact': 'exact',
             'kajiya_kay': 'kajiya_kay', 'plane_parallel': 'plane_parallel'}
    found = collections.defaultdict(list)
    for row in rows_of(IMAGES):
        if row['tier'] in tiers and row['size'] == '256':
            found[tiers[row['tier']], row['color']].append(row)
    return {key: (math.sqrt(sum(float(r['rel_mse']) for r in rows) / len(rows)),
                  sum(float(r['mean_error']) for r in rows) / len(rows))
            for key, rows in found.items()}


class Writer:
    """Rows of the table, in order, each once."""

    def __init__(self):
        self.rows = {}

    def put(self, tier, quantity, key, value):
        if (tier, quantity, key) in self.rows:
            raise Failure(f'{tier},{quantity},{key} would be there twice')
        self.rows[(tier, quantity, key)] = value if isinstance(value, str) else f'{value:.9g}'

    def text(self, source):
        lines = ['# ' + line for line in source] + ['tier,quantity,key,value']
        return '\n'.join(lines + [','.join(row) + ',' + v for row, v in self.rows.items()]) + '\n'


def put_hair(out, fitted, names, ridge):
    """Fits, spreads, means and ranges; returns fits, predictions and spreads of scenes left out."""
    fits, predicted, spread = {}, {}, {}
    for tier in tp.HAIR:
        predicted[tier] = left_out(fitted, tier, names, ridge)
        spread[tier] = spreads(fitted, tier, predicted[tier])
        fits[tier] = fit_tier(fitted, tier, names, ridge)
        for what, fit, s in zip(('rms', 'luminance'), fits[tier], spread[tier]):
            for term, coefficient in zip(tp.TERMS, fit):
                out.put(tier, 'fit_' + what, term, coefficient)
            out.put(tier, 'spread', what, s)
        print(f'{tier:16} ln rms off by {spread[tier][0]:.3f}, ln luminance by '
              f'{spread[tier][1]:.3f}, scenes left out')
    for (tier, name), (rms, luminance) in tones().items():
        out.put(tier, 'rms', name, rms)
        out.put(tier, 'luminance', name, luminance)
    for name in tp.RANGES:
        values = [channel[name] for s in fitted for channel in s.channels]
        out.put('*', 'range', name + '.min', min(values))
        out.put('*', 'range', name + '.max', max(values))
    return fits, predicted, spread


def tell_tried(scenes, fits, ranges, clocks, spread, z):
    """How a choice holds in scenes that the fit never saw."""
    predicted = {t: {s.name: tp.predict(*fits[t], [tp.held(c, ranges)[0] for c in s.channels])
                     for s in scenes} for t in tp.HAIR}
    for tier in tp.HAIR:
        off = spreads(scenes, tier, predicted[tier])
        print(f'{tier:16} ln rms off by {off[0]:.3f}, ln luminance by {off[1]:.3f}, new scenes')
    shares = judge(scenes, clocks, predicted, spread, z)
    print(f'{len(scenes)} new scenes: {100 * shares[0]:.1f} % within, {100 * shares[1]:.1f} % '
          f'within twice, {100 * shares[2]:.1f} % at a cost within 1.25')


def pick_ridge(scenes, names):
    """The ridge that leaves the least in scenes left out, over all tiers."""
    def left(ridge):
        return sum(spreads(scenes, t, left_out(scenes, t, names, ridge))[0] for t in tp.HAIR)
    return min(RIDGES, key=left)


def put_static(out, static, tables):
    """Cost of all tiers; bytes and samplers from what the models say."""
    for tier, (_, model, _, _, _) in tp.embed.TIERS.items():
        # Without shadow it is the same shader.
        asked = 'kajiya_kay' if tier == 'unshadowed' and (tier, 'clocks', 'navi21') not in static \
            else tier
        for (name, quantity, key), value in static.items():
            if name == asked:
                out.put(tier, quantity, key, value)
        if (tier, 'fetches', '') not in out.rows:
            raise Failure(f'static.csv has no row {asked},fetches,')
        if (tier, 'bytes', '') not in out.rows:
            out.put(tier, 'bytes', '', str(tables[model]))
        if (tier, 'samplers', '') not in out.rows:
            fetches = float(out.rows[(tier, 'fetches', '')])
            out.put(tier, 'samplers', '', '1' if fetches > 0 else '0')
        for gpu in tp.GPUS:
            if (tier, 'clocks', gpu) not in out.rows:
                raise Failure(f'static.csv has no row {asked},clocks,{gpu}')


def tables_of(tsuya):
    """Bytes of the tables that each model bakes for the tiers on offer."""
    done = subprocess.run([tsuya, 'models', '--json'], check=True, stdout=subprocess.PIPE,
                          text=True)
    models = json.loads(done.stdout)
    models = models['models'] if isinstance(models, dict) else models
    return {m['name']: sum(t['bytes'] for t in m['tables'] if not t['variant'])
            for m in models}, models


def put_stated(out, models):
    """Errors that the models state, for people: of fibres and of slabs."""
    by_name = {m['name']: {n: e['value'] for n, e in m['error'].items()} for m in models}
    for tier in tp.HAIR:
        model = tp.embed.TIERS[tier][1]
        for level, names in (('fiber', ('hair', 'albedo_default')), ('slab', ('slab_all',))):
            for name in names:
                if name in by_name[model] and tp.embed.TIERS[tier][2] != 'zinke':
                    out.put(tier, 'error', f'{level}.{name}', by_name[model][name])


def commit():
    done = subprocess.run(['git', '-C', ROOT, 'rev-parse', '--short', 'HEAD'], check=True,
                          stdout=subprocess.PIPE, text=True)
    return done.stdout.strip()


def comments(path):
    """First lines of a CSV that say how it was made."""
    if not path.is_file():
        return []
    with open(path, encoding='utf-8') as file:
        return [line[1:].strip() for line in file if line.startswith('#')]


def make(options):
    out = Writer()
    tables, models = tables_of(options.tsuya)
    static = long_form(options.static)
    if not static:
        raise Failure(f'{options.static} is not there')
    put_static(out, static, tables)
    put_stated(out, models)
    scenes = [s for s in random_scenes(options.scenes) if s.whole()]
    names = set(tp.TERMS)
    fitted = [s for s in scenes if s.split != 'test']
    tried = [s for s in scenes if s.split == 'test']
    tried += [s for s in random_scenes(options.tried) if s.whole()] if options.tried else []
    ridge = pick_ridge(fitted, names)
    print(f'{len(fitted)} scenes, ridge {ridge}')
    fits, predicted, spread = put_hair(out, fitted, names, ridge)
    # A scene of two lights with maps and a sky.
    clocks = {t: 14.0 * float(out.rows[t, 'clocks', 'navi21']) +
                 2.0 * float(out.rows.get((t, 'map_clocks', 'navi21'), 0.0)) for t in tp.HAIR}
    z = pick_margin(fitted, clocks, predicted, spread)
    out.put('*', 'margin', 'z', z)
    if tried:
        ranges = {n: [float(out.rows['*', 'range', f'{n}.{end}']) for end in ('min', 'max')]
                  for n in tp.RANGES}
        tell_tried(tried, fits, ranges, clocks, spread, z)
    measured = []
    for path in sorted(RESULTS.glob('*-*.csv')):
        measured += comments(path)
        for (tier, quantity, key), value in long_form(path).items():
            if tier in tp.embed.TIERS and quantity == 'pixel' and key.split('/')[1] in ('lambert', 'ggx'):
                out.put(tier, quantity, key, value)
    leaf = long_form(RESULTS / 'leaf.csv')
    if not leaf:
        raise Failure('tests/bench/results/leaf.csv is not there: run leaf_error.py')
    for row, value in leaf.items():
        out.put(*row, value)
    for row, value in long_form(RESULTS / 'lobes.csv').items():
        if row[1] == 'lobe_share':
            out.put(*row, value)
    source = [f'The trade table, made by tests/bench/trade.py from commit {commit()}.',
              *(f'static cost: {c}' for c in comments(options.static)),
              f'pictures: {len(fitted)} scenes of tests/reference/{SCENES.name}, ridge {ridge}; '
              f'means a tone: {IMAGES.name}',
              *(f'pixels: {c}' for c in measured),
              *(f'leaves: {c}' for c in comments(RESULTS / 'leaf.csv')),
              *(f'lobes: {c}' for c in comments(RESULTS / 'lobes.csv'))]
    return out.text(source)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--tsuya', default='tsuya', help='the command (default: on the PATH)')
    parser.add_argument('--static', type=pathlib.Path, default=RESULTS / 'static.csv')
    parser.add_argument('--scenes', type=pathlib.Path, default=SCENES)
    parser.add_argument('--try', dest='tried', type=pathlib.Path, metavar='FILE',
                        help='scenes as --scenes, not fitted')
    parser.add_argument('-o', type=pathlib.Path, default=ROOT / 'runtime/choose/trade.csv')
    options = parser.parse_args()
    try:
        text = make(options)
    except (Failure, OSError) as failure:
        print(f'trade: {failure}', file=sys.stderr)
        return 1
    options.o.write_text(text, encoding='utf-8')
    print(f'{options.o}: {len(text.splitlines())} lines')
    return 0


if __name__ == '__main__':
    sys.exit(main())
