#!/usr/bin/env python3
"""Files stay small, finished and portable. usage: size.py ROOT

Over 500 lines a file's first comment says why ("Over 500 lines: ..."). No note of unfinished work,
no path of one machine, no stray blanks."""
import pathlib
import re
import sys

SUFFIXES = {'.c', '.h', '.cpp', '.inc', '.in', '.glsl', '.py', '.build', '.txt', '.md', '.map', '.supp'}
BARE = {'run', 'LICENSE'}
FOLDERS = ('runtime', 'glsl', 'demo', 'tests', '.ci')
LIMIT = 500
# Spelled so that this file does not find itself.
UNFINISHED = re.compile(r'\b(TO' r'DO|FIX' r'ME|X' r'XX|HA' r'CK)\b|for' r' now\b')
MACHINE = re.compile(r'(?<![\w.$])/(home|root|Users|work|mnt|media|tmp|opt)' r'/\w|[A-Z]:\\\\?Users')

root = pathlib.Path(sys.argv[1]).resolve()
errors, checked = [], 0


def first_comment(text):
    lines = []
    for line in text.splitlines():
        if not re.match(r'\s*(//|#|\*|/\*|"""|$)', line) and not (lines and lines[0].startswith('"""')):
            break
        lines.append(line)
    return '\n'.join(lines)


def check(path):
    name = path.relative_to(root)
    data = path.read_bytes()
    try:
        text = data.decode('utf-8')
    except UnicodeDecodeError:
        errors.append(f'{name}: not UTF-8')
        return
    lines = text.splitlines()
    if len(lines) > LIMIT and f'Over {LIMIT} lines:' not in first_comment(text):
        errors.append(f'{name}: {len(lines)} lines and no "Over {LIMIT} lines: reason" at its head')
    if '\r' in text or text and not text.endswith('\n'):
        errors.append(f'{name}: a carriage return, or no line end at the end')
    for number, line in enumerate(lines, 1):
        where = f'{name}:{number}'
        if UNFINISHED.search(line):
            errors.append(f'{where}: unfinished work')
        if MACHINE.search(line):
            errors.append(f'{where}: a path of one machine')
        if '\t' in line and path.suffix != '.txt':
            errors.append(f'{where}: a tab')
        if line != line.rstrip():
            errors.append(f'{where}: blanks at the end')


files = [root / n for n in ('meson.build', 'README.md', 'CHANGES.md') if (root / n).is_file()]
for folder in FOLDERS:
    if (root / folder).is_dir():
        files += [p for p in sorted((root / folder).rglob('*')) if p.is_file()
                  and (p.suffix in SUFFIXES or p.name in BARE) and '__pycache__' not in p.parts]
for p in files:
    check(p)
    checked += 1
print(f'{checked} files')
if checked < 50:
    errors.append('too few files were found: is the argument the root of the project?')
sys.exit('\n'.join(errors) if errors else 0)
