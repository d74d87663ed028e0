#!/usr/bin/env python3
"""Errors of all tiers against distance, and what the chooser makes of it.

    lod.py TSUYA -o LOD.csv [--bound B]

Draws two heads of hair from nearer and farther in pictures of one size, traces each, and asks the
chooser for a tier within B (default 0.45). Rows: scene, distance (1: the head fills the picture),
width of a strand in pixels, tier, rms (root of relative MSE) with standard error, chosen: 1 for the
chooser's tier, predicted: its error_high. plots.py --lod draws them. Takes minutes.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

SCENES = {
    'straight blond': ['groom=straight', 'color=blond', 'light=front'],
    'curly brown': ['groom=curly', 'color=brown', 'light=side'],
}
COMMON = ['strands=3000', 'width_scale=10', 'dome=1', 'camera.azimuth_deg=120', 'size=72x72']
ZOOMS = (4, 2, 1, 0.5, 0.25)


def run(*words):
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False)
    if done.returncode:
        sys.exit(f'lod: {" ".join(words[:2])}: {done.stderr.strip()}')
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('tsuya')
    parser.add_argument('-o', type=pathlib.Path, required=True)
    parser.add_argument('--bound', type=float, default=0.45)
    parser.add_argument('--samples', default='96')
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, words in SCENES.items():
            for zoom in ZOOMS:
                scene = ['straight-brown', *words, *COMMON, f'camera.zoom={zoom}']
                truth = f'{folder}/truth.exr'
                run(options.tsuya, 'reference', *scene, '--samples', options.samples, '-o', truth)
                said = json.loads(run(options.tsuya, 'compare', *scene, '--all', '--reference',
                                      truth, '--json'))
                choice = json.loads(run(options.tsuya, 'choose', *scene, 'shadow=deep_opacity',
                                        f'bound={options.bound}', '--json'))
                high = {tier['tier']: tier['error_high'] for tier in choice['tiers']}
                width = choice['traits']['strand_pixels']
                for tier in said['tiers']:
                    rows.append([name, f'{1.0 / zoom:.3g}', f'{width:.3g}', tier['tier'],
                                 f"{tier['rms']:.4f}", f"{tier['rms_se']:.4f}",
                                 int(tier['tier'] == choice['tier']),
                                 f"{high.get(tier['tier'], float('nan')):.4f}"])
    with options.o.open('w', encoding='utf-8', newline='') as file:
        file.write(f'# {" ".join(COMMON)}; bound {options.bound}; {options.samples} samples\n')
        out = csv.writer(file, lineterminator='\n')
        out.writerow(['scene', 'distance', 'strand_pixels', 'tier', 'rms', 'rms_se', 'chosen',
                      'predicted'])
        out.writerows(rows)
    return 0


if __name__ == '__main__':
    sys.exit(main())
