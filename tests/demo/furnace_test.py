#!/usr/bin/env python3
"""A whole head of white hair in a sky of radiance 1: usage furnace_test.py TSUYA

Hair without absorption sends back all that falls on it, so the head vanishes: its luminance is 1.
Holds plane_parallel_hair to 3 %, as its header promises; prints the closed form, the method as
published and the fibre alone, which have no such bound. Hair fills the place of the head, as it
would be dark otherwise."""
import re
import subprocess
import sys
import tempfile

tsuya = sys.argv[1]
SCENE = ['straight-brown', 'color=white', 'light=none', 'dome=1', 'head=none', 'background=1,1,1',
         'strands=3000', 'width_scale=6', 'size=80x80', 'variation=0']
MODELS = {'plane_parallel': ['model=plane_parallel_hair'], 'exact': ['model=dual_scattering'],
          'zinke': ['model=dual_scattering', 'variant=zinke'], 'fibre alone': ['model=marschner']}
failed = 0
for groom in 'straight', 'curly':
    for name, words in MODELS.items():
        with tempfile.NamedTemporaryFile(suffix='.exr') as picture:
            said = subprocess.run([tsuya, 'render', *SCENE, f'groom={groom}', *words, '-o', picture.name],
                                  capture_output=True, text=True, check=True).stdout
        value = float(re.search(r'hair luminance\s+([0-9.]+)', said).group(1))
        held = name == 'plane_parallel'
        good = not held or abs(value - 1) <= 0.03
        failed += not good
        print(f'{groom:9}{name:16}{value:.4f}', '' if good else 'is not 1 +- 0.03')
# Without shadow nothing is known of other hair: the single fibre, one word about it, no energy made.
for name, words in MODELS.items():
    with tempfile.NamedTemporaryFile(suffix='.exr') as picture:
        done = subprocess.run([tsuya, 'render', *SCENE, 'groom=straight', 'shadow=none', *words, '-o',
                               picture.name], capture_output=True, text=True, check=True)
    value = float(re.search(r'hair luminance\s+([0-9.]+)', done.stdout).group(1))
    told = done.stderr.count('drawn by marschner')
    good = 0.9 <= value <= 1.01 and told == (name != 'fibre alone')
    failed += not good
    print(f'no shadow {name:16}{value:.4f}', '' if good else f'is not 0.9 to 1.01, or told {told} times')
sys.exit(failed > 0)
