"""`tsuya bench`: form, completeness and counts of what it prints. Times are judged by nobody."""

import math
import pathlib
import re

from command_support import case, expect, models, output, refused, table

LIST = pathlib.Path(__file__).resolve().parents[2] / 'demo' / 'bench' / 'tiers.inc'
TIERS = dict(re.findall(r'^TIER\((\w+), (\w+),', LIST.read_text('utf-8'), re.M))
BASELINES = ('baseline_lambert', 'baseline_ggx', 'baseline_kajiya_kay')
PAGE, PAGE_MATERIALS = 16384, 127


@case
def bench_prints_every_tier():
    expect({'unshadowed', 'exact', 'leaf_uniform'} <= set(TIERS), TIERS)
    text = output('bench', '--csv', '--size', '8', '--rounds', '1')
    comments = [line for line in text.splitlines() if line.startswith('# ')]
    for what in ('processor: ', 'GL: ', 'pixels timed by: '):
        expect(sum(line.startswith('# ' + what) for line in comments) == 1, comments)
    head, lines = table(text)
    expect(head == ['tier', 'quantity', 'key', 'value'], head)
    rows = {tuple(line[:3]): float(line[3]) for line in lines}
    expect(len(rows) == len(lines), 'a row is there twice')
    driver = {key[2].split('/')[0] for key in rows if key[1] == 'pixel'}
    expect(len(driver) == 1, driver)
    driver = driver.pop()
    for name in [*TIERS, *BASELINES]:
        for what in ('ns', 'wall_ns', 'lambert', 'ggx'):
            value = rows.pop((name, 'pixel', f'{driver}/{what}'))
            expect(math.isfinite(value) and value > 0, (name, what, value))
    tables = {m['name']: m['tables'] for m in models()}
    for name, model in TIERS.items():
        size = rows.pop((name, 'bytes', ''))
        memory = sum(t['bytes'] for t in tables[model] if t['variant'] in ('', name))
        expect(size == memory, (name, size, memory))
        fetches = rows.pop((name, 'fetches', ''))
        expect(fetches == int(fetches) and 0 <= fetches < 32, (name, fetches))
        time = rows.pop((name, 'bake_ms', ''))
        expect(math.isfinite(time) and (time > 0) == (size > 0), (name, time))
    calls = set()
    for count in (1, 10, 100, 1000, 10000):
        pages = -(-count // PAGE_MATERIALS)
        for frame, sent in (('unchanged', 0), ('bind', 0), ('one_changed', PAGE),
                            ('all_changed', pages * PAGE)):
            def take(what):
                return rows.pop(('api', f'{frame}.{what}', str(count)))
            expect(take('ns') > 0, (frame, count))
            expect(take('allocations') == 0, (frame, count))
            value = take('bytes')
            expect(value == sent, (frame, count, value))
            value = take('calls')
            if frame in ('unchanged', 'bind'):
                calls.add(value)  # an unchanged set is not looked at by GL
            else:
                expect(value > max(calls), (frame, count, value))
    expect(len(calls) == 1 and 1 <= max(calls) <= 6, calls)
    expect(not rows, f'unknown rows: {list(rows)[:3]}')


@case
def bench_parts_and_tables():
    text = output('bench', '--only', 'memory')
    expect('processor: ' in text and 'fetches' in text and 'ns/pixel' not in text, text)
    for name in TIERS:
        expect(re.search(rf'^{name} +\d+ +\d+$', text, re.M), name)


@case
def bench_refuses():
    refused(['bench', 'marschner'], None, 'no argument')
    refused(['bench', '--only', 'pixels'], None, 'did you mean pixel')
    refused(['bench', '--size', '7'], None, '[8, 4096]')
    refused(['bench', '--size', 'nan'], None, 'nan')
    refused(['bench', '--rounds', '1.5'], None, 'whole number')
    refused(['bench', '--rounds', '0'], None, '[1, 10000]')
    refused(['bench', '--cvs'], None, 'did you mean --csv')
