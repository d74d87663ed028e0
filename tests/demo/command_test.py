#!/usr/bin/env python3
"""The `tsuya` command from outside: its help, its GLSL, its CSV, its numbers.

    command_test.py /path/to/tsuya

Needs the built command and glslangValidator. Prints one line a case; exits 1 when one fails.
"""

import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

import command_bench  # noqa: F401, registers its cases
import command_choose  # noqa: F401, registers its cases
import command_leaf  # noqa: F401, registers its cases
import command_numbers  # noqa: F401, registers its cases
import command_slab  # noqa: F401
import command_surface  # noqa: F401, registers its cases
from command_support import AZIMUTHAL, CASES, Wrong, case, expect, models, output, refused, run
from command_support import table, use

TARGETS = ('330', '410', '450', '300es', '310es', 'vulkan')
COMMANDS = ('models', 'glsl', 'bake', 'eval', 'bench', 'render', 'choose', 'compare', 'scenes')


@case
def help_texts():
    everything = output('--help')
    for name in COMMANDS + ('reference',):  # its own help needs Embree: tests/reference
        expect(name in everything, f'{name} is not in --help')
    for name in COMMANDS:
        said = output(name, '--help')
        expect('usage: tsuya ' + name in said and 'examples:' in said, said)
    expect(output('--version').startswith('tsuya '), 'no version')


@case
def unknown_words_are_errors_with_a_suggestion():
    refused(['modles'], None, 'modles', 'did you mean models')
    refused([], None, '--help')
    refused(['--versoin'], None, 'did you mean --version')
    refused(['eval', 'hari', '--on', 'cpu'], None, 'did you mean hair')
    refused(['eval', 'hair', '--onn', 'cpu'], None, 'did you mean --on')
    refused(['eval', 'hair', '--on', 'gup'], None, 'did you mean gpu')
    refused(['eval', 'hair'], None, '--on is missing')
    refused(['eval', 'hair', '--on', 'cpu', '--on', 'gpu'], None, 'twice')
    refused(['eval', 'hair', '--on', 'cpu', '--model', 'marshner'], None, 'did you mean marschner')
    refused(['eval', 'hair', '--on', 'cpu', '--variant', 'x'], None, 'no variant "x"', 'gaussian')
    for on in ('cpu', 'gpu'):
        refused(['eval', 'hair', '--on', on, '--variant', 'gaussian'], None, 'reference only')
    refused(['glsl', 'marschner'], None, '--target is missing')
    refused(['glsl', 'marschner', '--target', '460'], None, '450')
    refused(['glsl', 'marschner,', '--target', '450'], None, 'no model ""')
    refused(['glsl', 'marschner', '--target', '330', '--array', '128'], None, '[1, 127]')
    glsl = ['glsl', 'marschner', '--target', '330']
    refused([*glsl, '--drop', 'tr'], None, 'did you mean trt', 'residual')
    refused([*glsl, '--drop', 'trt,'], None, 'no lobe ""')
    refused([*glsl, '--only', 'finite'], None, 'only', '"finite"')


@case
def only_what_is_asked_for():
    glsl = ('glsl', 'dual_scattering', '--target', '330')
    whole, less = output(*glsl), output(*glsl, '--only', 'finite', '--drop', 'trt,residual,back')
    expect(len(less) < 0.7 * len(whole), f'{len(less)} of {len(whole)} bytes')
    expect('tsu_dual_scattering_finite_eval(' in less and 'zinke_eval' not in less, less)
    harness = output(*glsl, '--harness', '--only', 'zinke')
    expect('tsu_dual_scattering_sum(tsu_dual_scattering_zinke_eval(material' in harness, harness)
    expect('in float behind;' not in harness, harness)
    expect('in float behind;' in output(*glsl, '--harness', '--only', 'finite'), 'no behind')


@case
def models_list_everything():
    names = [model['name'] for model in models()]
    expect({'marschner', 'kajiya_kay'} <= set(names), names)
    for model in models():
        for key in ('title', 'source', 'parameters', 'tables', 'error', 'inputs', 'functions'):
            expect(key in model, f'{model["name"]}: no {key}')
        for value in [*model['parameters'], *(v for f in model['functions'] for v in f['inputs'])]:
            expect(value['minimum'] <= value['default'] <= value['maximum'], value)
            if value['unit'] == 'rad':
                expect(abs(math.radians(value['maximum_deg']) - value['maximum'])
                       <= 1e-9 * abs(value['maximum']), value)
        for error in model['error'].values():
            expect(math.isfinite(error['value']) and error['measure'] and error['range'], error)
        expect(model['title'] in output('models', model['name']), 'no title in the plain list')


@case
def every_text_compiles_on_every_target():
    names = [model['name'] for model in models()]
    shadows = [model['name'] for model in models('shadow')]
    tail = '\nlayout(location = 0) out vec4 host;\nvoid main()\n{\n    host = vec4(1.0);\n}\n'
    versions = {'330': '330 core', '410': '410 core', '450': '450 core', '300es': '300 es',
                '310es': '310 es', 'vulkan': '450'}
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, 'text.frag')
        for asked in [*names, ','.join(names), *shadows, ','.join([*names, *shadows])]:
            for target in TARGETS:
                for harness in (False, True)[:1 if shadows[-1] in asked or asked in shadows else 2]:
                    words = ['--harness'] if harness else []
                    text = output('glsl', asked, '--target', target, *words)
                    expect(('#version' in text) == harness and ('void main' in text) == harness,
                           f'{asked} {target}: #version or main where none belongs')
                    expect(text.count('uniform sampler') <= 1, f'{asked}: more than one sampler')
                    if not harness:
                        text = f'#version {versions[target]}\n{text}{tail}'
                    path.write_text(text)
                    vulkan = ['-V', '-o', os.devnull] if target == 'vulkan' else []
                    done = subprocess.run(['glslangValidator', *vulkan, str(path)], check=False,
                                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                    expect(done.returncode == 0, f'{asked} {target}: {done.stdout.decode()}')


@case
def shadows_are_no_fibres():
    names = [model['name'] for model in models('shadow')]
    expect(names == ['deep_opacity', 'opacity_shadow'], str(names))
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            refused(['glsl', name, '--target', '330', '--harness'], None, 'harness')
            refused(['bake', name, '-o', folder + '/t.exr'], None, name)
            refused(['render', 'straight-brown', 'model=' + name, '-o', folder + '/t.png'], None,
                    name, 'marschner')
        refused(['glsl', 'deep_opcity', '--target', '330'], None, 'deep_opacity')


@case
def shadow_maps_are_drawn():
    """Maps, the grid and no shadow: three pictures, and the maps' size in the words."""
    light = {}
    with tempfile.TemporaryDirectory() as folder:
        for shadow in ('deep_opacity', 'opacity_shadow', 'grid', 'none'):
            said = output('render', 'straight-brown', 'strands=400', 'width_scale=60', 'dome=0',
                          'dome.samples=1', 'shadow=' + shadow, 'shadow.layers=6',
                          'shadow.size=96', '--size', '48x48', '-o', folder + '/t.png')
            light[shadow] = float(said.split('hair luminance')[1].split(',')[0])
            expect(('96x96, 6 layers' in said) == (shadow in ('deep_opacity', 'opacity_shadow')),
                   said)
        # Maps that cannot be: one line, and the grid.
        done = run('render', 'straight-brown', 'strands=400', 'width_scale=60', 'dome=0',
                   'dome.samples=1', 'shadow=deep_opacity', 'shadow.size=5', '--size', '48x48',
                   '-o', folder + '/t.png')
        said = done.stderr.decode()
        expect(done.returncode == 0 and said.count('\n') == 1 and 'grid' in said, said)
        same = float(done.stdout.decode().split('hair luminance')[1].split(',')[0])
        expect(same == light['grid'], f'{same} {light}')
    expect(light['none'] > 1.5 * light['grid'], str(light))
    for shadow in ('deep_opacity', 'opacity_shadow'):
        expect(0.5 * light['grid'] < light[shadow] < 2.0 * light['grid'], str(light))


@case
def array_holds_the_records():
    text = output('glsl', 'marschner', '--target', '330', '--array', '3')
    expect('tsu_materials' not in text and 'tsu_records[' in text, text[:400])


@case
def csv_passes_comments_and_columns_through():
    text = ('# first\n#second, with, commas\nname,phi_deg,eta\n x y,30,1.5\n#between\n'
            '"a,b",60,1.6\n#end\n')
    lines = output(*AZIMUTHAL, text=text).splitlines()
    comments = ['# first', '#second, with, commas', '#between', '#end']
    expect([lines[i] for i in (0, 1, 4, 6)] == comments, lines)
    expect(lines[2] == 'name,phi_deg,eta,R,TT,TRT,RES', lines[2])
    expect(lines[3].startswith(' x y,30,1.5,') and lines[5].startswith('"a,b",60,1.6,'), lines)


@case
def csv_takes_columns_in_any_order_and_defaults():
    head = 'eta,theta_d_deg,sigma_a,beta_az_deg,phi_deg'
    one = output(*AZIMUTHAL, text=head + '\n1.55,20,0.9061,10,160\n').splitlines()[1].split(',')[5:]
    two = output(*AZIMUTHAL, text='phi_deg,theta_d_deg\n160,20\n').splitlines()[1].split(',')[2:]
    expect(one == two, f'{one} {two}')


@case
def csv_reads_every_spelling_of_a_number():
    values = set()
    for cell in ('1.55', ' 1.55 ', '+1.55', '155e-2', '+.155E+1', '\t1.55', '"1.55"', '1.550'):
        row = output(*AZIMUTHAL, text=f'eta,k\n{cell},0\n').splitlines()[1]
        values.add(tuple(row.split(',')[2:]))
    expect(len(values) == 1, values)
    for cell in ('1,55', '1.55x', '0x1p0', '++1.5', '1 5', '1e', 'e1', '-', '1.5e+'):
        done = run(*AZIMUTHAL, text=f'eta\n{cell}\n')
        expect(done.returncode == 2 and done.stdout == b'', f'{cell} was read')
    output(*AZIMUTHAL, text='sigma_a\n1e-400\n')


@case
def csv_refuses_what_is_no_text():
    done = run(*AZIMUTHAL, text='\0' * 4000)
    expect(done.returncode == 2 and done.stdout == b'' and b'control' in done.stderr, done.stderr)


@case
def bake_keeps_texture_and_block_apart():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'both.bin')
        done = run('bake', 'marschner', '-o', path, '--block', path)
        expect(done.returncode == 2 and not os.path.exists(path), done.stderr)
        done = run('bake', 'marschner', '-o', path, '--block', '/nonexistent/block')
        expect(done.returncode != 0 and not os.path.exists(path), done.stderr)


@case
def bake_takes_the_colour_of_a_head():
    # The default fibre's curve has a node at sigma_a 0.0225 (runtime/optics/head_default.inc).
    pages = []
    with tempfile.TemporaryDirectory() as folder:
        for word in ('head_albedo=0.374645396520', 'sigma_a=0.0225', 'head_albedo=0.37'):
            output('bake', 'marschner', word, '--no-measure', '-o', folder + '/t.bin', '--block',
                   folder + '/page')
            page = struct.unpack('<4096f', pathlib.Path(folder, 'page').read_bytes())
            pages.append(page)
    near = max(abs(a - b) for a, b in zip(pages[0], pages[1]))
    far = max(b - a for a, b in zip(pages[0], pages[2]))
    expect(near <= 1e-8, near)
    expect(1e-4 < far < 2e-3, far)


@case
def csv_forgets_whole_turns():
    rows = output(*AZIMUTHAL[:-1], 'gpu', text='phi_deg\n339.5\n36000339.5\n-36000020.5\n')
    values = {line.split(',', 1)[1] for line in rows.splitlines()[1:]}
    expect(len(values) == 1, values)


@case
def help_of_a_function_lists_its_columns():
    for model in models('fibre', 'surface'):
        for function in model['functions']:
            said = output('eval', function['name'], '--help', '--model', model['name'])
            reads, adds = said.split('Columns that it adds:')
            words = [line.split() for line in reads.splitlines()[1:]]
            expect([line[0] for line in words] == [v['column'] for v in function['inputs']], said)
            for line, value in zip(words, function['inputs']):
                if '|' not in value['unit']:
                    low = value.get('minimum_deg', value['minimum'])
                    expect(abs(float(line[1]) - low) <= 1e-5 * abs(low), f'{line} {low}')
                    expect(line[2] == '..', f'{line}')
            for value in function['outputs']:
                expect(f"  {value['name']}" in adds, said)
    refused(['eval', 'hairy', '--help'], None, 'hairy')


@case
def what_a_groom_lost_is_said():
    with tempfile.TemporaryDirectory() as folder:
        for bad, strands in ((), 2), ((float('nan'),), 1):
            path = os.path.join(folder, 'a.hair')
            points = [0, 0, 0, 0, .1, 0, .02, 0, 0, .02, .1, *(bad or (0,))]
            with open(path, 'wb') as file:
                file.write(struct.pack('<4s4I5f88s', b'HAIR', 2, 4, 2, 1, 8e-5, 0, 1, 1, 1, b''))
                file.write(struct.pack('<12f', *points))
            done = run('render', path, 'size=8x8', '-o', os.path.join(folder, 'a.png'))
            said = done.stderr.decode()
            expect(done.returncode == 0 and f'strands          {strands}\n' in
                   done.stdout.decode(), said)
            expect(('1 point dropped' in said and '1 strand dropped' in said) == bool(bad), said)


@case
def csv_takes_crlf_and_a_byte_order_mark():
    plain = output(*AZIMUTHAL, text='# c\neta,phi_deg\n1.5,20\n')
    expect(plain == output(*AZIMUTHAL, text='# c\r\neta,phi_deg\r\n1.5,20\r\n'), 'CRLF differs')
    expect(plain == output(*AZIMUTHAL, text=b'\xef\xbb\xbf# c\neta,phi_deg\n1.5,20'), 'BOM differs')
    expect(plain == output(*AZIMUTHAL, text='# c\neta,phi_deg\n1.5,20\n\n \n'), 'blank end differs')


@case
def csv_header_alone_gives_the_header():
    for on in ('reference', 'cpu', 'gpu'):
        expect(output('eval', 'hair-azimuthal', '--on', on, text='#c\neta,foo\n')
               == '#c\neta,foo,R,TT,TRT,RES\n', on)


@case
def csv_errors_name_line_and_column():
    refused(AZIMUTHAL, '#c\neta,theta_d_deg\n1.5,20\n#c\n1.5,91\n',
            'line 5, column theta_d_deg: 91 is outside [-90, 90]')
    refused(AZIMUTHAL, 'eta\n1.5\n1.1\n', 'line 3, column eta: 1.1 is outside [1.2, 2]')
    refused(AZIMUTHAL, 'eta\nnan\n', 'line 2, column eta', 'nan')
    refused(AZIMUTHAL, 'phi_deg\ninf\n', 'line 2, column phi_deg', 'inf')
    refused(AZIMUTHAL, 'phi_deg\n-inf\n', 'line 2, column phi_deg', '-inf')
    refused(AZIMUTHAL, 'phi_deg\n1e999\n', 'line 2, column phi_deg', 'inf')
    refused(AZIMUTHAL, 'eta,phi_deg\n1.5,\n', 'line 2, column phi_deg', 'empty')
    refused(AZIMUTHAL, 'eta\nabc\n', 'line 2, column eta', '"abc" is not a number')
    refused(AZIMUTHAL, 'eta,foo\n1.5,1\n1.5\n', 'line 3', '1 cell', '2 columns')
    refused(AZIMUTHAL, 'eta,foo\n1.5,1,2\n', 'line 2', '3 cells', '2 columns')
    refused(AZIMUTHAL, 'eta,foo,eta\n', 'line 1', 'column 3', 'eta')
    refused(AZIMUTHAL, 'eta,\n', 'line 1', 'column 2', 'no name')
    refused(AZIMUTHAL, '1.5,2\n', 'line 1', 'header')
    refused(AZIMUTHAL, '', 'no header')
    refused(AZIMUTHAL, '# only\n', 'no header')
    refused(AZIMUTHAL, 'eta,TT\n1.5,0\n', 'column TT', 'result')
    refused(AZIMUTHAL, 'eta\n\n1.5\n', 'line 2', 'blank')
    refused(AZIMUTHAL, 'eta\n1.5\n1.\0 5\n', 'line 3', 'control character')
    refused([*AZIMUTHAL, '/nonexistent.csv'], None, '/nonexistent.csv')
    for on in ('cpu', 'gpu'):
        refused(['eval', 'hair', '--on', on], 'beta_R_deg\n1\n',
                'line 2, column beta_R_deg', '[2, 30]')


@case
def csv_limits_belong_to_the_range():
    for on in ('reference', 'cpu', 'gpu'):
        for corner in ('-90,-20,2,5,1.2', '90,20,30,30,2'):
            text = 'theta_i_deg,alpha_R_deg,beta_R_deg,beta_az_deg,eta\n' + corner + '\n'
            last = output('eval', 'hair', '--on', on, text=text).splitlines()[1].split(',')[-1]
            expect(math.isfinite(float(last)), f'{on} {corner}: {last}')


@case
def copied_angles_in_radians_are_warned_of():
    done = run(*AZIMUTHAL, text='theta_d\n0.3\n')
    expect(done.returncode == 0 and b'theta_d_deg' in done.stderr, done.stderr)


@case
def a_comma_locale_changes_nothing():
    plain = output(*AZIMUTHAL, text='eta,phi_deg\n1.5,20.5\n')
    with tempfile.TemporaryDirectory() as folder:
        if shutil.which('localedef'):
            subprocess.run(['localedef', '-i', 'de_DE', '-f', 'UTF-8', folder + '/de_DE.UTF-8'],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        env = {'LC_ALL': 'de_DE.UTF-8', 'LOCPATH': folder}
        expect(plain == output(*AZIMUTHAL, text='eta,phi_deg\n1.5,20.5\n', env=env), 'differs')
        glsl = ('glsl', 'marschner', '--target', '330')
        expect(output(*glsl) == output(*glsl, env=env), 'the GLSL differs')
        json.loads(output('models', '--json', env=env))


@case
def bake_writes_what_it_says():
    with tempfile.TemporaryDirectory() as folder:
        block = folder + '/page.block'
        for model in models():
            said = {}
            keys = (('color=brown', 'alpha_R_deg=-5') if model['kind'] == 'fibre' else
                    ('n=1.4', 'scatter_bottom=1.5,2,3'))
            for ending in ('bin', 'csv', 'exr'):
                path = f'{folder}/tables.{ending}'
                said[ending] = output('bake', model['name'], *keys, '--no-measure', '-o', path,
                                      '--block', block)
            expect('bytes' in said['bin'] and 'ms' in said['bin'], said['bin'])
            expect(os.path.getsize(block) == 16384, 'size of the block')
            data = pathlib.Path(folder, 'tables.bin').read_bytes()
            version, offset, width, height, channels, size = struct.unpack_from('<6I', data, 8)
            expect(data[:8] == b'TSUYATEX' and (version, offset, channels, size) == (1, 32, 4, 2),
                   data[:32])
            halves = struct.unpack_from(f'<{width * height * 4}e', data, offset)
            expect(len(data) == offset + 2 * len(halves), 'size of the file')
            head, rows = table(pathlib.Path(folder, 'tables.csv').read_text())
            expect(head == ['x', 'y', 'r', 'g', 'b', 'a'], head)
            numbers = [float(cell) for row in rows for cell in row[2:]]
            same = all(abs(a - b) <= 1e-8 * abs(b) for a, b in zip(numbers, halves))
            expect(len(numbers) == len(halves) and same, 'csv and bin differ')
            magic = pathlib.Path(folder, 'tables.exr').read_bytes()[:4]
            expect(magic == b'\x76\x2f\x31\x01', 'no EXR')


@case
def bake_measures_its_errors():
    with tempfile.TemporaryDirectory() as folder:
        said = output('bake', 'marschner', '-o', folder + '/t.bin')
        expect('error' in said, said)


@case
def bake_refuses_bad_keys_and_writes_nothing():
    with tempfile.TemporaryDirectory() as folder:
        path = folder + '/t.bin'
        bad = (('eta=3', '[1.2, 2]'), ('beta_R_deg=1', '[2, 30]'), ('eta=nan', 'nan'),
               ('etta=1.5', 'did you mean eta'), ('eta', 'key=value'), ('eta=', 'not a number'),
               ('sigma_a=1,2', 'one or three'), ('sigma_a=-1', 'outside'),
               ('color=brwn', 'did you mean brown'), ('albedo=2', 'albedo'),
               ('head_albedo=1.1', 'head_albedo'), ('head_albedo=0.013', '(0.01323'),
               ('head_albedo=nan', 'head_albedo'), ('head_albedo=0.1,0.2', 'one or three'),
               ('eumelanin=1,2', 'one number'), ('alpha_R=99', 'outside'))
        for word, part in bad:
            refused(['bake', 'marschner', word, '-o', path], None, part)
            expect(not os.listdir(folder), f'{word}: a file was written')
        refused(['bake', 'marschner', 'color=red', 'sigma_a=1', '-o', path], None, 'absorption')
        refused(['bake', 'marschner', 'eta=1.5', 'eta=1.6', '-o', path], None, 'twice')
        refused(['bake', 'marschner', '-o', folder + '/t.png'], None, '.exr')
        refused(['bake', 'marschner'], None, '-o FILE')
        refused(['bake', '-o', path], None, 'no model')


def main():
    if len(sys.argv) != 2:
        print('usage: command_test.py /path/to/tsuya', file=sys.stderr)
        return 2
    use(sys.argv[1])
    failed = 0
    for function in CASES:
        name = function.__name__.replace('_', ' ')
        try:
            function()
            print('pass', name, flush=True)
        except (Wrong, subprocess.SubprocessError, ValueError, KeyError, OSError) as why:
            failed += 1
            print('FAIL', name + ':', why, flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
