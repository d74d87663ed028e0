#!/usr/bin/env python3
"""Turns the trade table into a C table: embed.py OUTPUT.c TRADE.csv

TRADE.csv is `tier,quantity,key,value` after lines that begin with #, which say where it comes from
and become the text of tsu_trade_source(). What must be in it is the rest of this file: a row that
is missing, twice there, unknown or no finite number ends the build with its line.
"""
import csv
import math
import sys

# Not on offer: dual_scattering's variant zinke, which costs more than exact and plane_parallel and
# errs more on hair of every tone (tests/reference/claims.py).
# name -> kind, model, variant of its entry point, flags of tsu_tier_info, lobes that can be dropped
TIERS = {
    'unshadowed': ('HAIR', 'kajiya_kay', '', '', ''),
    'kajiya_kay': ('HAIR', 'kajiya_kay', '', 'SHADOW', ''),
    'marschner': ('HAIR', 'marschner', '', 'SHADOW', 'TRT|RESIDUAL'),
    'exact': ('HAIR', 'dual_scattering', 'finite', 'SHADOW', 'TRT|RESIDUAL|BACK'),
    'plane_parallel': ('HAIR', 'plane_parallel_hair', 'finite', 'SHADOW', 'TRT|RESIDUAL|BACK'),
    'leaf_coarse': ('LEAF', 'leaf_coarse', '', '', 'TRANSMITTED'),
    'leaf_body': ('LEAF', 'leaf_body', '', '', 'TRANSMITTED'),
    'leaf_body_uniform': ('LEAF', 'leaf_body', 'uniform', 'UNIFORM', 'TRANSMITTED'),
    'leaf': ('LEAF', 'leaf', '', 'COAT', 'TRANSMITTED'),
    'leaf_uniform': ('LEAF', 'leaf', 'uniform', 'UNIFORM|COAT', 'TRANSMITTED'),
}
HAIR = [t for t in TIERS if TIERS[t][0] == 'HAIR']
LEAF = [t for t in TIERS if TIERS[t][0] == 'LEAF']
GPUS = ('navi21', 'navi10', 'vega10', 'gfx1100')
TONES = ('black', 'brown', 'blond', 'white', 'dyed')
# In the order of the traits' bits in tsu_choice.outside.
RANGES = ('sigma_a', 'sky_share', 'light_cosine', 'strand_pixels', 'depth', 'curl', 'beta_R')
TRAITS = 'uqkwdob'
TERMS = (['1'] + list(TRAITS) +
         [a + '*' + b for i, a in enumerate(TRAITS) for b in TRAITS[i:]] +
         [power + a for power in ('u*u*', 'u*u*u*') for a in TRAITS])
# A species' colours, nine numbers, and the sides of the errors.
COLORS = [f'{side}.{channel}' for side in ('R_top', 'R_bottom', 'T') for channel in 'rgb']
# Quantities that are for people and plots, not for the chooser: keys are free.
FREE = ('instructions', 'latency', 'vgprs', 'sgprs', 'code_size', 'pixel')


class Failure(Exception):
    """What is wrong with the table, as one sentence."""


def read(path):
    """(lines of provenance, {(tier, quantity, key): number}) of a table."""
    source, rows = [], {}
    with open(path, encoding='utf-8', newline='') as file:
        for number, cells in enumerate(csv.reader(file), 1):
            where = f'{path}:{number}'
            if cells and cells[0].startswith('#'):
                source.append(','.join(cells).lstrip('# ').rstrip())
                continue
            if cells == ['tier', 'quantity', 'key', 'value']:
                continue
            if len(cells) != 4:
                raise Failure(f'{where}: {len(cells)} cells, expected tier,quantity,key,value')
            row = tuple(cells[:3])
            if cells[0] != '*' and cells[0] not in TIERS:
                raise Failure(f'{where}: no tier is called {cells[0]}')
            if row in rows:
                raise Failure(f'{where}: {",".join(row)} is there twice')
            try:
                rows[row] = float(cells[3])
            except ValueError:
                rows[row] = math.nan
            if not math.isfinite(rows[row]):
                raise Failure(f'{where}: {",".join(row)} = {cells[3]} is no number')
    if not source:
        raise Failure(f'{path}: no line says where the table comes from')
    return source, rows


class Table:
    """Rows that are taken out one by one, so that what is left over is unknown."""

    def __init__(self, path):
        self.path = path
        self.source, self.rows = read(path)
        self.taken = set()

    def take(self, tier, quantity, key=''):
        row = (tier, quantity, key)
        if row not in self.rows:
            raise Failure(f'{self.path}: no row {tier},{quantity},{key}')
        self.taken.add(row)
        return self.rows[row]

    def keys(self, tier, quantity):
        return [k for t, q, k in self.rows if (t, q) == (tier, quantity)]

    def finish(self):
        for row in self.rows:
            if row not in self.taken and row[1] not in FREE:
                raise Failure(f'{self.path}: nothing reads row {",".join(row)}')


def number(value):
    return repr(float(value))


def numbers(values):
    return '{' + ', '.join(number(v) for v in values) + '}'


def string(text):
    return '"' + text.replace('\\', '\\\\').replace('"', '\\"') + '"'


def species_of(table):
    """Names of the leaves whose errors are known, in the table's order."""
    names = []
    for key in table.keys('*', 'species'):
        name = key.split('.')[0]
        if name not in names:
            names.append(name)
    if not names:
        raise Failure(f'{table.path}: no row *,species,NAME.R_top.r')
    return names


def hair(table, name, out):
    fits = {}
    for what in ('rms', 'luminance'):
        fits[what] = [table.take(name, 'fit_' + what, term) for term in TERMS]
        spread = table.take(name, 'spread', what)
        if spread < 0.0:
            raise Failure(f'{table.path}: {name},spread,{what} is below 0')
        out.append(f'static const struct tsu_i_trade_fit {name}_{what} = {{{number(spread)},\n    '
                   f'{numbers(table.take(name, what, tone) for tone in TONES)},\n    '
                   f'{numbers(fits[what])}}};\n')


def leaf(table, name, species, out):
    """Errors a species, the last those of the model's whole range."""
    for what in ('reflected', 'transmitted'):
        values = [table.take(name, 'error', f'{what}.{s}') for s in species]
        values.append(table.take(name, 'error', what))
        out.append(f'static const double {name}_{what}[] = {numbers(values)};\n')
    values = [table.take(name, 'luminance', s) for s in species]
    values.append(table.take(name, 'luminance', 'leaf'))
    out.append(f'static const double {name}_luminance[] = {numbers(values)};\n')
    for quantity in ('error', 'luminance') if 'COAT' not in TIERS[name][3] else ():
        values = [table.take(name, quantity, f'coat.{s}') for s in species]
        values.append(table.take(name, quantity, 'coat'))
        out.append(f'static const double {name}_coat_{quantity}[] = {numbers(values)};\n')


def lobes(table, out):
    """Shares of light lost with a lobe: trt/SIGMA, residual/SIGMA, back/FIBRES/SIGMA."""
    found = {}
    for key in table.keys('*', 'lobe_share'):
        cells = key.split('/')
        value = table.take('*', 'lobe_share', key)
        if cells[0] == 'back' and len(cells) == 2:
            continue  # the most over sigma_a: for people
        try:
            found[(cells[0], *map(float, cells[1:]))] = value
        except ValueError as error:
            raise Failure(f'{table.path}: *,lobe_share,{key}: no number after /') from error
    sigmas = sorted({key[-1] for key in found})
    depths = sorted({key[1] for key in found if key[0] == 'back'})
    rows = [('trt',), ('residual',), *(('back', depth) for depth in depths)]
    wanted = {(*row, sigma) for row in rows for sigma in sigmas}
    if not sigmas or not depths or set(found) != wanted:
        raise Failure(f'{table.path}: *,lobe_share: expected trt/S, residual/S and back/N/S for '
                      f'all S and N; differs in {sorted(wanted ^ set(found), key=str)[:3]}')
    out.append(f'static const double lobe_sigma[] = {numbers(sigmas)};\n'
               f'static const double lobe_depth[] = {numbers(depths)};\n')
    shares = ', '.join(number(found[(*row, sigma)]) for row in rows for sigma in sigmas)
    out.append(f'static const double lobe_share[] = {{{shares}}};\n')
    return f'{{{len(sigmas)}, {len(depths)}, lobe_sigma, lobe_depth, lobe_share}}'


def bits_of(prefix, names):
    return ' | '.join(prefix + name for name in names.split('|')) if names else '0'


def tier(table, name):
    kind, model, variant, flags, drops = TIERS[name]
    clocks = [table.take(name, 'clocks', gpu) for gpu in GPUS]
    if min(clocks) <= 0.0:
        raise Failure(f'{table.path}: {name},clocks is not above 0')
    maps = [table.take(name, 'map_clocks', gpu) for gpu in GPUS] if 'SHADOW' in flags else [0.0] * 4
    cells = [string(name), string(model), string(variant), 'TSU_CHOOSE_' + kind,
             bits_of('TSU_TIER_', flags), bits_of('TSU_SHADER_DROP_', drops), numbers(clocks),
             numbers(maps)]
    cells += [str(int(table.take(name, what))) for what in ('fetches', 'bytes', 'samplers')]
    cells += [f'&{name}_rms, &{name}_luminance' if kind == 'HAIR' else 'NULL, NULL']
    cells += [f'{name}_reflected, {name}_transmitted, {name}_luminance' if kind == 'LEAF'
              else 'NULL, NULL, NULL']
    cells += [f'{name}_coat_error, {name}_coat_luminance' if kind == 'LEAF' and 'COAT' not in flags
              else 'NULL, NULL']
    return '    {' + ',\n     '.join(cells) + '},\n'


def embed(path):
    """The C text of a table."""
    table = Table(path)
    out = ['#include "choose/trade.h"\n\n']
    species = species_of(table)
    for name in HAIR:
        hair(table, name, out)
    for name in LEAF:
        leaf(table, name, species, out)
    for name in TIERS:  # measured at several levels, for people
        for key in table.keys(name, 'error'):
            if key.split('.')[0] in ('fiber', 'slab'):
                table.taken.add((name, 'error', key))
    shares = lobes(table, out)
    out.append('static const struct tsu_i_trade_tier tiers[] = {\n')
    out += [tier(table, name) for name in TIERS]
    out.append('};\nstatic const struct tsu_i_trade_species species[] = {\n')
    for name in species:
        colors = numbers(table.take('*', 'species', f'{name}.{c}') for c in COLORS)
        out.append(f'    {{{string(name)}, {colors}}},\n')
    out.append('};\nconst struct tsu_i_trade tsu_i_trade = {\n')
    for line in table.source:
        out.append('    ' + string(line)[:-1] + '\\n"\n')
    out.append(f'    , sizeof tiers / sizeof *tiers, tiers, {len(species)}, species,\n    {{')
    for name in RANGES:
        ends = [table.take('*', 'range', f'{name}.{end}') for end in ('min', 'max')]
        if ends[0] > ends[1]:
            raise Failure(f'{path}: *,range,{name} is empty')
        out.append(numbers(ends) + ', ')
    out.append('},\n    ' + number(table.take('*', 'margin', 'z')) + ',\n    ' + shares + '};\n')
    table.finish()
    return ''.join(out)


def main(output, path):
    try:
        text = embed(path)
    except (Failure, OSError, UnicodeDecodeError) as failure:
        sys.exit(f'trade table: {failure}')
    with open(output, 'w', encoding='utf-8') as out:
        out.write(text)


if __name__ == '__main__':
    main(*sys.argv[1:])
