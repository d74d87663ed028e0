#!/usr/bin/env python3
"""Who may include whom. usage: floors.py ROOT

A file may include its own floor or a lower one; siblings never meet. The table is the rule; the
rest reads #include lines."""
import pathlib
import re
import sys

# Folder of runtime/ -> what its files may include with quotes. A folder includes itself.
MODEL = ['models/model.h']
FLOORS = {
    'base': [],
    'optics': ['base/'],
    'models': [],
    'models/*': ['base/', 'optics/', 'models/model.h', 'models/values.h', 'models/fiber_values.h'],
    'bake': ['base/'] + MODEL,
    'shade': ['base/'] + MODEL,
    'hair_shadow': ['base/'] + MODEL,
    'light': ['base/'],
    'choose': ['base/'],
    'gl': ['base/'] + MODEL,
    'api': ['base/', 'optics/', 'bake/', 'shade/', 'hair_shadow/', 'light/', 'choose/',
            'models/'],
}
# A model that extends others builds on their private headers and calls their GLSL.
EXTENDS = {'dual_scattering': ['marschner'],
           'plane_parallel_hair': ['marschner', 'dual_scattering'],
           'leaf': ['leaf_body'],
           'leaf_coarse': ['leaf_body']}
LIBC = {'ctype.h', 'float.h', 'limits.h', 'math.h', 'stdarg.h', 'stddef.h', 'stdint.h', 'stdlib.h',
        'string.h'}
# Memory, files and output are the host's; only base speaks to it.
ALLOCATORS = re.compile(r'\b(malloc|calloc|realloc|free|printf|fprintf|sprintf|snprintf|fopen|abort|'
                        r'exit|strtod|setlocale)\s*\(')
# Folder of tests/ -> which private headers of runtime/ it may include.
TESTS = {
    'base': ['base/'],
    'optics': ['base/', 'optics/'],
    'models': ['base/', 'optics/', 'models/', 'api/'],
    'bake': ['base/', 'bake/', 'models/model.h'],
    'choose': ['choose/'],
    'shade': [],
    'api': [],
    'gl': ['base/', 'gl/', 'models/model.h'],
    'reference': ['optics/'],
    'bench': ['optics/'],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)

errors = []
checked = 0


def say(path, text):
    errors.append(f'{path.relative_to(root)}: {text}')


def includes(path):
    global checked
    checked += 1
    return [(m.group(1) == '"', m.group(2)) for m in INCLUDE.finditer(path.read_text('utf-8'))]


def allowed(name, prefixes):
    return any(name == p or p.endswith('/') and name.startswith(p) for p in prefixes)


def sources(folder, *suffixes):
    return sorted(p for p in folder.rglob('*') if p.is_file() and p.suffix in suffixes)


def check_public(path):
    text = re.sub(r'//[^\n]*', '', path.read_text('utf-8'))
    for quoted, name in includes(path):
        good = not quoted and (name.startswith('tsuya/') or name in ('stddef.h', 'stdint.h'))
        if not good:
            say(path, f'a public header includes {name}')
    if re.search(r'\bGL(enum|uint|int|sizei|float)\b|\bgl[A-Z]\w+\s*\(', text):
        say(path, 'a public header uses names of a GL header')


def check_runtime(path):
    parts = path.relative_to(root / 'runtime').parts[:-1]
    own = '/'.join(parts) + '/'
    key = '/'.join(parts) if len(parts) == 1 else parts[0] + '/*'
    if key not in FLOORS:
        say(path, f'runtime/{own} is no floor of the table')
        return
    extended = EXTENDS.get(parts[1], []) if key == 'models/*' else []
    for quoted, name in includes(path):
        if quoted and allowed(name, [f'models/{other}/' for other in extended]):
            continue
        if quoted and key == 'models' and name.startswith('models/') and name.count('/') == 1:
            continue
        if quoted and not (name.startswith(own) or allowed(name, FLOORS[key])):
            say(path, f'{key} includes {name}')
        if not quoted and not (name in LIBC or name.startswith('tsuya/')):
            say(path, f'the library includes <{name}>')
        if key == 'models/*' and name.startswith('tsuya/models/') \
                and pathlib.PurePath(name).stem not in [parts[1]] + extended:
            say(path, f'one model includes another: {name}')
    code = re.sub(r'//[^\n]*', '', path.read_text('utf-8'))
    if own != 'base/':
        for match in ALLOCATORS.finditer(code):
            say(path, f'calls {match.group(1)}(): memory, output and locale belong to base')


def check_demo(path):
    for quoted, name in includes(path):
        if name.startswith('tsuya/'):
            continue
        if any(allowed(name, [f + '/']) for f in ('base', 'optics', 'models', 'bake', 'shade', 'api')):
            say(path, f'the demo includes a private header of the library: {name}')
        if 'runtime/' in name:
            say(path, f'the demo reaches into runtime: {name}')


def check_test(path):
    folder = path.relative_to(root / 'tests').parts[0]
    for quoted, name in includes(path):
        private = quoted and (root / 'runtime' / name).is_file() and not (path.parent / name).is_file()
        if private and not allowed(name, TESTS.get(folder, [])):
            say(path, f'tests/{folder} includes {name}')
        if quoted and folder == 'host' and not (path.parent / name).is_file() \
                and name not in ('gl.h', 'offscreen.h', 'watch.h'):
            say(path, f'a host includes {name}')


def check_glsl():
    folders = {p.name for p in (root / 'runtime/models').iterdir() if p.is_dir()}
    for path in sources(root, '.glsl'):
        inside = path.relative_to(root).parts
        if any(part.startswith(('build', '.')) for part in inside):
            continue
        if inside[0] == 'demo':
            continue
        if inside[0] != 'glsl' or len(inside) != 3 or inside[1] not in folders | {'light', 'prelude'}:
            say(path, 'GLSL of the library lives in glsl/MODEL/, glsl/light/ and glsl/prelude/')
            continue
        code = re.sub(r'//[^\n]*', '', path.read_text('utf-8'))
        if re.search(r'#\s*(include|version|extension)|\bmain\s*\(|\bgl_|\bdiscard\b|\buniform\b', code):
            say(path, 'a snippet owns no stage and declares no resource')
        # A name may begin another one: leaf, leaf_body.
        longer = {f: ''.join(rf'(?!{g[len(f) + 1:]}_)' for g in folders if g.startswith(f + '_'))
                  for f in folders}
        own = [inside[1]] + EXTENDS.get(inside[1], [])
        code = code.replace(f'tsu_{path.stem}', '')  # what the file itself is called
        others = [f for f in folders
                  if f not in own and re.search(rf'\btsu_{f}_{longer[f]}', code)]
        if others:
            say(path, f'one model uses another: {others}')
    for folder in folders:
        if not (root / 'glsl' / folder).is_dir():
            errors.append(f'runtime/models/{folder} has no twin in glsl/')
        if not (root / 'runtime/include/tsuya/models' / (folder + '.h')).is_file():
            errors.append(f'runtime/models/{folder} has no public header')


root = pathlib.Path(sys.argv[1]).resolve()
for p in sources(root / 'runtime', '.c', '.h', '.inc'):
    if p.is_relative_to(root / 'runtime/include'):
        check_public(p)
    else:
        check_runtime(p)
for p in sources(root / 'demo', '.c', '.h', '.cpp'):
    check_demo(p)
for p in sources(root / 'tests', '.c', '.h', '.cpp'):
    check_test(p)
check_glsl()
print(f'{checked} files')
if checked < 20:
    errors.append('too few files were found: is the argument the root of the project?')
sys.exit('\n'.join(errors) if errors else 0)
