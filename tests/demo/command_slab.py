"""Cases of command_test.py: scattering slabs, against other programs and printed figures."""

import math

from command_support import case, expect, output, refused, table

# n,a,b,g,mu0 | UR1,UT1,URU,UTU: converged values of an independent solver beside runs of iad 4.0;
# the third and fourth are of Giovanelli 1955 and van de Hulst 1980, digits as printed; the half
# space is the closed integral of Chandrasekhar's H. nan: not known.
POWERS = '''
1.0,0.95,4,0.5,1.0|0.3531715,0.3390453,0.4481336,0.2538444
1.5,0.8,0.5,0.85,1.0|0.0770831,0.7870713,0.1457855,0.6749286
1.5,0.9,inf,0,1|0.25992,0,nan,0
1.0,0.9,2,0.75,1|0.09739,0.66096,nan,nan
1.4,0.98,6,0.3,0.5|0.5034178,0.1832813,nan,nan
1.0,0.99,inf,0,0.3|0.8441287123,0,nan,0
1.0,0.8,inf,0,0|0.5527864045,0,nan,0
1.0,0,1,0,0.5|0,0.1353352832,0,0.2193839344
'''

# a,b,g,n,mu0,kind,mu,phi_deg | f: Pythonic-DISORT 1.5 at 48 streams; the last is H again.
RADIANCES = '''
0.9,2.0,0.75,1,0.6,R,0.0308627240,0|0.3353271
0.9,2.0,0.75,1,0.6,T,0.4044405663,90|0.08275372
0.95,4.0,0.5,1,0.8,R,0.1759531740,45|0.1771331
0.9,inf,0,1,1,R,0.3,0|0.1418145008
'''

# The first of DISORT's tests 8 and 9: two and six layers under a sky of radiance 1.
LAYERS = '''
2,0.5,0.25,0.3,0.25,1,0,1,0,1,0,1,0,none,1|URU,0.093010215
2,0.5,0.25,0.3,0.25,1,0,1,0,1,0,1,0,sky_up,0.2|f,0.17664564
6,0.65,1,0.7,2,0.75,3,0.8,4,0.85,5,0.9,6,sky_up,0.2|f,0.31374621
'''


def near(got, wanted, tolerance, what):
    if not math.isnan(wanted):
        expect(abs(got - wanted) <= tolerance, f'{what}: {got}, not {wanted}')


def ask(function, columns, truth):
    rows = [line.split('|') for line in truth.split()]
    text = columns + '\n' + ''.join(row[0] + '\n' for row in rows)
    names, cells = table(output('eval', function, '--on', 'reference', text=text))
    return [(row[0], row[1].split(','), dict(zip(names, line))) for row, line in zip(rows, cells)]


@case
def powers_of_slabs_meet_other_programs():
    for row, wanted, got in ask('slab', 'n,a,b,g,mu0', POWERS):
        for name, value in zip(('UR1', 'UT1', 'URU', 'UTU'), wanted):
            near(float(got[name]), float(value), 6e-6, f'slab {row}, {name}')


@case
def radiances_of_slabs_meet_other_programs():
    for row, wanted, got in ask('slab-bsdf', 'a,b,g,n,mu0,kind,mu,phi_deg', RADIANCES):
        near(float(got['f']) / float(wanted[0]), 1, 2e-5, f'slab-bsdf {row}')


@case
def layers_meet_other_programs():
    columns = 'layers,a1,b1,a2,b2,a3,b3,a4,b4,a5,b5,a6,b6,kind,mu'
    for row, wanted, got in ask('slab-layers', columns, LAYERS):
        near(float(got[wanted[0]]) / float(wanted[1]), 1, 1e-5, f'slab-layers {row}')


@case
def layers_are_slabs_and_slabs_are_layers():
    one = table(output('eval', 'slab', '--on', 'reference',
                       text='n,a,b,g,mu0,n_top\n1.45,.9,3,.6,.7,1.6\n'))[1][0]
    two = table(output('eval', 'slab-layers', '--on', 'reference',
                       text='layers,n1,a1,b1,g1,n2,a2,b2,g2,mu0,n_top,kind,level\n'
                            '2,1.45,.9,1,.6,1.45,.9,2,.6,.7,1.6,flux_down,3\n'))[1][0]
    for a, b in zip((6, 7, 8, 9), (13, 14, 17, 18)):
        near(float(two[b]), float(one[a]), 1e-7, f'column {b}')
    # At the bottom: what goes down is what gets out and what the wall sends back.
    expect(float(two[20]) > float(two[14]) > 0, 'light at the bottom')


@case
def moments_are_phase_functions():
    # Rayleigh by name and by its second moment; Henyey-Greenstein of g 0.1 by eight moments.
    text = 'b1,a1,phase1,g1,kind,mu,mu0,phi_deg,' + ','.join(f'chi{i}' for i in range(1, 9)) + '\n'
    for phase, g, chi in (('rayleigh', 0, [0] * 8), ('moments', 0, [0, 0.1] + [0] * 6),
                          ('hg', 0.1, [0] * 8), ('moments', 0, [0.1**i for i in range(1, 9)])):
        text += f'1,.9,{phase},{g},R,.3,.6,40,' + ','.join(map(repr, chi)) + '\n'
    got = [float(row[-1]) for row in table(output('eval', 'slab-layers', '--on', 'reference',
                                                  text=text))[1]]
    near(got[1] / got[0], 1, 1e-12, 'Rayleigh')
    near(got[3] / got[2], 1, 1e-7, 'Henyey-Greenstein')


@case
def bad_slabs_are_named():
    for column, bad in (('a', '1.1'), ('a', 'nan'), ('n', '0.99'), ('g', '1'), ('g', '-1'),
                        ('g', '2'), ('b', '-1'), ('b', 'nan'), ('mu0', '1.5'), ('n_top', '0.5')):
        refused(('eval', 'slab', '--on', 'reference'), f'{column}\n{bad}\n', f'column {column}')
    refused(('eval', 'slab-bsdf', '--on', 'reference'), 'kind\nX\n', 'column kind', 'X')
    refused(('eval', 'slab-layers', '--on', 'reference'), 'layers\n2.5\n', 'layers', 'whole')
    refused(('eval', 'slab-layers', '--on', 'reference'), 'kind,b1,level\nup,1,1.5\n', 'level')
    refused(('eval', 'slab', '--on', 'gpu'), 'a\n1\n', 'reference only')
