#!/usr/bin/env python3
"""Lights with a place: usage place_test.py TSUYA

Hair and light moved together look the same, wherever they are, in tiers and techniques of
shadow; a head's skin gets no more light than the light's radiance can give."""
import math
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile

tsuya = sys.argv[1]
failed = 0


def luminance(kind, *words):
    with tempfile.NamedTemporaryFile(suffix='.exr') as picture:
        said = subprocess.run([tsuya, 'render', *words, '-o', picture.name], capture_output=True,
                              text=True, check=True).stdout
    return float(re.search(kind + r' luminance\s+([0-9.e+-]+)', said).group(1))


def write_ball(path, shift):
    """600 straight strands in a ball of radius 0.1 m, as Cem Yuksel's .hair."""
    draw = random.Random(7)
    points = []
    for _ in range(600):
        ends = [[draw.uniform(-0.1, 0.1) for _ in range(3)]]
        ends.append([ends[0][k] + draw.gauss(0.0, 0.03) for k in range(3)])
        points += [[a + b for a, b in zip(end, shift)] for end in ends]
    with path.open('wb') as file:
        file.write(struct.pack('<4s4I5f88s', b'HAIR', 600, len(points), 2, 1, 8e-4, 0.0, 1.0, 1.0,
                               1.0, b'place test'))
        for p in points:
            file.write(struct.pack('<3f', *p))


def check(what, value, low, high):
    global failed
    good = low <= value <= high
    failed += not good
    print(f'{what:64}{value:.5g}', '' if good else f'is not {low:g} to {high:g}')


SHIFTS = (0.0, 0.0, 0.0), (-0.9, 1.7, 0.0)
LIGHTS = {'point': ['light1.intensity=1'], 'disk': ['light1.intensity=1', 'light1.width=0.3',
                                                     'light1.facing=0,-0.1,-0.4'],
          'rect': ['light1.intensity=1', 'light1.width=0.3', 'light1.height=0.2',
                  'light1.facing=0,-0.1,-0.4']}
TIERS = {'marschner': ['deep_opacity'], 'dual_scattering': ['deep_opacity', 'grid']}
with tempfile.TemporaryDirectory() as folder:
    for shift in SHIFTS:
        path = pathlib.Path(folder) / f'{shift[0]}{shift[1]}.hair'
        write_ball(path, shift)
    for kind, words in LIGHTS.items():
        for model, shadows in TIERS.items():
            for shadow in shadows:
                found = []
                for shift in SHIFTS:
                    path = pathlib.Path(folder) / f'{shift[0]}{shift[1]}.hair'
                    place = ','.join(f'{a + b:g}' for a, b in zip(shift, (0.0, 0.1, 0.4)))
                    found.append(luminance(
                        'hair', str(path), '--size', '48x48', 'unit_scale=1', 'light=none', 'dome=0',
                        'background=0,0,0', 'color=brown', 'head=none', f'model={model}',
                        f'shadow={shadow}', f'light1.kind={kind}', f'light1.position={place}', *words))
                check(f'{model}, {shadow}, {kind}: moved over at home',
                      max(found[1:], key=lambda x: abs(x / found[0] - 1.0)) / found[0], 0.98, 1.02)
# A skin of albedo 1 at most, lit by radiance 1: radiance 1 at most, and 1 / pi of its irradiance.
for size, far in (100.0, 0.3), (1.0, 0.3), (0.2, 2.0):
    r, d = size / 2.0, far - 0.1
    light = math.pi * r * r / (r * r + d * d)
    seen = luminance('mean', 'straight-brown', 'strands=200', 'width_scale=0.1', '--size', '48x48', 'light=none', 'dome=0',
                     'background=0,0,0', 'camera.azimuth_deg=0', 'light1.kind=disk',
                     'light1.intensity=1', f'light1.position=0,0,{far}', f'light1.width={size}')
    check(f'skin under a disk {size:g} m wide, {far:g} m away, of its most', seen / (light / math.pi),
          0.02 if size < 10.0 else 0.0, 1.0)
sys.exit(failed > 0)
