#!/usr/bin/env python3
"""The gate of static cost: every tier and baseline against the committed figures.

    static.py TSUYA SHADER_COST            fresh figures against results/static.csv, within 3 %
    static.py TSUYA SHADER_COST --write    write results/static.csv

Compiles the shader of each tier for four AMD chips with the driver's compiler, no device needed.
results/static.csv is `tier,quantity,key,value`, the key a chip or nothing:

    clocks        estimated clocks per wave of a full machine (inverse throughput)
    instructions, latency, vgprs, sgprs, code_size
    fetches       from textures, a pixel and light
    bytes         of the tables of one material
    samplers      that the shader reads
    map_clocks    that a look into a light's deep opacity map of 8 layers adds, where the tier
                  asks for one: for counts and direct share, or for the transmittance alone
Rows of the trade table (runtime/choose/trade.csv) with these quantities are held to the same.
Figures belong to one version of Mesa; another one fails and says so. Exit: 0, or 1 after the
reasons on stderr.
"""

import csv
import pathlib
import re
import sys
import tempfile

import cost
import tiers

HERE = pathlib.Path(__file__).resolve().parent
RESULT = HERE / 'results' / 'static.csv'
TRADE = HERE.parent.parent / 'runtime' / 'choose' / 'trade.csv'
LOOKS = ('direct', 'transmittance')  # what a tier may ask the map for
TARGETS = ('navi21', 'navi10', 'vega10', 'gfx1100')
COLUMNS = {'inverse_throughput': 'clocks', 'instructions': 'instructions', 'latency': 'latency',
           'vgprs': 'vgprs', 'sgprs': 'sgprs', 'code_size': 'code_size'}
TOLERANCE = 0.03
ADVICE = ('Figures of another compiler do not compare: run this with that Mesa, or measure all anew '
          'with static.py TSUYA SHADER_COST --write and commit the result.')


def driver(tool):
    """'radv Mesa 22.3.6'."""
    return cost.run([tool, '--family', TARGETS[0], '--driver'], 'asking for the driver').strip()


def statistics(tool, family, files):
    """{file: {statistic: value}} of SPIR-V files."""
    text = cost.run([tool, '--family', family, *files], f'cost on {family}')
    rows = {str(file): {} for file in files}
    for row in csv.DictReader(text.splitlines()):
        rows[row['file']][row['statistic']] = int(row['value'])
    return rows


def measure(tsuya, tool):
    """{(tier, quantity, key): value} of all tiers and baselines."""
    result = {}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        shaders = {f'baseline_{name}': HERE / 'baseline' / f'{name}.frag' for name in cost.BASELINES}
        for tier in tiers.TIERS.values():
            shaders[tier.name] = folder / f'{tier.name}.frag'
            shaders[tier.name].write_text(tiers.source(tsuya, tier), encoding='utf-8')
        for name, text in zip((*LOOKS, 'no look'), tiers.map_sources(tsuya)):
            shaders[name] = folder / f'{name}.frag'
            shaders[name].write_text(text, encoding='utf-8')
        files = {name: folder / f'{name}.spv' for name in shaders}
        for name, source in shaders.items():
            cost.compile_shader(source, files[name])
        rows = {target: statistics(tool, target, files.values()) for target in TARGETS}
    memory = tiers.table_bytes(tsuya)
    none = str(files.pop('no look'))
    looks = {name: str(files.pop(name)) for name in LOOKS}
    for name, file in files.items():
        for column, quantity in COLUMNS.items():
            for target in TARGETS:
                result[name, quantity, target] = rows[target][str(file)][column]
        fetches = {rows[target][str(file)]['fetches'] for target in TARGETS}
        if len(fetches) != 1:
            raise cost.Failure(f'{name}: chips differ in their fetches: {sorted(fetches)}.')
        result[name, 'fetches', ''] = fetches.pop()
        if name in tiers.TIERS and result[name, 'fetches', ''] != tiers.TIERS[name].fetches:
            raise cost.Failure(f'{name}: {result[name, "fetches", ""]} fetches, '
                               f'{tiers.TIERS[name].fetches} in {tiers.LIST.name}.')
        look = looks.get(next((word for word in LOOKS if name in tiers.TIERS and re.search(
            rf'\b{word}\b', tiers.TIERS[name].expression)), None))
        for target in TARGETS if look else ():
            result[name, 'map_clocks', target] = (rows[target][look]['inverse_throughput'] -
                                                  rows[target][none]['inverse_throughput'])
        result[name, 'samplers', ''] = min(result[name, 'fetches', ''], 1)
        result[name, 'bytes', ''] = memory.get(name, 0)
    return result


def read(path):
    """(comment lines, {(tier, quantity, key): value}) of a table `tier,quantity,key,value`."""
    lines = path.read_text(encoding='utf-8').splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith('#')))
    return ([line for line in lines if line.startswith('#')],
            {(row['tier'], row['quantity'], row['key']): row['value'] for row in rows})


def write(rows, made_with):
    """Replaces the committed table."""
    with RESULT.open('w', encoding='utf-8') as file:
        file.write('# Static cost of tiers and baselines, as the compiler of a GPU estimates it.\n'
                   f'# driver: {made_with}\n'
                   '# command: tests/bench/static.py TSUYA SHADER_COST --write\n'
                   '# frame: one light; directions, colour or factors, shadow as varyings; '
                   'demo/bench/tiers.inc\n')
        out = csv.writer(file, lineterminator='\n')
        out.writerow(('tier', 'quantity', 'key', 'value'))
        out.writerows((*key, value) for key, value in rows.items())


def differences(rows, fresh, where):
    """Sentences on rows of a file that a fresh run does not confirm."""
    found = []
    for key, text in rows.items():
        name = ' '.join(filter(None, key))
        if key not in fresh:
            found.append(f'{where}: {name} is measured no more')
        elif not abs(float(text) - fresh[key]) <= TOLERANCE * fresh[key]:
            found.append(f'{where}: {name} is {text}, measured {fresh[key]}')
    return found


def print_table(rows):
    """Clocks, and how many times Lambert's, of every tier."""
    print(f'{"clocks (x lambert, x ggx)":20}' + ''.join(f'{target:>22}' for target in TARGETS))
    for name in dict.fromkeys(key[0] for key in rows):
        cells = []
        for target in TARGETS:
            clocks, lambert, ggx = (rows[n, 'clocks', target]
                                    for n in (name, 'baseline_lambert', 'baseline_ggx'))
            cells.append(f'{clocks:6} ({clocks / lambert:5.2f}, {clocks / ggx:5.2f})')
        print(f'{name:20}' + ''.join(f'{cell:>22}' for cell in cells)
              + f'{rows[name, "fetches", ""]:4} fetches')


def judge(fresh, used):
    """Sentences on what is wrong."""
    comments, committed = read(RESULT)
    made_with = [line[10:] for line in comments if line.startswith('# driver: ')]
    if made_with != [used]:
        return [f'this is {used}, {RESULT.name} was made with {", ".join(made_with)}. {ADVICE}']
    wrong = differences(committed, fresh, RESULT.name)
    wrong += [f'{RESULT.name}: {" ".join(filter(None, key))} is missing'
              for key in fresh if key not in committed]
    if TRADE.is_file():
        quantities = {key[1] for key in fresh}
        trade = {key: text for key, text in read(TRADE)[1].items() if key[1] in quantities}
        if not trade:
            wrong.append(f'{TRADE.name}: it has no static cost')
        wrong += differences(trade, fresh, TRADE.name)
    return wrong


def main():
    """Measures, then writes or judges."""
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ['--write']):
        sys.exit('usage: static.py TSUYA SHADER_COST [--write]')
    try:
        used = driver(sys.argv[2])
        fresh = measure(*sys.argv[1:3])
    except cost.Failure as failure:
        sys.exit(f'static: {failure}')
    print(f'driver: {used}')
    print_table(fresh)
    if len(sys.argv) == 4:
        write(fresh, used)
        return
    wrong = judge(fresh, used)
    if wrong:
        sys.exit('\n'.join(f'static: {text}' for text in wrong))


if __name__ == '__main__':
    main()
