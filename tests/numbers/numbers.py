#!/usr/bin/env python3
"""The numbers that tsuya promises, measured through its command and printed as a table.

    numbers.py TSUYA SHADER_COST

Every figure comes from what `tsuya` prints: the GPU path against the double-precision reference on
random rows (seeded), integrals by sums of rows, static shader cost from the compiler of a GPU.
Exit 1 when a figure exceeds its bound. TSUYA_LONG=1 takes ten times as many rows.
"""

import csv
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'bench'))
import cost  # noqa: E402  (the bench's own reader of static cost)
import tiers  # noqa: E402

TSUYA, SHADER_COST = sys.argv[1], sys.argv[2]
LONG = 10 if os.environ.get('TSUYA_LONG') else 1
MESA = '22.3.6'
FAILED = []


def tsuya(*words, text=None):
    done = subprocess.run([TSUYA, *words], input=text, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        sys.exit(f'tsuya {" ".join(words)}: {done.stderr}')
    return done.stdout


def evaluate(function, place, columns, rows, model=None):
    text = ','.join(columns) + '\n' + ''.join(','.join(map(repr, row)) + '\n' for row in rows)
    words = ['eval', function, '--on', place] + (['--model', model] if model else [])
    lines = [line.split(',') for line in tsuya(*words, text=text).splitlines()]
    return [dict(zip(lines[0][len(columns):], map(float, line[len(columns):])))
            for line in lines[1:]]


def report(what, value, bound, unit=''):
    fine = value <= bound
    if not fine:
        FAILED.append(what)
    print(f'{what:68} {value:9.4g}{unit} <= {bound:g}{unit}{"" if fine else "   FAILED"}', flush=True)


def azimuthal():
    columns = ['eta', 'theta_d_deg', 'sigma_a', 'beta_az_deg', 'phi_deg']
    worst, worst_energy, worst_residual, strict = 0.0, 0.0, 0.0, 0.0
    for _ in range(16 * LONG):
        eta, beta = random.uniform(1.3, 1.8), random.uniform(5, 20)
        groups, rows = [], []
        for _ in range(6):
            theta = random.uniform(0, 85)
            for sigma in (0.0, random.uniform(0, 1), random.uniform(0, 5)):
                groups.append((theta, sigma))
                rows += [[eta, theta, sigma, beta, k * 180 / 119] for k in range(120)]
        exact = evaluate('hair-azimuthal', 'reference', columns, rows)
        gpu = evaluate('hair-azimuthal', 'gpu', columns, rows)
        white = 0.0
        for g, (_, sigma) in enumerate(groups):
            a, b = exact[g * 120:g * 120 + 120], gpu[g * 120:g * 120 + 120]
            sums = [(r['R'] + r['TT'] + r['TRT'], s['R'] + s['TT'] + s['TRT']) for r, s in zip(a, b)]
            worst = max(worst, max(abs(x - y) for x, y in sums) / max(x for x, _ in sums))
            total = sum(sum(r[p] for p in ('R', 'TT', 'TRT', 'RES')) for r in a)
            for p in ('R', 'TT', 'TRT', 'RES'):
                off = abs(sum(s[p] for s in b) - sum(r[p] for r in a))
                worst_energy = max(worst_energy, off / total)
            if sigma == 0.0:
                white = max(r['RES'] for r in a)
            off = max(abs(r['RES'] - s['RES']) for r, s in zip(a, b))
            worst_residual = max(worst_residual, off / white)
            strict = max(strict, off / max(r['RES'] for r in a))
    report('gpu N, R+TT+TRT, of its peak over phi', 100 * worst, 0.5, ' %')
    report('gpu N, energy of a lobe, of the total', 100 * worst_energy, 0.5, ' %')
    report('gpu N, residual, of its peak over phi at sigma_a 0', 100 * worst_residual, 2.0, ' %')
    print(f'{"  the same, of its peak at the same sigma_a, which may be 1e-20":68} '
          f'{100 * strict:9.4g} %: 2 % is not reached')


def longitudinal():
    columns = ['theta_i_deg', 'theta_r_deg', 'beta_deg']
    worst = 0.0
    for _ in range(10 * LONG):
        beta = random.uniform(2, 30)
        for theta in [random.uniform(-89, 89) for _ in range(6)]:
            rows = [[max(-89.0, min(89.0, -theta + beta * random.uniform(-4, 4))), theta, beta]
                    for _ in range(200)]
            exact = evaluate('longitudinal', 'reference', columns, rows)
            gpu = evaluate('longitudinal', 'gpu', columns, rows)
            peak = max(r['M'] for r in exact)
            worst = max(worst, max(abs(r['M'] - s['M']) for r, s in zip(exact, gpu)) / peak)
    report("gpu M against d'Eon, of its peak, beta 2..30 degrees", 100 * worst, 0.5, ' %')


HAIR = ['theta_i_deg', 'theta_r_deg', 'phi_deg', 'eta', 'sigma_a', 'alpha_R_deg', 'beta_R_deg',
        'beta_az_deg']


def albedo(place, model, view, material, sigma, thetas=400, phis=24):
    """Integral over all light directions; the highlight gets half of the nodes."""
    rows, weights = [], []
    for i in range(thetas):
        theta = (i + 0.5) / thetas * 180 - 90
        for k in range(phis):
            rows.append([theta, view, (k + 0.5) / phis * 180, material[0], sigma, *material[1:]])
            weights.append(math.cos(math.radians(theta)) * math.pi / thetas * 2 * math.pi / phis)
    values = evaluate('hair', place, HAIR, rows, model)
    return sum(w * v['total'] for w, v in zip(weights, values))


def furnace():
    near = far = 0.0
    for _ in range(8 * LONG):
        material = (random.uniform(1.3, 1.8), random.uniform(-10, 10), random.uniform(5, 20),
                    random.uniform(5, 20))
        for view in (random.uniform(-75, 75), random.choice((-75, 75))):
            near = max(near, abs(albedo('gpu', 'marschner', view, material, 0.0) - 1))
        far = max(far, abs(albedo('gpu', 'marschner', random.choice((-85, 85)), material, 0.0) - 1))
    report('white furnace, gpu, views to 75 degrees', 100 * near, 0.5, ' %')
    report('white furnace, gpu, views to 85 degrees', 100 * far, 2.0, ' %')


def golden():
    """Lobe energies of the reference, eta 1.55; the integral of N over phi."""
    table = {0: (0.07495, 0.86179, 0.05567, 0.00758), 30: (0.08618, 0.84277, 0.06142, 0.00963),
             60: (0.17347, 0.69735, 0.10201, 0.02717), 75: (0.36024, 0.42501, 0.13667, 0.07808)}
    columns, worst = ['eta', 'theta_d_deg', 'sigma_a', 'beta_az_deg', 'phi_deg'], 0.0
    for theta, energies in table.items():
        rows = [[1.55, theta, 0.0, 20.0, k * 2.0] for k in range(180)]
        values = evaluate('hair-azimuthal', 'reference', columns, rows)
        for p, energy in zip(('R', 'TT', 'TRT', 'RES'), energies):
            worst = max(worst, abs(sum(v[p] for v in values) * math.radians(2) - energy))
    report('lobe energies of the reference, from the published five digits', worst, 1.0e-5)


def kajiya_kay():
    worst = 0.0
    for sigma in (0.0, 0.05, 0.2, 1.0):
        for view in (0, 30, 60):
            material = (1.55, -7.5, 7.5, 10.0)
            ratio = (albedo('gpu', 'kajiya_kay', view, material, sigma, 720, 1) /
                     albedo('gpu', 'marschner', view, material, sigma))
            worst = max(worst, abs(ratio - 1))
    report("Kajiya-Kay's albedo over Marschner's, default roughness", 100 * worst, 5.0, ' %')


def static_cost():
    bounds = {'kajiya_kay': 130, 'marschner': 250, 'dual_scattering': 420,
              'plane_parallel_hair': 420, 'leaf_body': 260, 'leaf': 330, 'leaf_coarse': 210}
    uniform = {'leaf_body': 220, 'leaf': 285}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        shaders = [(n, cost.HERE / 'baseline' / f'{n}.frag') for n in cost.BASELINES]
        for model in bounds:
            source = folder / f'{model}_.frag'
            source.write_text(tsuya('glsl', model, '--target', 'vulkan', '--harness'),
                              encoding='utf-8')
            shaders.append((f'tsuya {model}', source))
        for model in uniform:
            # One pigment and thickness: numbers in the host's uniforms, no fetch.
            source = folder / f'{model}_uniform.frag'
            source.write_text(tiers.source(TSUYA, tiers.TIERS[f'{model}_uniform']),
                              encoding='utf-8')
            shaders.append((f'tsuya {model}, uniform', source))
        rows = cost.measure(SHADER_COST, 'navi21', shaders, folder)
    cost.print_table(rows)
    base = [rows[name]['inverse_throughput'] for name in cost.BASELINES]
    if base != [66, 102, 176]:
        print(f'another compiler than Mesa {MESA}: baselines read {base}, not 66, 102, 176')
        FAILED.append(f'static cost needs Mesa {MESA}')
    bounds.update({f'{model}, uniform': bound for model, bound in uniform.items()})
    for model, bound in bounds.items():
        report(f'static cost of {model}, navi21, Mesa {MESA}',
               rows[f'tsuya {model}']['inverse_throughput'], bound)


def slabs():
    """White slabs give no more than they get; the head's colour is in tests/api."""
    def sums_of(variant, angles):
        rows = [(theta, tau) for theta in angles for tau in (0.5, 1, 2, 4, 16, 'inf')]
        text = 'theta_i_deg,sigma_a,tau\n' + ''.join(f'{a},0,{t}\n' for a, t in rows)
        out = csv.DictReader(tsuya('eval', 'hair-multiple', '--on', 'gpu', '--variant', variant,
                                   text=text).splitlines())
        return [float(row['R']) + float(row['T']) for row in out]
    for variant in 'exact', 'plane_parallel':
        along = sums_of(variant, (-90, -89.98, 89.8, 89.9, 89.95, 89.97, 89.99, 90))
        report(f'seen along the fibre, {variant}: R + T above 1', 100 * (max(along) - 1), 1.5, ' %')
        sums = sums_of(variant, (0, 30, 60))
        report(f'white slabs on the GPU, {variant}: R + T above 1', 100 * (max(sums) - 1), 1.5, ' %')
        report('the same, below 1', 100 * (1 - min(sums)), 5, ' %')


PRESETS = ('young_green', 'mature_broadleaf', 'dark_shade', 'thick_waxy', 'grass', 'needle',
           'yellow_autumn', 'red_autumn', 'dry_brown')


def leaves():
    """BRDF and BTDF of the presets on the GPU against the slab solver."""
    cosines = (0.1, 0.45, 1.0)
    rows = []
    for preset in PRESETS:
        for channel in random.choice('rgb'):
            factors = random.choice(((1, 1), (0.25, 0.5), (2, 2), (0.5, 1.3), (1.7, 0.6)))
            for side in 'top', 'bottom':
                for kind in 'RT':
                    rows += [(preset, channel, side, kind, mu0, mu, phi, *factors)
                             for mu0 in cosines for mu in cosines for phi in (0, 100)]
    text = 'preset,channel,side,kind,mu0,mu,phi_deg,absorption,thickness\n' + ''.join(
        ','.join(map(str, row)) + '\n' for row in rows)
    answers = [list(csv.DictReader(tsuya('eval', 'leaf-body', '--on', on, text=text).splitlines()))
               for on in ('gpu', 'reference')]
    lobes = {}
    for row, gpu, true in zip(rows, *answers):
        name = 'reflected' if row[3] == 'R' else 'transmitted'
        lobes.setdefault(row[:4], []).append((float(gpu[name]), float(true[name])))
    bright, dim = 0.0, 0.0
    for values in lobes.values():
        peak = max(true for _, true in values)
        error = max(abs(gpu - true) for gpu, true in values)
        # A Lambert lobe of 0.02 is 0.0064 / sr.
        if peak > 0.0064:
            bright = max(bright, error / peak)
        else:
            dim = max(dim, error)
    report('leaves: lobes of the presets on the GPU, of their peak', 100 * bright, 1.9, ' %')
    report('the same where less than 2 % of light goes, 1/sr', dim, 1e-3)


# PROSPECT-D by its authors (shipped with github.com/jgomezdans/prosail): N 1.2, Cab 30, Car 10,
# Ant 1, Cw 0.015, Cm 0.009 at 400, 420, .. 780 nm; R, T.
RUN_D = '''0.043088,0.000701 0.042020,0.001340 0.041348,0.001487 0.041060,0.005797
0.041099,0.009585 0.044351,0.029129 0.073960,0.104443 0.116165,0.176406 0.125130,0.192810
0.093589,0.147770 0.079865,0.126838 0.064719,0.099508 0.056082,0.081580 0.041735,0.041453
0.036410,0.017985 0.128955,0.210680 0.283872,0.409961 0.359378,0.499282 0.378083,0.522386
0.385428,0.531516'''
# Leaves of PROSPECT-D in three bands: R, T, n.
BANDS = ((0.0650, 0.0787, 1.4483), (0.1630, 0.2124, 1.4737), (0.0429, 0.0122, 1.4942),
         (0.0406, 0.0064, 1.4483), (0.0995, 0.0561, 1.4737), (0.0410, 0.0002, 1.4942),
         (0.2947, 0.2858, 1.4483), (0.2869, 0.2649, 1.4737), (0.0569, 0.0246, 1.4942),
         (0.2414, 0.0958, 1.4483), (0.1836, 0.0564, 1.4737), (0.1037, 0.0176, 1.4942),
         (0.0629, 0.0076, 1.4483), (0.1835, 0.0563, 1.4737), (0.0440, 0.0004, 1.4942))


def contents():
    """What leaves are made of, and the layers that follow."""
    truth = [tuple(map(float, pair.split(','))) for pair in RUN_D.split()]
    rows = [(1.2, 30, 10, 1, 0, 0.015, 0.009, 400 + 20 * i) for i in range(len(truth))]
    columns = ('N', 'Cab', 'Car', 'Ant', 'Cbrown', 'Cw', 'Cm', 'lambda_nm')
    answers = evaluate('prospect', 'reference', columns, rows)
    report('PROSPECT-D against its authors\' output', max(
        max(abs(a['R_leaf'] - R), abs(a['T_leaf'] - T)) for a, (R, T) in zip(answers, truth)), 1e-5)
    rows = [(R, 1.4 * R, T, n) for R, T, n in BANDS]
    answers = evaluate('leaf-layers', 'reference', ('R_top', 'R_bottom', 'T', 'n'), rows)
    report('R_top, R_bottom and T of the layers found for leaves',
           max(a['residual'] for a in answers), 1e-4)


def size():
    models = {m['name']: m for m in json.loads(tsuya('models', '--json'))['models']}
    report('table memory of a hair material', sum(t['bytes'] for t in models['marschner']['tables'])
           / 1024, 128, ' KiB')
    for model in 'dual_scattering', 'plane_parallel_hair':
        report(f'memory that {model} adds', sum(t['bytes'] for t in models[model]['tables']
               if t['name'] != 'azimuthal') / 1024, 128, ' KiB')
    report('table memory of a leaf', sum(t['bytes'] for t in models['leaf']['tables']) / 1024, 16,
           ' KiB')
    text = tsuya('glsl', 'marschner', '--target', '330')
    report('texture fetches a light', text.count('textureLod(') + text.count('texture('), 2)
    report('samplers with every model at once',
           tsuya('glsl', ','.join(models), '--target', '330').count('uniform sampler'), 1)


def main():
    random.seed(2003)
    for part in (golden, azimuthal, longitudinal, furnace, kajiya_kay, slabs, contents, leaves,
                 size, static_cost):
        part()
    if FAILED:
        sys.exit('failed: ' + '; '.join(FAILED))


if __name__ == '__main__':
    main()
