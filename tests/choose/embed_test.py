#!/usr/bin/env python3
"""A table that lacks something ends the build with a sentence that says what. embed_test.py CSV"""
import pathlib
import subprocess
import sys
import tempfile

EMBED = pathlib.Path(__file__).resolve().parents[2] / 'runtime' / 'choose' / 'embed.py'
errors = []


def embed(text):
    with tempfile.TemporaryDirectory() as folder:
        path, out = pathlib.Path(folder) / 'trade.csv', pathlib.Path(folder) / 'trade.c'
        path.write_text(text, encoding='utf-8')
        done = subprocess.run([sys.executable, EMBED, out, path], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, check=False)
        return done.returncode, done.stderr, out.read_text('utf-8') if out.is_file() else ''


def refuse(what, text, *parts):
    code, said, out = embed(text)
    if code == 0 or out or 'Traceback' in said or not all(part in said for part in parts):
        errors.append(f'{what}: exit {code}, wrote {len(out)} bytes and said: {said.strip()}')


def without(start):
    rest = [line for line in lines if not line.startswith(start)]
    if len(rest) == len(lines):
        errors.append(f'the table has no line {start}')
    return '\n'.join(rest) + '\n'


def row(start):
    return next(i for i, line in enumerate(lines) if line.startswith(start))


def changed(start, value):
    i = row(start)
    line = ','.join(lines[i].split(',')[:3] + [value])
    return '\n'.join(lines[:i] + [line] + lines[i + 1:]) + '\n'


table = pathlib.Path(sys.argv[1]).read_text('utf-8')
lines = table.splitlines()
code, said, text = embed(table)
if code or 'tsu_i_trade' not in text or said:
    errors.append(f'the table itself: exit {code}: {said}')
for start in ('exact,fit_rms,u*u*u,', 'marschner,fit_luminance,1,', 'plane_parallel,spread,rms,',
              'leaf,clocks,vega10,', 'unshadowed,samplers,,', 'leaf_body,error,transmitted,',
              '*,range,curl.max,', '*,margin,z,', 'exact,rms,dyed,', 'leaf_coarse,error,coat,'):
    refuse('a missing row', without(start), 'no row ' + start.rstrip(','))
refuse('no tier', without('kajiya_kay,'), 'no row kajiya_kay,')
refuse('no leaf', without('*,species,'), 'no row *,species,')
refuse('a missing lobe', without('*,lobe_share,trt/0.5,'), 'lobe_share', '0.5')
refuse('no provenance', without('#'), 'where the table comes from')
refuse('a row twice', table + lines[row('exact,clocks,navi21,')] + '\n', 'exact,clocks,navi21',
       'twice', f':{len(lines) + 1}:')
refuse('an unknown tier', table + 'none_such,clocks,navi21,1\n', 'no tier is called none_such')
refuse('an unknown row', table + 'exact,clocks,navi99,1\n', 'nothing reads row exact,clocks,navi99')
refuse('an unknown term', table + 'exact,fit_rms,q*q*q,1\n',
       'nothing reads row exact,fit_rms,q*q*q')
refuse('a word', changed('exact,fit_rms,u,', 'many'), 'exact,fit_rms,u = many is no number')
refuse('no number', changed('exact,fit_rms,u,', 'nan'), 'is no number')
refuse('infinity', changed('exact,clocks,navi21,', 'inf'), 'is no number')
refuse('a negative cost', changed('exact,clocks,navi21,', '-3'), 'is not above 0')
refuse('a negative spread', changed('exact,spread,rms,', '-0.1'), 'is below 0')
refuse('an empty range', changed('*,range,curl.min,', '2'), '*,range,curl is empty')
refuse('a short line', table + 'exact,clocks\n', '2 cells, expected tier,quantity,key,value')
sys.exit('\n'.join(errors) if errors else 0)
