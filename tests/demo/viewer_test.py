#!/usr/bin/env python3
"""The window draws what the command draws: viewer_test.py XVFB_RUN TSUYA_VIEW TSUYA.

Both render one scene at the window's size, the window on a virtual display; mean luminance must
agree within 2 %.
"""

import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

SCENE = ['straight-brown', 'strands=400', 'size=960x720', 'supersample=1']


def mean(path):
    """Mean of the bytes of an 8-bit RGB(A) PNG's colour channels."""
    data = pathlib.Path(path).read_bytes()
    at, body, header = 8, b'', None
    while at < len(data):
        size, kind = struct.unpack('>I4s', data[at:at + 8])
        chunk = data[at + 8:at + 8 + size]
        if kind == b'IHDR':
            header = struct.unpack('>IIBBBBB', chunk)
        if kind == b'IDAT':
            body += chunk
        at += size + 12
    width, height, channels = header[0], header[1], {2: 3, 6: 4}[header[3]]
    raw, pitch = zlib.decompress(body), width * channels
    last, total = bytearray(pitch), 0
    for y in range(height):
        kind, row = raw[y * (pitch + 1)], bytearray(raw[y * (pitch + 1) + 1:(y + 1) * (pitch + 1)])
        for i in range(pitch):
            a = row[i - channels] if i >= channels else 0
            b, c = last[i], last[i - channels] if i >= channels else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        total += sum(sum(row[k::channels]) for k in range(3))
        last = row
    return total / (width * height * 3)


def main():
    xvfb_run, viewer, tsuya = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        window, picture = os.path.join(folder, 'window.png'), os.path.join(folder, 'picture.png')
        subprocess.run([xvfb_run, '-a', viewer, *SCENE, '--frames', '2', '--screenshot', window],
                       check=True)
        subprocess.run([tsuya, 'render', *SCENE, '-o', picture], check=True)
        a, b = mean(window), mean(picture)
    print(f'window {a:.3f}, command {b:.3f}')
    sys.exit(abs(a / b - 1) > 0.02)


if __name__ == '__main__':
    main()
