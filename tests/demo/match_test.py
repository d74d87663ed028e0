#!/usr/bin/env python3
"""A switch of tier with match= keeps the mean luminance of hair: usage match_test.py TSUYA

Each scene is drawn by one tier, then by the others with the measured factor: none may be off by
more than 5 %. Unmatched they are off by up to several times; the greatest is printed."""
import re
import subprocess
import sys
import tempfile

tsuya = sys.argv[1]
COMMON = ['strands=1500', 'width_scale=20', 'size=112x112']
SCENES = (['straight-brown', 'color=blond', 'light=back'],
          ['straight-brown', 'groom=curly', 'color=black', 'light=side', 'camera.zoom=0.3'],
          ['straight-brown', 'groom=wavy', 'sigma_a=1.2,0.35,0.03', 'light=front',
           'camera.azimuth_deg=160'])
TIERS = ('unshadowed', 'kajiya_kay', 'plane_parallel')


def luminance(*words):
    with tempfile.NamedTemporaryFile(suffix='.exr') as picture:
        said = subprocess.run([tsuya, 'render', *words, '-o', picture.name], capture_output=True,
                              text=True, check=True).stdout
    return float(re.search(r'hair luminance\s+([0-9.e-]+)', said).group(1))


worst = unmatched = 0.0
for scene in SCENES:
    exact = luminance(*scene, *COMMON, 'tier=exact')
    for tier in TIERS:
        plain = luminance(*scene, *COMMON, f'tier={tier}')
        matched = luminance(*scene, *COMMON, f'tier={tier}', 'match=exact')
        print(f'{tier:15} {plain / exact:7.4f} of exact, matched {matched / exact:.4f}')
        worst = max(worst, abs(matched / exact - 1.0))
        unmatched = max(unmatched, abs(plain / exact - 1.0))
print(f'off by {100 * worst:.1f} % at most, without match= by {100 * unmatched:.0f} %')
sys.exit(worst > 0.05 or unmatched < 0.5)
