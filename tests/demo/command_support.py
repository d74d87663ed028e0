"""Running the `tsuya` command and saying what was wrong: shared by the cases of command_test.py."""

import json
import os
import subprocess

COMMAND = ''
CASES = []


def case(function):
    CASES.append(function)
    return function


class Wrong(Exception):
    """A case's expectation and what came instead."""


def expect(good, what):
    if not good:
        raise Wrong(what)


def use(command):
    """The command that run() starts."""
    global COMMAND
    COMMAND = os.path.abspath(command)


def run(*words, text=None, env=None):
    data = text.encode() if isinstance(text, str) else text
    return subprocess.run([COMMAND, *words], input=data if data is not None else b'',
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
                          env=dict(os.environ, **env) if env else None, check=False)


def output(*words, **more):
    done = run(*words, **more)
    expect(done.returncode == 0, f'{words}: exit {done.returncode}: {done.stderr.decode()}')
    return done.stdout.decode()


def refused(words, text, *parts):
    """Exit 2, nothing on stdout, one line on stderr that holds every part."""
    done = run(*words, text=text)
    said = done.stderr.decode()
    expect(done.returncode == 2, f'{words} {text!r}: exit {done.returncode}, not 2: {said}')
    expect(done.stdout == b'', f'{words} {text!r}: something on stdout: {done.stdout[:80]}')
    expect(said.count('\n') == 1, f'{words} {text!r}: not one line on stderr: {said}')
    for part in parts:
        expect(part in said, f'{words} {text!r}: no "{part}" in: {said}')


def table(text):
    rows = [line.split(',') for line in text.splitlines() if not line.startswith('#')]
    return rows[0], rows[1:]


def models(*kinds):
    """Records of the models that shade, or of one kind: fibre, surface, shadow."""
    return [m for m in json.loads(output('models', '--json'))['models']
            if m['kind'] in (kinds or ('fibre', 'surface'))]


AZIMUTHAL = ('eval', 'hair-azimuthal', '--on', 'reference')
