#!/usr/bin/env python3
"""What lobes are worth: the committed figures are those of the code, and true.

    lobes_test.py BENCH_LOBES results/lobes.csv

Energies of TRT and of the residual are summed here once more over impact parameters, ray by ray.
"""

import cmath
import csv
import math
import subprocess
import sys


def read(text):
    lines = [line for line in text.splitlines() if not line.startswith('#')]
    return {(row['quantity'], row['key']): float(row['value']) for row in csv.DictReader(lines)}


def shares(eta, theta, sigma_a, rays=600):
    """Shares of TRT and residual: Marschner et al. 2003, section 4, with Bravais indices."""
    cos, sin = math.cos(theta), math.sin(theta)
    inside = math.sqrt(1 - (sin / eta) ** 2)
    bravais = math.sqrt(eta * eta - sin * sin) / cos
    lobes = [0.0] * 4
    for ray in range(rays):
        gamma = (ray + 0.5) / rays * math.pi / 2
        h, weight = math.sin(gamma), math.cos(gamma)
        # Fresnel at the true angle of incidence.
        a = cos * math.cos(gamma)
        b = cmath.sqrt(1 - (1 - a * a) / eta ** 2).real
        fresnel = 0.5 * (((a - eta * b) / (a + eta * b)) ** 2 + ((b - eta * a) / (b + eta * a)) ** 2)
        way = 2 * math.sqrt(1 - (h / bravais) ** 2) / inside
        kept = math.exp(-sigma_a * way)
        lobes[0] += weight * fresnel
        lobes[1] += weight * (1 - fresnel) ** 2 * kept
        lobes[2] += weight * (1 - fresnel) ** 2 * fresnel * kept ** 2
        lobes[3] += weight * (1 - fresnel) ** 2 * fresnel ** 2 * kept ** 3 / (1 - fresnel * kept)
    return lobes[2] / sum(lobes), lobes[3] / sum(lobes)


def main(bench, committed):
    with open(committed, encoding='utf-8') as file:
        rows = read(file.read())
    fresh = read(subprocess.run([bench], stdout=subprocess.PIPE, text=True, check=True).stdout)
    wrong = [key for key in rows.keys() | fresh.keys()
             if abs(rows.get(key, 9) - fresh.get(key, -9)) > 1.5e-4]
    for key in sorted(wrong):
        print(f'{key}: committed {rows.get(key)}, fresh {fresh.get(key)}')

    sigmas = [float(key.split('/')[1]) for _, key in rows if key.startswith('trt/')]
    worst = 0.0
    for sigma_a in sorted(set(sigmas)):
        truth = [shares(1.55, math.radians(theta), sigma_a) for theta in range(0, 61, 5)]
        for lobe, name in enumerate(('trt', 'residual')):
            key = f'{name}/{sigma_a:g}'
            most = max(share[lobe] for share in truth)
            mean = sum(share[lobe] for share in truth) / len(truth)
            worst = max(worst, abs(rows['lobe_share', key] - most),
                        abs(rows['lobe_share_mean', key] - mean))
            # Other indices are in the range over which the most is stated.
            for eta in (1.3, 1.8):
                if shares(eta, 0.7, sigma_a)[lobe] > rows['lobe_share_any_eta', key] + 2e-4:
                    wrong.append(key)
                    print(f'{key}: more at eta {eta}')
    print(f'{len(rows)} rows; energies of rays differ by {worst:.1e}')

    # More fibres bring more light back, darker ones less.
    back = {}
    for (quantity, key), value in rows.items():
        if key.startswith('back/') and key.count('/') == 2:
            back[tuple(float(word) for word in key.split('/')[1:])] = value
    for (depth, sigma_a), value in back.items():
        deeper = [back[d, s] for d, s in back if s == sigma_a and d > depth]
        darker = [back[d, s] for d, s in back if d == depth and s > sigma_a]
        if not 0 <= value < 1 or min(deeper, default=1) < value - 3e-4 \
                or max(darker, default=0) > value:
            wrong.append((depth, sigma_a))
            print(f'back/{depth:g}/{sigma_a:g} = {value}: not in order')
    return 1 if wrong or worst > 2e-4 or len(back) < 50 else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
