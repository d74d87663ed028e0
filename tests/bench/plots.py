#!/usr/bin/env python3
"""Plots of the trade table: error against cost with the Pareto front, error against distance.

    plots.py TRADE.csv FOLDER [--lod LOD.csv]

Writes FOLDER/trade-hair.svg (one panel a hair tone), trade-leaf.svg and, from LOD.csv,
lod.svg. Cost: clocks on navi21 (inverse throughput, one light); error of hair: root of relative
MSE of pictures against the path tracer; of leaves: of BRDF and BTDF against the solver, as a share
of the lobe's peak, worst of the species.
"""

import argparse
import collections
import csv
import math
import pathlib
import sys

COLORS = {'unshadowed': '#8c8c8c', 'kajiya_kay': '#c98a00', 'marschner': '#1f77b4',
          'zinke': '#b55fa8', 'exact': '#2a9d5c', 'plane_parallel': '#c0392b',
          'leaf_coarse': '#c98a00', 'leaf_body': '#2a9d5c', 'leaf': '#1f77b4',
          'leaf_body_uniform': '#7cc79b', 'leaf_uniform': '#84b6dc'}
TONES = ('black', 'brown', 'blond', 'white', 'dyed')
INK, GRID = '#333', '#ddd'


def read_table(path):
    """{tier: {(quantity, key): value}} of the trade table."""
    table = collections.OrderedDict()
    lines = [line for line in pathlib.Path(path).read_text('utf-8').splitlines()
             if line and line[0] != '#']
    for row in csv.DictReader(lines):
        table.setdefault(row['tier'], {})[row['quantity'], row['key']] = row['value']
    return table


class Panel:
    """Axes with logarithmic scales in a rectangle of the drawing."""

    def __init__(self, box, x_range, y_range, log_x=True):
        self.left, self.top, self.width, self.height = box
        self.x_range, self.y_range, self.log_x = x_range, y_range, log_x
        self.parts = []

    def x(self, value):
        low, high = self.x_range
        share = (math.log(value / low) / math.log(high / low) if self.log_x
                 else (value - low) / (high - low))
        return self.left + self.width * share

    def y(self, value):
        low, high = self.y_range
        value = min(max(value, low), high)
        return self.top + self.height * (1 - math.log(value / low) / math.log(high / low))

    def text(self, x, y, text, anchor='middle', size=11, color=INK, weight='normal'):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" '
                          f'font-size="{size}" fill="{color}" font-weight="{weight}">{text}</text>')

    def line(self, points, color, width=1.0, dash=''):
        path = ' '.join(f'{x:.1f},{y:.1f}' for x, y in points)
        dash = f' stroke-dasharray="{dash}"' if dash else ''
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" '
                          f'stroke-width="{width}"{dash}/>')

    def dot(self, x, y, color, hollow=False):
        fill = 'white' if hollow else color
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{fill}" '
                          f'stroke="{color}" stroke-width="1.8"/>')

    def axes(self, title, x_ticks, y_ticks, x_label='', y_label='', percent=True):
        bottom, right = self.top + self.height, self.left + self.width
        for tick in x_ticks:
            self.line([(self.x(tick), self.top), (self.x(tick), bottom)], GRID, 0.7)
            self.text(self.x(tick), bottom + 14, f'{tick:g}', size=10)
        for tick in y_ticks:
            self.line([(self.left, self.y(tick)), (right, self.y(tick))], GRID, 0.7)
            label = f'{100 * tick:g} %' if percent else f'{tick:g}'
            self.text(self.left - 5, self.y(tick) + 3.5, label, 'end', 10)
        self.line([(self.left, self.top), (self.left, bottom), (right, bottom)], INK, 1.0)
        self.text(self.left + self.width / 2, self.top - 8, title, size=12.5, weight='bold')
        if x_label:
            self.text(self.left + self.width / 2, bottom + 30, x_label, size=11)
        if y_label:
            x, y = self.left - 46, self.top + self.height / 2
            self.parts.append(f'<text transform="translate({x:.1f},{y:.1f}) rotate(-90)" '
                              f'text-anchor="middle" font-size="11" fill="{INK}">{y_label}</text>')


def front(points):
    """Names of the points that no other beats in both cost and error, by rising cost."""
    kept = []
    for name, cost, error in sorted(points, key=lambda p: (p[1], p[2])):
        if not kept or error < kept[-1][2]:
            kept.append((name, cost, error))
    return kept


def scatter(panel, points, labels):
    """Dots, filled on the Pareto front, and the front as steps."""
    best = front(points)
    steps = []
    for i, (_, cost, error) in enumerate(best):
        steps += [(panel.x(cost), panel.y(best[i - 1][2])) if i else
                  (panel.x(cost), panel.top), (panel.x(cost), panel.y(error))]
    steps.append((panel.left + panel.width, panel.y(best[-1][2])))
    panel.line(steps, '#999', 1.2, '4 3')
    names = {name for name, _, _ in best}
    for name, cost, error in points:
        panel.dot(panel.x(cost), panel.y(error), COLORS[name], name not in names)
        if labels:
            panel.text(panel.x(cost) + 7, panel.y(error) - 5, name, 'start', 10, COLORS[name])


def write(path, width, height, panels, legend=()):
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
             f'width="{width}" height="{height}" font-family="Helvetica,Arial,sans-serif">',
             f'<rect width="{width}" height="{height}" fill="white"/>']
    for panel in panels:
        parts += panel.parts
    x = 60
    for name in legend:
        parts.append(f'<circle cx="{x}" cy="{height - 14}" r="4.5" fill="{COLORS[name]}"/>')
        parts.append(f'<text x="{x + 9}" y="{height - 10}" font-size="11" fill="{INK}">{name}'
                     '</text>')
        x += 30 + 7 * len(name)
    path.write_text('\n'.join(parts + ['</svg>', '']), encoding='utf-8')
    print(path)


def number(row, *key):
    return float(row[key]) if key in row else None


def plot_hair(table, folder):
    tiers = [name for name in table if number(table[name], 'rms', 'blond') is not None]
    panels = []
    for i, tone in enumerate(TONES):
        points = [(name, number(table[name], 'clocks', 'navi21'), number(table[name], 'rms', tone))
                  for name in tiers]
        points = [p for p in points if p[2] is not None]
        if not points:
            continue
        panel = Panel((62 + 190 * i, 34, 155, 210), (105, 650), (0.15, 12))
        panel.axes(tone, (130, 260, 500), (0.2, 0.5, 1, 2, 5, 10),
                   'clocks' if i == 2 else '',
                   'root of relative MSE' if i == 0 else '')
        scatter(panel, points, False)
        panels.append(panel)
    write(folder / 'trade-hair.svg', 1000, 320, panels, tiers)


def plot_leaf(table, folder):
    tiers = [name for name in table if number(table[name], 'error', 'reflected') is not None]
    panels = []
    for i, lobe in enumerate(('reflected', 'transmitted')):
        points = [(name, number(table[name], 'clocks', 'navi21'),
                   max(float(value) for (quantity, key), value in table[name].items()
                       if quantity == 'error' and key.startswith(lobe + '.'))) for name in tiers]
        panel = Panel((70 + 390 * i, 34, 320, 210), (180, 360), (0.002, 0.1))
        panel.axes(lobe, (200, 220, 260, 310), (0.002, 0.005, 0.01, 0.02, 0.05, 0.1), 'clocks',
                   'share of the peak, worst species' if i == 0 else '')
        scatter(panel, points, False)
        panels.append(panel)
    write(folder / 'trade-leaf.svg', 810, 320, panels, tiers)


def plot_lod(path, folder):
    rows = [row for row in csv.DictReader(
        line for line in path.read_text('utf-8').splitlines() if line and line[0] != '#')]
    tiers = list(collections.OrderedDict.fromkeys(row['tier'] for row in rows))
    panels = []
    scenes = list(collections.OrderedDict.fromkeys(row['scene'] for row in rows))
    for i, scene in enumerate(scenes):
        mine = [row for row in rows if row['scene'] == scene]
        away = sorted({float(row['distance']) for row in mine})
        panel = Panel((70 + 330 * i, 34, 265, 230), (away[0], away[-1]), (0.1, 12))
        panel.axes(scene, away, (0.1, 0.2, 0.5, 1, 2, 5, 10), 'distance (1: the head fills the picture)',
                   'root of relative MSE' if i == 0 else '')
        for tier in tiers:
            line = [(panel.x(float(row['distance'])), panel.y(float(row['rms'])))
                    for row in mine if row['tier'] == tier]
            panel.line(line, COLORS[tier], 1.8)
            chosen = [row for row in mine if row['tier'] == tier and row['chosen'] == '1']
            for row in chosen:
                panel.dot(panel.x(float(row['distance'])), panel.y(float(row['rms'])),
                          COLORS[tier])
        panels.append(panel)
    write(folder / 'lod.svg', 80 + 330 * len(scenes), 340, panels, tiers)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('table', type=pathlib.Path)
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('--lod', type=pathlib.Path)
    options = parser.parse_args()
    table = read_table(options.table)
    plot_hair(table, options.folder)
    plot_leaf(table, options.folder)
    if options.lod:
        plot_lod(options.lod, options.folder)
    return 0


if __name__ == '__main__':
    sys.exit(main())
