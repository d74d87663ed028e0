#!/usr/bin/env python3
"""`tsuya reference` from outside: what it refuses, what it writes, how it goes on.

    command_test.py /path/to/tsuya

Prints one line a case; exits 1 when one fails.
"""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'demo'))
from command_support import CASES, Wrong, case, expect, output, refused, use  # noqa: E402

SMALL = ['straight-brown', 'strands=1000', 'width_scale=6', '--size', '16x16']


def trace(path, *options):
    return output('reference', *SMALL, '-o', str(path), *options)


@case
def help_names_every_option():
    said = output('reference', '--help')
    for option in ('-o', '--samples', '--error', '--seed', '--threads', '--resume', '--size'):
        expect(option in said, f'{option} is not in the help')
    expect('usage: tsuya reference' in said and 'examples:' in said, said)
    expect('reference' in output('--help'), 'tsuya --help does not name it')


@case
def bad_input_names_field_and_range():
    with tempfile.TemporaryDirectory() as folder:
        to = ['-o', folder + '/x.exr']
        for option, value, allowed in (('--samples', '0', '[1, 10000000]'),
                                       ('--samples', '1.5', 'whole'),
                                       ('--samples', 'many', '[1, 10000000]'),
                                       ('--error', '0', '[0.0001, 1]'),
                                       ('--error', 'nan', '[0.0001, 1]'),
                                       ('--seed', '-1', '[0, 4294967295]'),
                                       ('--threads', '0', '[1, 1024]')):
            refused(['reference', *SMALL, *to, option, value], None, option, allowed)
        refused(['reference', *SMALL], None, '-o FILE.exr is missing')
        refused(['reference', *SMALL, '-o', folder + '/x.png'], None, 'x.png', '.exr')
        refused(['reference', *to], None, 'no scene is given')
        refused(['reference', 'no-such-scene', *to], None, 'no-such-scene')
        refused(['reference', 'straight-brown', 'dome=-1', *to], None, 'dome', '[0, 10000]')
        refused(['reference', 'straight-brown', 'model=kajiya_kay', *to], None, 'kajiya_kay',
                'marschner')
        refused(['reference', *SMALL, *to, '--sample', '4'], None, 'did you mean --samples')
        expect(not list(pathlib.Path(folder).iterdir()), 'a refused command left files')


@case
def seed_and_nothing_else_changes_the_picture():
    with tempfile.TemporaryDirectory() as folder:
        names = {}
        for name, options in (('one', ['--threads', '1']), ('three', ['--threads', '3']),
                              ('other', ['--seed', '9'])):
            path = pathlib.Path(folder) / (name + '.exr')
            trace(path, '--samples', '12', *options)
            names[name] = path.read_bytes()
        expect(names['one'] == names['three'], 'threads change the picture')
        expect(names['one'] != names['other'], 'the seed does not change the picture')


@case
def resumes_to_the_same_picture():
    with tempfile.TemporaryDirectory() as folder:
        whole, parts = pathlib.Path(folder) / 'whole.exr', pathlib.Path(folder) / 'parts.exr'
        trace(whole, '--samples', '20')
        trace(parts, '--samples', '7')
        expect(parts.read_bytes() != whole.read_bytes(), '7 samples are 20')
        trace(parts, '--samples', '20', '--resume')
        expect(parts.read_bytes() == whole.read_bytes(), 'going on is another picture')
        refused(['reference', *SMALL, 'dome=2', '-o', str(parts), '--resume'], None,
                'parts.exr.state', 'another scene')
        refused(['reference', *SMALL, '--seed', '2', '-o', str(parts), '--resume'], None, '--seed')
        state = pathlib.Path(str(parts) + '.state')
        kept = bytearray(state.read_bytes())
        kept[len(kept) // 2] ^= 1
        state.write_bytes(kept)
        refused(['reference', *SMALL, '-o', str(parts), '--resume'], None, 'checksum')
        state.write_bytes(b'TSUYA')
        refused(['reference', *SMALL, '-o', str(parts), '--resume'], None, 'no state')


@case
def other_surroundings_of_the_same_name_are_another_scene():
    with tempfile.TemporaryDirectory() as folder:
        sky, picture = folder + '/sky.exr', folder + '/picture.exr'
        scene = [*SMALL, 'environment=file:' + sky, 'dome=0']
        output('render', *SMALL[:3], 'size=32x16', '-o', sky)
        output('reference', *scene, '--samples', '4', '-o', picture)
        output('reference', *scene, '--samples', '8', '-o', picture, '--resume')
        output('render', *SMALL[:3], 'size=32x16', 'background=1,0,0', '-o', sky)
        refused(['reference', *scene, '-o', picture, '--resume'], None, 'another scene')


@case
def goes_on_after_an_interruption():
    with tempfile.TemporaryDirectory() as folder:
        whole, parts = pathlib.Path(folder) / 'whole.exr', pathlib.Path(folder) / 'parts.exr'
        command = [COMMAND, 'reference', *SMALL, '-o', str(parts), '--samples', '4000']
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
            state = pathlib.Path(str(parts) + '.state')
            while not state.exists() and running.poll() is None:
                time.sleep(0.01)
            time.sleep(0.3)
            running.send_signal(signal.SIGINT)
            said = running.communicate()[1].decode()
        expect(running.returncode == 1, f'exit {running.returncode}: {said}')
        expect('--resume' in said and not parts.exists(), said)
        trace(parts, '--samples', '4000', '--resume')
        trace(whole, '--samples', '4000')
        expect(parts.read_bytes() == whole.read_bytes(), 'going on is another picture')


@case
def stops_at_the_error_that_is_asked():
    with tempfile.TemporaryDirectory() as folder:
        said = trace(pathlib.Path(folder) / 'x.exr', '--error', '0.2')
        lines = dict(line.split(None, 2)[:2] for line in said.splitlines() if line.split()[1:])
        expect(16 <= int(lines['samples']) < 65536, said)
        error = [line for line in said.splitlines() if line.startswith('standard error')]
        expect(0.1 < float(error[0].split()[2]) <= 0.2, said)


@case
def unwritable_place_fails_before_the_work():
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([COMMAND, 'reference', *SMALL, '-o', folder + '/no/x.exr',
                               '--samples', '1000000'], capture_output=True, check=False,
                              timeout=60)
        expect(done.returncode == 1 and b'no/x.exr' in done.stderr, done.stderr.decode())


def main():
    global COMMAND
    if len(sys.argv) != 2:
        print('usage: command_test.py /path/to/tsuya', file=sys.stderr)
        return 2
    COMMAND = str(pathlib.Path(sys.argv[1]).resolve())
    use(COMMAND)
    failed = 0
    for function in CASES:
        name = function.__name__.replace('_', ' ')
        try:
            function()
            print('pass', name, flush=True)
        except (Wrong, subprocess.SubprocessError, ValueError, KeyError, OSError) as why:
            failed += 1
            print('FAIL', name + ':', why, flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
