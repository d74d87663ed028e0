#!/usr/bin/env python3
"""What a stranger's build does with the library: package_test.py ROOT BUILD MESON

Installs the build below a folder of its own and compiles a host against it through pkg-config, shared
and static; then builds the project as a Meson subproject, where only the library may be built.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HOST = '''#include <tsuya/tsuya.h>
#include <stdio.h>
int main(void)
{
    tsu_context_desc desc;
    tsu_context *context;
    tsu_context_desc_init(&desc);
    if (tsu_context_create(&desc, &context) != TSU_OK)
        return 1;
    tsu_context_destroy(context);
    printf("%u %s\\n", tsu_model_count(), tsu_version() == TSU_VERSION ? "same" : "other");
    return 0;
}
'''
OUTER = '''project('outer', 'c', version: '1')
tsuya = dependency('tsuya', fallback: ['tsuya', 'tsuya_dep'])
executable('host', 'host.c', dependencies: tsuya)
'''


def run(*words, **more):
    done = subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False, **more)
    if done.returncode:
        sys.exit(f'{" ".join(map(str, words))} ended with {done.returncode}:\n{done.stdout}')
    return done.stdout


def check(what, text):
    if text.split() != [str(MODELS), 'same']:
        sys.exit(f'{what}: the host printed {text!r}')
    print('ok', what)


def installed(build, folder):
    run(MESON, 'install', '-C', build, '--no-rebuild', '--destdir', folder / 'root')
    pc = next((folder / 'root').rglob('tsuya.pc'))
    prefix = pc.parents[1] if pc.parent.name == 'pkgconfig' else pc.parent
    environment = dict(os.environ, PKG_CONFIG_PATH=str(pc.parent),
                       PKG_CONFIG_SYSROOT_DIR=str(folder / 'root'))
    source = folder / 'host.c'
    source.write_text(HOST, encoding='utf-8')
    flags = run('pkg-config', '--cflags', '--libs', 'tsuya', env=environment).split()
    run('cc', '-std=c11', '-Wall', '-Wextra', '-Wpedantic', '-Werror', source, '-o', folder / 'host',
        *flags)
    check('shared, through pkg-config',
          run(folder / 'host', env=dict(os.environ, LD_LIBRARY_PATH=str(prefix))))
    flags = run('pkg-config', '--static', '--cflags', '--libs', 'tsuya', env=environment).split()
    static = next((folder / 'root').rglob('libtsuya.a'))
    run('cc', '-std=c11', source, '-o', folder / 'host',
        *[static if f == '-ltsuya' else f for f in flags], '-lm')
    check('static', run(folder / 'host'))
    for header in (folder / 'root').rglob('*.h'):
        if header.parent.name not in ('tsuya', 'models'):
            sys.exit(f'{header} is installed outside of tsuya/')


def subproject(root, folder):
    outer = folder / 'outer'
    (outer / 'subprojects').mkdir(parents=True)
    (outer / 'subprojects' / 'tsuya').symlink_to(root)
    (outer / 'meson.build').write_text(OUTER, encoding='utf-8')
    (outer / 'host.c').write_text(HOST, encoding='utf-8')
    run(MESON, 'setup', outer / 'build', outer, '--wrap-mode=nodownload',
        env=dict(os.environ, PKG_CONFIG_LIBDIR='/nonexistent'))
    run('ninja', '-C', outer / 'build')
    check('subproject', run(outer / 'build' / 'host'))
    for name in ('tsuya', 'tsuya-view'):
        if (outer / 'build' / 'subprojects' / 'tsuya' / 'demo' / name).exists():
            sys.exit(f'the subproject builds {name} as well')


ROOT, BUILD, MESON, MODELS = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])
with tempfile.TemporaryDirectory() as place:
    installed(BUILD, pathlib.Path(place))
    subproject(pathlib.Path(ROOT).resolve(), pathlib.Path(place))
