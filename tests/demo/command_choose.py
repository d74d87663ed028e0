"""`tsuya choose`: what it derives from a scene, what it answers, what it refuses."""

import json
import math
import pathlib
import tempfile

from command_support import case, expect, output, refused, run

HAIR = ('straight-brown', 'strands=500', 'width_scale=40', '--size', '48x48')
TIERS = {'unshadowed', 'kajiya_kay', 'marschner', 'exact', 'plane_parallel'}
KEYS = {'tier', 'model', 'variant', 'status', 'held', 'drop', 'passes', 'error', 'error_high',
        'luminance', 'luminance_high', 'target', 'cost', 'frame_cost', 'bytes', 'samplers', 'miss',
        'over', 'better', 'cheaper', 'outside', 'reason', 'traits', 'tiers', 'source'}
LIGHT = {'covered_pixels', 'directional_lights', 'point_lights', 'area_lights', 'environments',
         'sky_share', 'light_cosine'}


def choose(*words):
    return json.loads(output('choose', *words, '--json'))


def near(value, truth, share):
    return abs(value - truth) <= share * abs(truth)


@case
def choice_is_the_cheapest_within_the_bound():
    free = choose(*HAIR)
    expect(set(free) == KEYS and free['status'] == 'met', str(free))
    tiers = {tier['tier']: tier for tier in free['tiers']}
    expect(set(tiers) == TIERS, str(tiers))
    least = min(tier['error_high'] for tier in tiers.values())
    expect(free['error_high'] == least == tiers[free['tier']]['error_high'], str(free))
    expect(near(free['frame_cost'], free['cost'] * free['traits']['covered_pixels'], 1e-5),
           str(free))
    for name in TIERS:
        bound = 1.001 * tiers[name]['error_high']
        said = choose(*HAIR, f'bound={bound}')
        within = [tier['cost'] for tier in tiers.values() if tier['error_high'] <= bound]
        expect(said['status'] == 'met' and said['miss'] == said['over'] == 0, str(said))
        expect(said['error_high'] <= bound, str(said))
        # Of tiers within 5 % of the least cost it takes the best.
        expect(min(within) <= said['cost'] <= 1.05 * min(within), f'{said} {within}')


@case
def wishes_that_cannot_be_are_said_so():
    costs = {tier['tier']: tier['cost'] for tier in choose(*HAIR)['tiers']}
    missed = choose(*HAIR, 'bound=0.001')
    expect(missed['status'] == 'missed' and missed['miss'] > 1.0, str(missed))
    expect(near(missed['miss'], missed['error_high'] / 0.001 - 1.0, 1e-4), str(missed))
    over = choose(*HAIR, 'budget=1')
    expect(over['status'] == 'over_budget' and over['tier'] == 'unshadowed', str(over))
    expect(near(over['over'], over['cost'] - 1.0, 1e-4) and over['cheaper'] is None, str(over))
    best = choose(*HAIR)
    words = [f'bound={1.001 * best["error_high"]}', f'budget={1.001 * costs["unshadowed"]}']
    conflict = choose(*HAIR, *words)
    expect(conflict['status'] == 'conflict' and conflict['miss'] > 0, str(conflict))
    said = output('choose', *HAIR, *words)
    expect('conflict' in said and conflict['reason'] in said, said)
    for name in ('tier', 'status', 'lobes dropped', 'passes', 'error', 'luminance', 'cost', 'tables',
                 'next better', 'next cheaper', 'reason'):
        expect(any(line.startswith(name + ' ') for line in said.splitlines()), f'{name}: {said}')


@case
def host_and_frame_before_count():
    blind = choose(*HAIR, 'shadow=none')
    expect(blind['tier'] == 'unshadowed' and blind['traits']['shadow'] == 'none', str(blind))
    lacks = {tier['tier']: tier['lacks'] for tier in blind['tiers']}
    expect(lacks['exact'] == ['shadow'] and lacks['unshadowed'] == [], str(lacks))
    expect(choose(*HAIR)['passes'] == ['count'], 'grid')
    expect(choose(*HAIR, 'shadow=deep_opacity')['passes'] == ['maps'], 'maps')
    expect(choose(*HAIR, 'tier=zinke')['traits']['shadow'] == 'maps', 'tier')
    poor = choose(*HAIR, 'memory=1000')
    expect(poor['bytes'] <= 1000 and poor['tier'] in ('unshadowed', 'kajiya_kay'), str(poor))
    held = choose(*HAIR, 'bound=100', 'hysteresis=1', 'previous=kajiya_kay')
    expect(held['held'] and held['tier'] == 'kajiya_kay', str(held))
    slow, fast = choose(*HAIR, '--target', 'vega10'), choose(*HAIR, '--target', 'navi21')
    expect(slow['target'] == 'vega10' and slow['cost'] > 1.5 * fast['cost'], f'{slow} {fast}')


@case
def traits_are_those_of_the_scene():
    one = choose(*HAIR, 'sigma_a=0.1,0.2,0.3', 'beta_R_deg=9')['traits']
    expect(set(one) == LIGHT | {'sigma_a', 'beta_R', 'strand_pixels', 'depth', 'curl', 'shadow'},
           str(one))
    expect(one['sigma_a'] == [0.1, 0.2, 0.3] and near(one['beta_R'], math.radians(9), 1e-6),
           str(one))
    # By the renderer: what hair covers.
    with tempfile.TemporaryDirectory() as folder:
        said = output('render', *HAIR, '-o', folder + '/a.png')
        coverage = float(said.split('hair coverage')[1].split()[0])
    expect(near(one['covered_pixels'], coverage * 48 * 48, 0.3), f'{one} {coverage}')
    far = choose(*HAIR, 'camera.zoom=0.5')['traits']
    expect(near(far['strand_pixels'], 0.5 * one['strand_pixels'], 1e-3), f'{one} {far}')
    expect(far['covered_pixels'] < 0.4 * one['covered_pixels'], f'{one} {far}')
    many = choose(*HAIR, 'light=none', 'light0.direction=0,0,1', 'light3.kind=rect',
                  'light4.kind=point', 'light5.angle_deg=5')['traits']
    counts = [many[name] for name in ('directional_lights', 'point_lights', 'area_lights',
                                      'environments')]
    expect(counts == [1, 1, 2, 1], str(many))
    sky = choose(*HAIR, 'light=none')['traits']
    expect(sky['sky_share'] == 1 and sky['light_cosine'] == 0, str(sky))
    for way, azimuth in ((1, 0), (-1, 180)):
        sun = choose(*HAIR, 'dome=0', 'light=none', 'light0.direction=0,0,1', 'turn_deg=0',
                     'camera.elevation_deg=0', f'camera.azimuth_deg={azimuth}')['traits']
        expect(sun['sky_share'] == 0 and near(sun['light_cosine'], way, 1e-3), str(sun))


# Side 0.2 m, facing +z; flat, or bent to a cylinder about y.
def sheet(path, radius, n=24):
    rows = []
    for j in range(n + 1):
        for i in range(n + 1):
            x, y = 0.2 * i / n - 0.1, 0.2 * j / n - 0.1
            a = x / radius if radius else 0.0
            rows.append(f'v {radius * math.sin(a) if radius else x} {y} '
                        f'{radius * (math.cos(a) - 1) if radius else 0}')
    for j in range(n):
        for i in range(n):
            k = j * (n + 1) + i + 1
            rows += [f'f {k} {k + 1} {k + n + 2}', f'f {k} {k + n + 2} {k + n + 1}']
    pathlib.Path(path).write_text('\n'.join(rows) + '\n', encoding='utf-8')


@case
def traits_of_leaves():
    camera = ('camera.azimuth_deg=0', 'camera.elevation_deg=0', 'camera.target=0,0,0',
              'camera.distance=1', 'camera.fov_deg=20', '--size', '100x100')
    with tempfile.TemporaryDirectory() as folder:
        flat, bent = folder + '/flat.obj', folder + '/bent.obj'
        sheet(flat, 0)
        sheet(bent, 0.1)
        said = choose(flat, 'R_top=0.1,0.2,0.05', 'T=0.05,0.1,0.02', 'R_bottom=0.12,0.25,0.06',
                      'light=none', 'light0.direction=0,0,1', 'dome=0', *camera)
        expect(set(said) == KEYS and said['tier'].startswith('leaf'), str(said))
        one = said['traits']
        expect(set(one) == LIGHT | {'R_top', 'R_bottom', 'T', 'footprint', 'curvature', 'backlit',
                                    'pigment_map', 'coat'}, str(one))
        for name, truth in (('R_top', (0.1, 0.2, 0.05)), ('R_bottom', (0.12, 0.25, 0.06)),
                            ('T', (0.05, 0.1, 0.02))):
            expect(all(abs(a - b) < 2e-4 for a, b in zip(one[name], truth)), str(one))
        pixel = 2000.0 * math.tan(math.radians(10)) / 100
        expect(near(one['footprint'], pixel, 1e-3), f'{one} {pixel}')
        expect(near(one['covered_pixels'], (200 / pixel) ** 2, 0.05), str(one))
        expect(one['curvature'] > 1e6 and not one['backlit'] and not one['pigment_map'], str(one))
        expect(one['coat'] == 1 and near(one['light_cosine'], 1, 1e-3), str(one))
        back = choose(flat, 'light=none', 'light0.direction=0,0.1,-1', 'dome=0', 'leaf=young_green',
                      'model=leaf_body', *camera)['traits']
        expect(back['backlit'] == 1 and back['coat'] == 0 and back['light_cosine'] < -0.9, str(back))
        expect(choose(flat, 'leaf=young_green', 'light=none', *camera)['traits']['backlit'] == 1,
               'sky')
        round_ = choose(bent, 'leaf=young_green', *camera)['traits']
        expect(near(round_['curvature'], 100, 0.05), str(round_))
    grown = choose('leaf', 'leaf.texels=64')
    expect(grown['traits']['pigment_map'] == 1 and 'uniform' not in grown['tier'], str(grown))
    even = {tier['tier']: tier['lacks'] for tier in choose('leaf', 'tier=leaf_uniform')['tiers']}
    expect('map' not in even['leaf_uniform'], str(even))


@case
def choose_refuses_bad_questions():
    def no(words, *parts):
        refused(['choose', *words], None, *parts)

    no([], 'no scene')
    no(['no-such-scene', 'bound=1'], 'no-such-scene')
    no([*HAIR, 'bound=-1'], 'bound is -1', '[1e-06, 1000000]')
    no([*HAIR, 'bound=nan'], 'bound is not finite')
    no([*HAIR, 'bound='], 'bound is ""', 'not a number')
    no([*HAIR, 'bound'], 'bound is ""')
    no([*HAIR, 'bound=1', 'bound=2'], 'bound is given twice')
    no([*HAIR, 'luminance_bound=-0.1'], 'luminance_bound', '[1e-06, 1000000]')
    no([*HAIR, 'budget=-5'], 'budget is -5')
    no([*HAIR, 'bound=0'], 'bound is 0')  # no bound is said by saying none
    no([*HAIR, 'samplers=1.5'], 'samplers is 1.5', 'whole')
    no([*HAIR, 'hysteresis=2'], 'hysteresis', '[0, 1]')
    no([*HAIR, 'previous=fast'], 'previous is "fast"', 'plane_parallel')
    no([*HAIR, 'previous=leaf'], 'previous is leaf', 'hair')
    no([*HAIR, '--target', 'navi99'], '--target', 'gfx1100')
    no([*HAIR, 'bounds=1'], 'no key bounds')
    no([*HAIR, 'fiber_width=-1'], 'fiber_width', '[')
    no([*HAIR, 'tier=exact', 'model=marschner'], 'tier', 'model')
    no([*HAIR, 'camera.distance=1000000'], 'strand_pixels')
    no(['leaf', 'model=marschner'], 'model is marschner', 'model=leaf')
    done = run('choose', *HAIR, 'samplers=0', 'memory=0')
    expect(done.returncode == 0 or b'sampler' in done.stderr, done.stderr.decode())
