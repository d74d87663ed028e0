#!/usr/bin/env python3
"""One list of exported names, four times. usage: names.py ROOT LIBRARY.so

The names that the library exports, those of runtime/tsuya.map, those declared TSU_API in the public
headers and those of tests/abi/symbols.txt are the same. Macros of public headers begin TSU_. Every
public struct has its layout in tests/abi. The library calls nothing that prints, ends the process
or knows a locale."""
import pathlib
import re
import subprocess
import sys

root, library = pathlib.Path(sys.argv[1]), sys.argv[2]
errors = []


def nm(*options):
    out = subprocess.run(['nm', '-D', *options, library], check=True, capture_output=True, text=True)
    return [line.split() for line in out.stdout.splitlines()]


exported = set()
for fields in nm('--defined-only'):
    kind, name = fields[-2], fields[-1].split('@')[0]
    if kind == 'A' and name.startswith('TSUYA_'):
        continue  # a version node
    if kind != 'T':
        errors.append(f'{name} is exported and is not a function ({kind})')
    exported.add(name)

mapped = set()
for name in re.findall(r'^\s*([\w*?]+);', (root / 'runtime/tsuya.map').read_text('utf-8'), re.M):
    if name != '*':
        mapped.add(name)
if '*' not in re.findall(r'local:\s*([*])', (root / 'runtime/tsuya.map').read_text('utf-8')):
    errors.append('runtime/tsuya.map does not hide the rest')

headers = sorted((root / 'runtime/include/tsuya').rglob('*.h'))
declared = set()
for path in headers:
    code = re.sub(r'//[^\n]*', '', path.read_text('utf-8'))
    for match in re.finditer(r'^TSU_API\s+([^;(]*?)(\w+)\s*\(', code, re.M):
        if match.group(2) in declared:
            errors.append(f'{path.name}: {match.group(2)} is declared twice')
        declared.add(match.group(2))
    for match in re.finditer(r'^\s*#\s*define\s+(\w+)(\()?', code, re.M):
        name, function = match.group(1), match.group(2)
        upper = re.fullmatch(r'TSU(YA)?_[A-Z0-9_]+', name)
        init = function and re.fullmatch(r'tsu_\w+_init', name)
        if not upper and not init:
            errors.append(f'{path.name}: the macro {name} has no prefix')
    for match in re.finditer(r'^typedef\s+[^;{]*?(\w+)\s*;|^\}\s*(\w+)\s*;', code, re.M):
        name = match.group(1) or match.group(2)
        if not name.startswith('tsu_') or name.endswith('_t'):
            errors.append(f'{path.name}: the type {name} is not named tsu_...')
    for body in re.findall(r'\benum\s*\w*\s*\{([^}]*)\}', code):
        for name in re.findall(r'(\w+)\s*(?:=[^,}]*)?(?:,|$)', body.strip()):
            if not name.startswith('TSU_'):
                errors.append(f'{path.name}: the constant {name} is not named TSU_...')
    if re.search(r'\b(bool|long)\b|^\s*(static\s+)?inline\b', code, re.M):
        errors.append(f'{path.name}: bool, long or inline in a public header')

# Every public struct and field is in tests/abi/layout.c, every header in tests/abi/meson.build.
layout = (root / 'tests/abi/layout.c').read_text('utf-8')
built = (root / 'tests/abi/meson.build').read_text('utf-8')
for path in headers:
    code = re.sub(r'//[^\n]*', '', path.read_text('utf-8'))
    for name, body in re.findall(r'typedef struct (\w+) \{(.*?)\} \1;', code, re.S):
        if f'SIZE({name},' not in layout:
            errors.append(f'tests/abi/layout.c has no size of {name}')
        for declaration in body.split(';'):
            for field in declaration.split(','):
                words = re.findall(r'\w+', field.split('[')[0])
                if words and f'AT({name}, {words[-1]},' not in layout:
                    errors.append(f'tests/abi/layout.c has no place of {name}.{words[-1]}')
    if path.parent.name == 'tsuya' and f"'{path.stem}'" not in built:
        errors.append(f'tests/abi/meson.build does not compile {path.name} alone')

listed = (root / 'tests/abi/symbols.txt').read_text('utf-8').split()
if listed != sorted(set(listed)):
    errors.append('tests/abi/symbols.txt is not sorted, or names one twice')
for what, names in (('runtime/tsuya.map', mapped), ('the public headers', declared),
                    ('tests/abi/symbols.txt', set(listed))):
    for name in sorted(exported - names):
        errors.append(f'{name} is exported and not in {what}')
    for name in sorted(names - exported):
        errors.append(f'{name} is in {what} and not exported')
for name in sorted(exported):
    if not name.startswith('tsu_') or name.startswith('tsu_i_'):
        errors.append(f'{name} is exported and is not a public name')

FORBIDDEN = re.compile(r'v?[fsd]?n?w?printf|puts|putchar|perror|abort|_?exit|strto[dfl]|ato[fil]|'
                       r'setlocale|localeconv|s?scanf|fopen|open|getenv|signal|raise|__errno_location|'
                       r'gl[A-Z]\w*|egl[A-Z]\w*|OSMesa\w*|pthread_\w+')
for fields in nm('--undefined-only'):
    name = fields[-1].split('@')[0]
    if FORBIDDEN.fullmatch(name):
        errors.append(f'the library calls {name}')

print(f'{len(exported)} names')
if not exported:
    errors.append('no exported name was found')
sys.exit('\n'.join(errors) if errors else 0)
