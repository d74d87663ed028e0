#!/usr/bin/env python3
"""What a tier costs with lobes left out: clocks, bytes of text and of tables.

    choices.py TSUYA SHADER_COST            fresh figures against results/choices.csv, within 3 %
    choices.py TSUYA SHADER_COST --write    write results/choices.csv

results/choices.csv is `tier,quantity,key,value`, the key the lobes that are left out, joined by +,
or none:

    choice_clocks    estimated clocks per wave of a full navi21 (inverse throughput)
    choice_text      bytes of GLSL for target 330, of the functions that the tier calls (--only)
    choice_whole     the same with all functions of the model
    choice_bytes     of the tables of one material

Held as well: every lobe that is left out lowers clocks and text, whatever else is left out, and the
chosen functions are less text than all. Exit: 0, or 1 after the reasons on stderr.
"""

import csv
import itertools
import pathlib
import re
import sys
import tempfile

import cost
import static
import tiers

RESULT = static.HERE / 'results' / 'choices.csv'
TARGET = 'navi21'
FIBER = ('trt', 'residual')
LOBES = {'marschner': FIBER, 'dual_scattering': FIBER + ('back',),
         'plane_parallel_hair': FIBER + ('back',), 'leaf_coarse': ('transmitted',),
         'leaf_body': ('transmitted',), 'leaf': ('transmitted',)}


def choices(tier):
    """Every set of the tier's lobes, the empty one first."""
    lobes = LOBES.get(tier.model, ())
    for count in range(len(lobes) + 1):
        yield from itertools.combinations(lobes, count)


def text_bytes(tsuya, tier, options):
    """Bytes of the text that `tsuya glsl` prints for a tier."""
    fine = ['--variant', 'fine'] if tier.fine else []
    words = [tsuya, 'glsl', tier.model, '--target', '330', *fine, *options]
    return len(cost.run(words, tier.name).encode())


def measure(tsuya, tool):
    """{(tier, quantity, key): value}."""
    result = {}
    memory = tiers.table_bytes(tsuya)
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        for tier in tiers.TIERS.values():
            only = ','.join(sorted(set(re.findall(r'tsu_\w+', tier.expression))))
            for dropped in choices(tier):
                key = '+'.join(dropped) or 'none'
                drop = ['--drop', ','.join(dropped)] if dropped else []
                frag = pathlib.Path(folder) / f'{tier.name}.{key}.frag'
                frag.write_text(tiers.source(tsuya, tier, *drop), encoding='utf-8')
                files[tier.name, key] = frag.with_suffix('.spv')
                cost.compile_shader(frag, files[tier.name, key])
                result[tier.name, 'choice_text', key] = \
                    text_bytes(tsuya, tier, drop + ['--only', only])
                result[tier.name, 'choice_whole', key] = text_bytes(tsuya, tier, drop)
                result[tier.name, 'choice_bytes', key] = memory[tier.name]
        rows = static.statistics(tool, TARGET, files.values())
        for (name, key), file in files.items():
            result[name, 'choice_clocks', key] = rows[str(file)]['inverse_throughput']
    return dict(sorted(result.items(), key=lambda row: (list(tiers.TIERS).index(row[0][0]),
                                                        row[0][1])))


def relations(rows):
    """Sentences on choices that save nothing."""
    wrong = []
    for (name, quantity, key), value in rows.items():
        if quantity == 'choice_text' and value >= rows[name, 'choice_whole', key]:
            wrong.append(f'{name}, {key}: chosen functions are no less text than all')
        if quantity == 'choice_bytes' or key == 'none':
            continue
        lobes = key.split('+')
        for lobe in lobes:
            with_it = '+'.join(other for other in lobes if other != lobe) or 'none'
            if value >= rows[name, quantity, with_it]:
                wrong.append(f'{name}: {quantity} is {value} without {key} and '
                             f'{rows[name, quantity, with_it]} with {lobe}')
    return wrong


def judge(fresh, used):
    """Sentences on what is wrong."""
    comments, committed = static.read(RESULT)
    if f'# driver: {used}' not in comments:
        return [f'this is {used}, {RESULT.name} was made with another. {static.ADVICE}']
    wrong = static.differences(committed, fresh, RESULT.name)
    wrong += [f'{RESULT.name}: {" ".join(key)} is missing' for key in fresh if key not in committed]
    return wrong + relations(fresh)


def write(rows, used):
    """Replaces the committed table."""
    with RESULT.open('w', encoding='utf-8') as file:
        file.write('# Cost and size of tiers with lobes left out.\n'
                   f'# driver: {used}\n'
                   '# command: tests/bench/choices.py TSUYA SHADER_COST --write\n'
                   f'# clocks on {TARGET}; text for target 330\n')
        out = csv.writer(file, lineterminator='\n')
        out.writerow(('tier', 'quantity', 'key', 'value'))
        out.writerows((*key, value) for key, value in rows.items())


def main():
    """Measures, then writes or judges."""
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ['--write']):
        sys.exit('usage: choices.py TSUYA SHADER_COST [--write]')
    try:
        used = static.driver(sys.argv[2])
        fresh = measure(*sys.argv[1:3])
    except cost.Failure as failure:
        sys.exit(f'choices: {failure}')
    print(f'{"tier":18} {"without":20} {"clocks":>6} {"text":>6} {"whole":>6} {"tables":>7}')
    for name, quantity, key in fresh:
        if quantity == 'choice_clocks':
            print(f'{name:18} {key:20} {fresh[name, quantity, key]:6}'
                  f' {fresh[name, "choice_text", key]:6} {fresh[name, "choice_whole", key]:6}'
                  f' {fresh[name, "choice_bytes", key]:7}')
    if len(sys.argv) == 4:
        write(fresh, used)
        wrong = relations(fresh)
    else:
        wrong = judge(fresh, used)
    if wrong:
        sys.exit('\n'.join(f'choices: {text}' for text in wrong))


if __name__ == '__main__':
    main()
