"""Cases of command_test.py: leaves in words, and what they are made of."""

import os
import tempfile

from command_support import case, expect, output, refused, table

# PROSPECT-D by its authors, shipped with github.com/jgomezdans/prosail in tests/data: N 1.2,
# Cab 30, Car 10, Ant 1, Cw 0.015, Cm 0.009; lambda, R, T.
RUN_D = '''
400,0.043088,0.000701
440,0.041348,0.001487
480,0.041099,0.009585
520,0.073960,0.104443
560,0.125130,0.192810
600,0.079865,0.126838
640,0.056082,0.081580
680,0.036410,0.017985
700,0.128955,0.210680
740,0.359378,0.499282
780,0.385428,0.531516
'''
PROSPECT = ('eval', 'prospect', '--on', 'reference')
HEAD = 'N,Cab,Car,Ant,Cbrown,Cw,Cm,lambda_nm\n'


@case
def prospect_meets_its_authors():
    rows = [list(map(float, line.split(','))) for line in RUN_D.split()]
    text = HEAD + ''.join(f'1.2,30,10,1,0,0.015,0.009,{row[0]}\n' for row in rows)
    head, got = table(output(*PROSPECT, text=text))
    expect(head[-2:] == ['R_leaf', 'T_leaf'], head)
    for row, cells in zip(rows, got):
        for want, cell in zip(row[1:], cells[-2:]):
            expect(abs(float(cell) - want) <= 1e-6, f'{row[0]} nm: {cell}, not {want}')


@case
def prospect_has_ends():
    for line, part in (('1.2,30,10,1,0,0,0,399', '[400, 780]'), ('0.9,30,10,1,0,0,0,500', 'N'),
                       ('1.2,-1,10,1,0,0,0,500', 'Cab'), ('1.2,30,10,1,0,0,nan,500', 'Cm')):
        refused(PROSPECT, HEAD + line + '\n', part)
    text = HEAD + '1,0,0,0,0,0,0,780\n10,1e6,0,0,1e6,1e6,1e6,400\n'
    _, rows = table(output(*PROSPECT, text=text))
    white, black = ([float(cell) for cell in row[-2:]] for row in rows)
    expect(abs(sum(white) - 1) <= 1e-9, f'white: {white}')
    expect(0.03 < black[0] < 0.05 and black[1] == 0, f'black: {black}')
    refused(('eval', 'prospect', '--on', 'gpu'), HEAD, 'reference only')


# Means of PROSPECT-D over 610..680, 530..570, 430..490 nm of a young, a dark and a yellow leaf.
BANDS = ((0.0650, 0.0787, 1.4483), (0.1630, 0.2124, 1.4737), (0.0429, 0.0122, 1.4942),
         (0.0406, 0.0064, 1.4483), (0.0995, 0.0561, 1.4737), (0.0410, 0.0002, 1.4942),
         (0.2947, 0.2858, 1.4483), (0.2869, 0.2649, 1.4737), (0.0569, 0.0246, 1.4942))


@case
def layers_do_what_is_asked():
    words = ('eval', 'leaf-layers', '--on', 'reference')
    text = 'R_top,R_bottom,T,n\n' + ''.join(f'{R},{1.4 * R!r},{T},{n}\n' for R, T, n in BANDS)
    head, rows = table(output(*words, text=text))
    expect(head[4:] == ['scatter_top', 'absorption_top', 'scatter_bottom', 'absorption_bottom',
                        'residual'], head)
    for row in rows:
        expect(float(row[8]) <= 1e-7, f'{row}')
        expect(abs(float(row[4]) - 0.1) <= 1e-9, f'{row}')
    for R, T, n in (BANDS[6], BANDS[7]):
        refused(words, f'R_top,R_bottom,T,n\n{R},{2 * R},{T},{n}\n', 'no two layers', 'nearest')
    refused(words, 'R_top,R_bottom,T\n0.4,0.4,0.7\n', 'more than all light')
    refused(words, 'R_top,R_bottom,T\n0.02,0.1,0.1\n', 'the surface alone reflects more')


@case
def a_leaf_in_words():
    with tempfile.TemporaryDirectory() as folder:
        pages = []
        for words in ((), ('leaf=red_autumn',), ('leaf=red_autumn', 'chlorophyll=40'),
                      ('chlorophyll=40', 'bottom=2'), ('R_top=0.1,0.15,0.05', 'T=0.1'),
                      ('R_top=0.1,0.15,0.05', 'R_bottom=0.2', 'T=0.1')):
            block = folder + '/page.block'
            output('bake', 'leaf_body', *words, '--no-measure', '-o', folder + '/t.bin', '--block',
                   block)
            with open(folder + '/t.bin', 'rb') as file:
                pages.append(file.read())
            os.remove(folder + '/t.bin')
        expect(len(set(pages)) == len(pages), 'two leaves have the same table')
        bad = ((('leaf=gras',), 'did you mean grass'), (('leaf=grass', 'R_top=0.1'), 'give either'),
               (('R_top=0.1',), 'T is missing'), (('R_top=0.5', 'T=0.6'), 'nearest possible'),
               (('R_top=0.01', 'T=0.1'), 'index 1.45'), (('T=2', 'R_top=0.1'), 'outside'),
               (('chlorophyll=1,2',), 'one number'), (('leaf=grass', 'leaf=needle'), 'twice'),
               (('leaf=grass', 'scatter_top=0.1'), 'both set the layers'),
               (('R_top=0.2947', 'R_bottom=0.5894', 'T=0.2858'), "two layers' reach"))
        for words, part in bad:
            refused(['bake', 'leaf_body', *words, '-o', folder + '/u.bin'], None, part)
        expect(not os.path.exists(folder + '/u.bin'), 'a file was written')


@case
def a_scene_says_leaves():
    def brightness(*words):
        with tempfile.TemporaryDirectory() as folder:
            said = output('render', 'leaf', *words, 'size=48x48', 'leaf.texels=0', '-o',
                          folder + '/p.png')
        line, = (line for line in said.splitlines() if line.startswith('leaf luminance'))
        return float(line.split()[2].rstrip(','))
    dark, yellow = brightness('leaf=dark_shade'), brightness('leaf=yellow_autumn')
    expect(1.5 * dark < yellow, f'a dark leaf of {dark}, a yellow one of {yellow}')
    green = brightness('leaf=yellow_autumn', 'chlorophyll=60')
    expect(1.2 * green < yellow, f'with chlorophyll {green}')
    grey = brightness('R_top=0.4,0.4,0.4', 'T=0.4,0.4,0.4', 'R_bottom=0.4,0.4,0.4')
    expect(yellow < grey, f'grey: {grey}')
    for words, part in ((('leaf=gras',), 'grass'), (('R_top=0.1,0.1,0.1',), 'T is missing'),
                        (('leaf=grass', 'T=0.1,0.1,0.1'), 'keep either'),
                        (('R_top=0.1,0.1,0.1', 'T=0.95,0,0'), 'nearest possible'),
                        (('chlorophyll=-1',), '[0, 1000000]')):
        refused(('render', 'leaf', *words, '-o', 'never.png'), None, part)
