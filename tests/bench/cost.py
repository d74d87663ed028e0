#!/usr/bin/env python3
"""Static cost of fragment shaders on AMD hardware, beside the project's own baselines.

    cost.py [options] FILE.frag...
    cost.py [options] --print 'COMMAND {model}' --model NAME...

Compiles each shader with glslangValidator, asks shader_cost for its statistics and prints a table
whose first rows are the shaders of baseline/. A shader is a whole fragment shader, GLSL 330 and
later or ESSL 310 and later; plain OpenGL sources without locations, bindings and blocks will do.
For figures that compare, keep to the frame of baseline/lambert.frag.

    clocks      estimated clocks per wave of a full machine (inverse throughput)
    x lambert   clocks over those of the baseline of that name, and so on

Exit: 0 when every shader is in the table, 1 after a sentence on stderr.
"""

import argparse
import csv
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
BASELINES = ('lambert', 'kajiya_kay', 'ggx')
COLUMNS = ('inverse_throughput', 'instructions', 'latency', 'vgprs', 'sgprs', 'code_size',
           'vmem_clauses')
TITLES = ('clocks', 'instr', 'latency', 'vgpr', 'sgpr', 'bytes', 'vmem')


class Failure(Exception):
    """What went wrong, as one sentence for the user."""


def run(words, what):
    """The output of a command that must succeed."""
    try:
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, check=False)
    except OSError as error:
        raise Failure(f'{what}: {words[0]} does not start: {error.strerror}.') from error
    if done.returncode != 0:
        said = (done.stderr.strip() or done.stdout.strip() or 'no message')
        raise Failure(f'{what}: {words[0]} ended with {done.returncode}:\n{said}')
    return done.stdout


def compile_shader(source, spirv):
    """SPIR-V of one fragment shader file. -R allows uniforms outside of blocks."""
    run(['glslangValidator', '-R', '-V', '-S', 'frag', '--auto-map-locations',
         '--auto-map-bindings', source, '-o', spirv], f'{source} does not compile')


def measure(tool, family, shaders, folder):
    """{name: {statistic: value}} of [(name, source file)], in that order."""
    rows = {}
    for number, (name, source) in enumerate(shaders):
        spirv = folder / f'{number}.spv'
        compile_shader(source, spirv)
        text = run([tool, '--family', family, spirv], f'{name} has no cost')
        rows[name] = {row['statistic']: int(row['value'])
                      for row in csv.DictReader(text.splitlines())}
        missing = [column for column in COLUMNS if column not in rows[name]]
        if missing:
            raise Failure(f'{name}: shader_cost tells no {missing[0]}.')
    return rows


def print_table(rows):
    """Aligned columns, one shader a row."""
    head = ['shader', TITLES[0]] + [f'x {name}' for name in BASELINES] + list(TITLES[1:])
    lines = [head]
    for name, row in rows.items():
        clocks = row['inverse_throughput']
        ratios = [f"{clocks / rows[base]['inverse_throughput']:.2f}" for base in BASELINES]
        lines.append([name, str(clocks)] + ratios + [str(row[column]) for column in COLUMNS[1:]])
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    for line in lines:
        cells = [line[0].ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(line[1:], widths[1:])]
        print('  '.join(cells))


def print_csv(rows, family):
    """shader_cost's columns, shaders by name."""
    out = csv.writer(sys.stdout, lineterminator='\n')
    out.writerow(['shader', 'target', 'statistic', 'value'])
    for name, row in rows.items():
        out.writerows([name, family, column, row[column]] for column in COLUMNS)


def collect(options, folder):
    """[(name, source file)]: baselines, then the files, then the printed models."""
    shaders = [(name, HERE / 'baseline' / f'{name}.frag') for name in BASELINES]
    for source in options.files:
        shaders.append((source.stem, source))
    for model in options.model:
        words = [word.replace('{model}', model) for word in shlex.split(options.print)]
        source = folder / f'{model}.frag'
        source.write_text(run(words, f'{model} cannot be printed'), encoding='utf-8')
        shaders.append((model, source))
    names = [name for name, _ in shaders]
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise Failure(f'two shaders are called {twice[0]}.')
    return shaders


def main():
    """Parses the command line, measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('files', nargs='*', type=pathlib.Path, metavar='FILE.frag')
    parser.add_argument('--print', metavar='COMMAND',
                        help='prints a whole fragment shader; {model} stands for the name')
    parser.add_argument('--model', action='append', default=[], metavar='NAME',
                        help='a name for --print; may be given again')
    parser.add_argument('--tool', default=os.environ.get('SHADER_COST', 'shader_cost'),
                        help='path of shader_cost (default: $SHADER_COST, or on the PATH)')
    parser.add_argument('--family', default='navi21', help='chip to compile for (navi21)')
    parser.add_argument('--csv', action='store_true', help='print CSV, not a table')
    options = parser.parse_args()
    if bool(options.print) != bool(options.model):
        parser.error('--print and --model go together')
    try:
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            rows = measure(options.tool, options.family, collect(options, folder), folder)
    except Failure as failure:
        print(f'cost: {failure}', file=sys.stderr)
        return 1
    if options.csv:
        print_csv(rows, options.family)
    else:
        print_table(rows)
    return 0


if __name__ == '__main__':
    sys.exit(main())
