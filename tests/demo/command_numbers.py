"""Cases of command_test.py: the numbers of `tsuya eval`, against other sources and each other."""

import math
import random

from command_support import AZIMUTHAL, case, expect, models, output, table

# Smooth circular fibre blurred with a wrapped Gaussian, exact Fresnel, 9 digits, 131072 nodes:
# eta, theta_d_deg, sigma_a, beta_az_deg, phi_deg, N_0..N_3 per radian, and Abar_>=4.
# Source: section A of the reference tables, an independent program; RES = N_3 + Abar_>=4 / (2 pi).
TRUTH = '''
1.55,40,0,10,0,1.31420210e-02,2.26968541e-15,1.24257627e-01,0.00000000e+00,3.352079243e-03
1.55,60,0.2,10,20,2.46651792e-02,5.50055224e-07,2.29531991e-02,4.55727859e-38,1.032633178e-03
1.55,40,1,5,120,1.89332666e-02,2.16416156e-02,0.00000000e+00,9.99217527e-07,1.065405963e-06
1.55,85,0.2,5,160,3.95884199e-02,2.22780242e-02,4.04658211e-06,3.55261119e-03,6.191711446e-03
1.55,0,1,20,115,1.21833166e-02,2.12516754e-02,3.04792251e-09,1.66302175e-05,2.295134171e-06
1.55,85,1,5,90,1.25142307e-01,1.00189499e-03,4.72490764e-05,2.21696062e-06,9.262690158e-07
1.55,75,1,10,165,2.61578452e-02,1.29024183e-02,5.44338371e-11,1.13496106e-05,7.173554188e-07
1.55,20,0.2,10,10,1.16330064e-02,5.57310474e-16,3.51005714e-02,2.33620847e-23,4.757707794e-04
1.55,20,1,20,100,1.20703471e-02,1.04612788e-02,3.97011055e-08,1.60322285e-05,1.881605880e-06
1.55,75,0,20,0,6.56523834e-02,2.20990424e-04,5.86025884e-02,2.99217988e-08,3.144511018e-02
1.55,60,0,5,70,2.78569087e-02,1.33567352e-02,4.95743608e-03,0.00000000e+00,8.248578113e-03
1.55,89,0,10,65,1.93140120e-01,3.63964033e-04,1.24895272e-03,2.95714176e-04,5.831260134e-02
1.55,0,0.2,20,125,1.31220106e-02,1.26371567e-01,3.87356039e-09,5.85366132e-04,4.511991073e-04
'''


@case
def digits_are_nine_or_seventeen():
    for on, digits in (('reference', 17), ('cpu', 17), ('gpu', 9)):
        cells = output('eval', 'hair-azimuthal', '--on', on, text='phi_deg\n150\n').splitlines()[1]
        for cell in cells.split(',')[1:]:
            expect(cell == f'%.{digits}g' % float(cell), f'{on}: {cell}')


@case
def reference_meets_the_independent_table():
    rows = [list(map(float, line.split(','))) for line in TRUTH.split()]
    text = 'eta,theta_d_deg,sigma_a,beta_az_deg,phi_deg\n'
    text += ''.join(','.join(line.split(',')[:5]) + '\n' for line in TRUTH.split())
    _, got = table(output(*AZIMUTHAL, text=text))
    for row, cells in zip(rows, got):
        wanted = [*row[5:8], row[8] + row[9] / (2 * math.pi)]
        for want, cell in zip(wanted, cells[5:]):
            expect(abs(float(cell) - want) <= 1e-8, f'{row[:5]}: {cell}, not {want}')


def deon(theta_i, theta_r, beta):
    """d'Eon et al. 2011, eq. 7, with exp(-x) I0(x) from its integral over a half turn."""
    v = beta * beta
    x = math.cos(theta_i) * math.cos(theta_r) / v
    n = 4096  # the trapezoid rule converges exponentially here
    bessel = sum(math.exp(x * (math.cos(math.pi * (k + 0.5) / n) - 1)) for k in range(n)) / n
    return bessel * math.exp(x - (1 + math.sin(theta_i) * math.sin(theta_r)) / v) / (
        v * -math.expm1(-2 / v))


@case
def longitudinal_is_deons_lobe():
    draw = random.Random(2)
    rows = [(draw.uniform(-89, 89), draw.uniform(-89, 89), draw.uniform(2, 30)) for _ in range(30)]
    rows += [(a, -a + d, b) for a in (0, 40, 89) for d in (0, 1) for b in (2, 10, 30)]
    text = 'theta_i_deg,theta_r_deg,beta_deg\n' + ''.join('%r,%r,%r\n' % row for row in rows)
    _, reference = table(output('eval', 'longitudinal', '--on', 'reference', text=text))
    _, gpu = table(output('eval', 'longitudinal', '--on', 'gpu', text=text))
    for row, cells, drawn in zip(rows, reference, gpu):
        want = deon(*map(math.radians, row))
        beta = math.radians(row[2])
        peak = deon(0, 0, beta)
        expect(abs(float(cells[3]) - want) <= 1e-9 * peak, f'{row}: {cells[3]}, not {want}')
        expect(abs(float(drawn[3]) - want) <= 5e-3 * max(peak, want),
               f'{row}: {drawn[3]}, not {want}')


@case
def a_variant_is_a_function_of_its_own():
    text = 'theta_i_deg,theta_r_deg,beta_deg\n20,-25,10\n'
    words = ('eval', 'longitudinal', '--on', 'reference')
    one = output(*words, '--variant', 'gaussian', text=text)
    expect(one != output(*words, text=text), 'the variant gives the same number')
    expect(one == output('eval', 'longitudinal-gaussian', '--on', 'reference', text=text), one)


def rows_of(function, count, materials, seed):
    """Random rows inside the ranges; `materials` different values of the material's inputs."""
    draw = random.Random(seed)
    low_high = {'sigma_a': (0, 5), 'phi': (-180, 180), 'theta_i': (-85, 85), 'theta_r': (-85, 85),
                'theta_d': (-85, 85), 'eta': (1.3, 1.8), 'tau': (0.1, 20)}

    def value(v):
        if '|' in v['unit']:
            words = v['unit'].split(';')[0].split('|')
            # A leaf by name: random reflectances are impossible more often than not.
            return draw.choice(words[1:] if v['name'] == 'preset' else words)
        low, high = low_high.get(v['name'], (v.get('minimum_deg', v['minimum']),
                                             v.get('maximum_deg', v['maximum'])))
        return repr(draw.uniform(low, high))

    inputs = function['inputs']
    fixed = [{v['name']: value(v) for v in inputs if v['material']} for _ in range(materials)]
    lines = [','.join(v['column'] for v in inputs)]
    for i in range(count):
        lines.append(','.join(fixed[i % materials].get(v['name']) or value(v) for v in inputs))
    return '\n'.join(lines) + '\n'


def agree(model, function, text, materials):
    words = ('eval', function['name'], '--model', model)
    _, cpu = table(output(*words, '--on', 'cpu', text=text))
    _, gpu = table(output(*words, '--on', 'gpu', text=text))
    first = len(function['inputs'])
    for column in range(first, first + len(function['outputs'])):
        for group in range(materials):
            a = [float(row[column]) for row in cpu[group::materials]]
            b = [float(row[column]) for row in gpu[group::materials]]
            peak = max(map(abs, a))
            worst = max(abs(x - y) for x, y in zip(a, b))
            expect(worst <= 2e-3 * peak + 1e-9, f'{model} {function["name"]}, output '
                   f'{column - first}, material {group}: {worst} of {peak}')


@case
def cpu_and_gpu_agree():
    for model in models():
        for function in (f for f in model['functions'] if 'gpu' in f['on']):
            # A row of a slab is a sum of thousands of evaluations, some of its materials a solution.
            slab = any(v['name'] == 'tau' for v in function['inputs'])
            rows, materials = (12, 2) if slab else (600, 3)
            agree(model['name'], function, rows_of(function, rows, materials, 4), materials)


@case
def more_materials_than_a_texture_holds():
    hair = next(f for f in models()[0]['functions'] if f['name'] == 'hair')
    agree(models()[0]['name'], hair, rows_of(hair, 900, 300, 5), 300)


@case
def many_rows_are_quick():
    hair = next(f for f in models()[0]['functions'] if f['name'] == 'hair')
    text = rows_of(hair, 100000, 4, 6)
    expect(len(output('eval', 'hair', '--on', 'gpu', text=text).splitlines()) == 100001, 'rows')
