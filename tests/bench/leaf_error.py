#!/usr/bin/env python3
"""Errors of the leaf tiers against the transport solver, for each leaf by name.

    leaf_error.py [--tsuya COMMAND] [-o leaf.csv]

Asks `tsuya eval` for what the shaders answer (--on gpu) and what the solver does (--on reference),
both sides, reflected and transmitted, three channels, 4 x 4 cosines of a Gauss rule and 4 azimuths.
Rows of leaf.csv, tier,quantity,key,value:

    error, reflected.NAME and transmitted.NAME    largest error of a lobe, as a fraction of that
                 lobe's peak over these directions (gloss is a lobe of its own); channels and sides
                 that give back less than 0.02 of uniform light are left out, as in the models'
                 error tables
    error, coat.NAME    of a tier without a coat where one is wanted: what the highlight adds, as a
                 fraction of the peak of all that is reflected
    luminance, NAME     error of hemispherical reflectance or transmittance, luminance under white
                 light, uniform light on one side: the larger of both sides and lobes, signed
    luminance, coat.NAME    the same of all that is reflected, where a coat is wanted
    error and luminance without a name: of the model's whole range, as the model states them; of a
                 coat the largest of all names
    *, species, NAME.R_top.r and so on: the leaves' colours

Takes some six minutes of one core.
"""
import argparse
import csv
import math
import pathlib
import json
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
# Gauss-Legendre on (0, 1).
COSINES = (0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263)
WEIGHTS = (0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269)
PHIS = (0, 60, 120, 180)
PHI_WEIGHTS = (1 / 6, 1 / 3, 1 / 3, 1 / 6)
CHANNELS, SIDES, KINDS = 'rgb', ('top', 'bottom'), ('R', 'T')
REC709 = {'r': 0.2126, 'g': 0.7152, 'b': 0.0722}
DIM = 0.02
INDEX = 1.45  # of the presets' walls, the function's default
FUNCTIONS = {'leaf_coarse': 'leaf-coarse', 'leaf_body': 'leaf-body', 'leaf': 'leaf'}
UNIFORM = {'leaf_body': 'leaf_body_uniform', 'leaf': 'leaf_uniform'}


class Failure(Exception):
    """What went wrong, as one sentence."""


def run(words, text=None):
    done = subprocess.run(words, input=text, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, check=False)
    if done.returncode:
        raise Failure(f'{" ".join(words)}: {done.stderr.strip()}')
    return done.stdout


def directions():
    """All (channel, side, kind, i, o, k) of a leaf."""
    return [(c, s, t, i, o, k) for c in CHANNELS for s in SIDES for t in KINDS
            for i in range(len(COSINES)) for o in range(len(COSINES)) for k in range(len(PHIS))]


def ask(tsuya, function, place, names):
    """{(name, direction): (lobe, specular)}."""
    asked = [(name, d) for name in names for d in directions()]
    lines = ['preset,channel,side,kind,mu0,mu,phi_deg']
    for name, (c, s, t, i, o, k) in asked:
        lines.append(f'{name},{c},{s},{t},{COSINES[i]!r},{COSINES[o]!r},{PHIS[k]}')
    answer = csv.DictReader(run([tsuya, 'eval', function, '--on', place],
                                '\n'.join(lines) + '\n').splitlines())
    result = {}
    for (name, d), row in zip(asked, answer):
        lobe = float(row['transmitted' if d[2] == 'T' else 'reflected'])
        result[name, d] = (lobe, float(row.get('specular') or 0.0) if d[2] == 'R' else 0.0)
    if len(result) != len(asked):
        raise Failure(f'tsuya eval {function}: {len(result)} rows of {len(asked)}')
    return result


def hemisphere(values, name, c, s, t):
    """All light that the lobe sends back or through of uniform light on one side, no gloss."""
    total = 0.0
    for i, wi in enumerate(WEIGHTS):
        for o, wo in enumerate(WEIGHTS):
            for k, wk in enumerate(PHI_WEIGHTS):
                total += (4.0 * math.pi * wi * wo * wk * COSINES[i] * COSINES[o] *
                          values[name, (c, s, t, i, o, k)][0])
    return total


def lobe_errors(found, truth, name):
    """{'R': error, 'T': error} as fractions of the peaks."""
    worst = dict.fromkeys(KINDS, 0.0)
    for c in CHANNELS:
        for s in SIDES:
            for t in KINDS:
                if hemisphere(truth, name, c, s, t) <= DIM:
                    continue
                some = [d for d in directions() if d[:3] == (c, s, t)]
                for lobe in (0, 1):  # the body's, then gloss, each of its own peak
                    peak = max(truth[name, d][lobe] for d in some)
                    off = max(abs(found[name, d][lobe] - truth[name, d][lobe]) for d in some)
                    worst[t] = max(worst[t], off / peak if peak > 0.0 else 0.0)
    return worst


def coat_error(truth, body, name):
    """What is missing without a coat, of the peak of all that is reflected."""
    worst = 0.0
    for c in CHANNELS:
        for s in SIDES:
            some = [d for d in directions() if d[:3] == (c, s, 'R')]
            peak = max(sum(truth[name, d]) for d in some)
            off = max(abs(body[name, d][0] - sum(truth[name, d])) for d in some)
            worst = max(worst, off / peak)
    return worst


def luminance_error(found, truth, name, kinds=KINDS, gloss=0.0):
    """Signed, the largest over sides and kinds; gloss: what the truth reflects besides."""
    worst = 0.0
    for s in SIDES:
        for t in kinds:
            a, b = (sum(REC709[c] * hemisphere(v, name, c, s, t) for c in CHANNELS)
                    for v in (found, truth))
            if abs(a / (b + gloss) - 1.0) > abs(worst):
                worst = a / (b + gloss) - 1.0
    return worst


def gloss_hemisphere(tsuya, name):
    """What the default coat reflects of uniform light, by a fine midpoint rule."""
    n, phis = 40, 24
    grid = [((i + 0.5) / n, (o + 0.5) / n, (k + 0.5) * 180 / phis)
            for i in range(n) for o in range(n) for k in range(phis)]
    text = 'preset,mu0,mu,phi_deg\n' + ''.join(f'{name},{i!r},{o!r},{k!r}\n' for i, o, k in grid)
    answer = csv.DictReader(run([tsuya, 'eval', 'leaf', '--on', 'gpu'], text).splitlines())
    return sum(4.0 * math.pi * i * o * float(row['specular'])
               for (i, o, _), row in zip(grid, answer)) / len(grid)


def colors(tsuya, names):
    """Rows of the leaves' colours: of light along the normal, the mirror's reflection included."""
    asked = [(name, c, s, t, o) for name in names for c in CHANNELS for s in SIDES for t in KINDS
             for o in range(len(COSINES))]
    lines = [f'{n},{c},{s},{t},1,{COSINES[o]!r}' for n, c, s, t, o in asked]
    answer = csv.DictReader(run([tsuya, 'eval', 'leaf-body', '--on', 'reference'],
                                '\n'.join(['preset,channel,side,kind,mu0,mu'] + lines) +
                                '\n').splitlines())
    sums = {}
    for (n, c, s, t, o), row in zip(asked, answer):
        lobe = float(row['transmitted' if t == 'T' else 'reflected'])
        sums[n, c, s, t] = (sums.get((n, c, s, t), 0.0) +
                            2.0 * math.pi * WEIGHTS[o] * COSINES[o] * lobe)
    mirror = ((INDEX - 1.0) / (INDEX + 1.0)) ** 2
    rows = []
    for n in names:
        for side, (s, t) in {'R_top': ('top', 'R'), 'R_bottom': ('bottom', 'R'),
                             'T': ('top', 'T')}.items():
            rows += [('*', 'species', f'{n}.{side}.{c}',
                      sums[n, c, s, t] + (mirror if t == 'R' else 0.0)) for c in CHANNELS]
    return rows


def stated(models, model, name):
    for m in models:
        if m['name'] == model and name in m['error']:
            return m['error'][name]['value']
    raise Failure(f'{model} states no error {name}')


def measure(tsuya, models, names):
    rows = colors(tsuya, names)
    body = ask(tsuya, 'leaf-body', 'reference', names)
    coated = ask(tsuya, 'leaf', 'reference', names)
    truths = {'leaf_coarse': body, 'leaf_body': body, 'leaf': coated}
    gloss = gloss_hemisphere(tsuya, names[0])
    for tier, function in FUNCTIONS.items():
        found = ask(tsuya, function, 'gpu', names)
        own = []
        for name in names:
            worst = lobe_errors(found, truths[tier], name)
            own.append(('error', f'reflected.{name}', worst['R']))
            own.append(('error', f'transmitted.{name}', worst['T']))
            own.append(('luminance', name, luminance_error(found, truths[tier], name)))
            if tier != 'leaf':
                own.append(('error', f'coat.{name}', coat_error(truths['leaf'], body, name)))
                own.append(('luminance', f'coat.{name}',
                            luminance_error(body, truths['leaf'], name, ('R',), gloss)))
        source = 'leaf_body' if tier == 'leaf' else tier
        own.append(('error', 'reflected', stated(models, source, 'reflected')))
        own.append(('error', 'transmitted', stated(models, source, 'transmitted')))
        own.append(('luminance', 'leaf', stated(models, source, 'power')))
        if tier != 'leaf':
            for quantity in ('error', 'luminance'):
                coats = [v for q, k, v in own if q == quantity and k.startswith('coat.')]
                own.append((quantity, 'coat', max(coats, key=abs)))
        for name in (tier, UNIFORM.get(tier)):
            rows += [(name, *row) for row in own if name]
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--tsuya', default='tsuya', help='the command (default: on the PATH)')
    parser.add_argument('-o', type=pathlib.Path, default=HERE / 'results/leaf.csv')
    options = parser.parse_args()
    try:
        models = json.loads(run([options.tsuya, 'models', '--json']))['models']
        preset = next(i for m in models if m['name'] == 'leaf_body' for f in m['functions']
                      if f['name'] == 'leaf-body' for i in f['inputs'] if i['name'] == 'preset')
        names = [n for n in preset['unit'].split('|') if n != 'none']
        rows = measure(options.tsuya, models, names)
    except (Failure, OSError) as failure:
        print(f'leaf_error: {failure}', file=sys.stderr)
        return 1
    with open(options.o, 'w', encoding='utf-8') as out:
        out.write('# Leaf tiers (llvmpipe) against the transport solver, made by '
                  'tests/bench/leaf_error.py: 4 x 4 cosines, 4 azimuths, both sides, 3 channels\n')
        out.write('tier,quantity,key,value\n')
        out.writelines(f'{t},{q},{k},{v:.6g}\n' for t, q, k, v in rows)
    for tier in FUNCTIONS:
        most = {}
        for t, quantity, key, value in rows:
            if t == tier and quantity == 'error' and '.' in key:
                what = key.split('.')[0]
                most[what] = max(most.get(what, 0.0), value)
        print(f'{tier:12} ' + ', '.join(f'{what} {value:.4f}' for what, value in most.items()))
    return 0


if __name__ == '__main__':
    sys.exit(main())
